// `promenade power`: how many people does a study need?
#include "analysis/power/power.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <ctime>
#include <map>

#include "analysis/power/rehearsal.h"
#include "analysis/power/resampling.h"
#include "app/commands.h"
#include "app/commands/power_report.h"
#include "app/print.h"
#include "app/registry.h"

namespace promenade::app {
namespace {

struct Options {
  std::string file;
  std::vector<std::string> pilots;
  analysis::PowerQuestion question;
  int studies = 0;  // 0: what suits the kind
  analysis::SelectionOptions selection;
  analysis::SmallestEffect effect;
  double noise = 1, learning = 0, fatigue = 0, aptitude = 0, taste = 0;
  std::vector<std::string> difficulty, preference;  // NAME=X
  bool json = false;
};

double number_or_throw(const std::string& option, const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc() && stop == end && std::abs(value) <= 1e6) return value;
  throw InputError("promenade power", option + " needs NAME=NUMBER, not \"" + text + "\"");
}

std::map<std::string, double> by_interface(const study::Study& study, const std::string& option,
                                           const std::vector<std::string>& given) {
  std::map<std::string, double> values;
  for (const std::string& text : given) {
    const std::size_t equals = text.rfind('=');
    if (equals == std::string::npos) number_or_throw(option, text + " ");
    const std::string name = text.substr(0, equals);
    const bool known = std::any_of(study.interfaces.begin(), study.interfaces.end(),
                                   [&name](const auto& one) { return one.name == name; });
    if (!known) {
      throw InputError("promenade power", option + ": the study has no interface \"" + name + "\"");
    }
    values[name] = number_or_throw(option, text.substr(equals + 1));
    if (option == "--difficulty" && values[name] < 0) {
      throw InputError("promenade power", option + " cannot be below 0");
    }
  }
  return values;
}

study::Tendencies tendencies_of(const Options& options, const study::Study& study) {
  study::Tendencies tendencies;
  tendencies.noise = options.noise;
  tendencies.learning = options.learning;
  tendencies.fatigue = options.fatigue;
  tendencies.aptitude = options.aptitude;
  tendencies.taste = options.taste;
  tendencies.difficulty = by_interface(study, "--difficulty", options.difficulty);
  tendencies.preference = by_interface(study, "--preference", options.preference);
  return tendencies;
}

void require_effect(const analysis::SmallestEffect& effect) {
  std::string missing;
  if (effect.effect == 0) missing += " --effect X (not 0)";
  if (effect.measure.empty()) missing += " --measure NAME";
  if (effect.task.empty()) missing += " --task NAME";
  if (!missing.empty()) {
    throw InputError("promenade power",
                     "with --from, state the smallest effect that would matter:" + missing);
  }
  if (effect.a.empty() != effect.b.empty() || (!effect.a.empty() && effect.a == effect.b)) {
    throw InputError("promenade power", "--a and --b name the two interfaces of a pair");
  }
}

// The people of the pilot who count.
analysis::Dataset pilot_of(const Options& options, const study::StudyBundle& bundle) {
  const analysis::Log log = analysis::read_log(options.pilots);
  const std::string& file = options.pilots.front();
  if (log.study != bundle.study.name) {
    throw InputError(file, "is of study \"" + log.study + "\", not of \"" + bundle.study.name +
                               "\"; take the pilot of this study");
  }
  if (log.sha256 != bundle.sha256) {
    print_note("the study has changed since the pilot; power is for what the pilot did");
  }
  analysis::Dataset pilot = make_dataset(log, select(log, options.selection));
  if (pilot.trials.empty()) {
    throw InputError(file,
                     "holds no finished trial of a finished session that counts; "
                     "--include-pilot and --include-simulated say who counts, too");
  }
  return pilot;
}

PowerReport by_resampling(const Options& options, const study::StudyBundle& bundle) {
  require_effect(options.effect);
  PowerReport report;
  const analysis::Dataset pilot = pilot_of(options, bundle);
  report.pilot_files = options.pilots;
  report.pilot_people = static_cast<int>(pilot.people.size());
  report.pilot_simulated = pilot.all_simulated;
  report.effect = options.effect;
  report.tables.push_back(
      resampled_power(pilot, options.pilots.front(), options.effect, options.question));
  return report;
}

PowerReport by_rehearsal(const Options& options, const study::StudyBundle& bundle) {
  if (options.effect.effect != 0 || !options.effect.a.empty() || !options.effect.b.empty()) {
    throw InputError("promenade power",
                     "--effect, --a and --b go with --from PILOT.db; simulated people differ by "
                     "--difficulty and --preference");
  }
  PowerReport report;
  analysis::Rehearsal rehearsal{&bundle, &interfaces(), tendencies_of(options, bundle.study)};
  if (!options.effect.task.empty()) rehearsal.tasks = {options.effect.task};
  if (!options.effect.measure.empty()) rehearsal.measures = {options.effect.measure};
  report.tables = rehearsed_power(rehearsal, options.question);
  report.tendencies = rehearsal.tendencies;
  return report;
}

void run(Options options) {
  const study::StudyBundle bundle = study::load_study(options.file, interfaces());
  print_problems(bundle.warnings);
  analysis::PowerQuestion& question = options.question;
  const bool resampling = !options.pilots.empty();
  question.studies = options.studies > 0 ? options.studies : resampling ? 10'000 : 200;
  std::sort(question.participants.begin(), question.participants.end());
  question.participants.erase(
      std::unique(question.participants.begin(), question.participants.end()),
      question.participants.end());
  question.progress = [](const std::string& what, int done, int count) {
    show_progress(what, done, count);
    return !interrupted();
  };
  interrupted();
  PowerReport report = resampling ? by_resampling(options, bundle) : by_rehearsal(options, bundle);
  report.question = question;
  report.study = bundle.study.name;
  report.sha256 = bundle.sha256;
  report.round = study::round_of_design(bundle.study);
  // Not in the output itself, which is the same every time.
  print_note(fmt::format("took {:.1f} seconds of the processor, all threads together",
                         static_cast<double>(std::clock()) / CLOCKS_PER_SEC));
  if (options.json) {
    print_json(power_json(report));
  } else {
    print_text(power_text(report));
  }
}

void add_pilot_options(Command command, Options& options) {
  command.add_option("--from", options.pilots, "resample the people of these databases")
      .group("A pilot");
  command
      .add_option("--effect", options.effect.effect,
                  "the smallest difference that would matter, in metres, seconds or points")
      .range(-1e6, 1e6)
      .group("A pilot");
  command.add_option("--a", options.effect.a, "the pair that differs; without it each in turn")
      .group("A pilot");
  command.add_option("--b", options.effect.b, "its other interface").group("A pilot");
  command.add_flag("--include-pilot", options.selection.include_pilot, "pilot sessions count")
      .group("A pilot");
  command
      .add_flag("--include-simulated", options.selection.include_simulated,
                "simulated people count")
      .group("A pilot");
  command
      .add_option("--exclude", options.selection.exclude_file,
                  "CSV of people to leave out, as for a report")
      .group("A pilot");
}

void add_rehearsal_options(Command command, Options& options) {
  const char* group = "A rehearsal with simulated people (without --from)";
  command.add_option("--noise", options.noise, "factor of what they misjudge (1)")
      .range(0.0, 100.0)
      .group(group);
  command.add_option("--learning", options.learning, "share of it that each trial takes away (0)")
      .range(0.0, 1.0)
      .group(group);
  command
      .add_option("--fatigue", options.fatigue,
                  "share by which actions take longer after each ten minutes (0)")
      .range(0.0, 100.0)
      .group(group);
  command
      .add_option("--difficulty", options.difficulty,
                  "NAME=X: factor of what they misjudge with an interface (1)")
      .group(group);
  command
      .add_option("--preference", options.preference,
                  "NAME=X: added to ratings of an interface, as a share of the scale (0)")
      .group(group);
  command
      .add_option("--aptitude", options.aptitude,
                  "how much people differ in what suits them: s.d. of the logarithm of the factor "
                  "(0)")
      .range(0.0, 10.0)
      .group(group);
  command
      .add_option("--taste", options.taste,
                  "standard deviation between people of their own preferences (0)")
      .range(0.0, 10.0)
      .group(group);
}

}  // namespace

void add_power_command(Command program) {
  auto options = std::make_shared<Options>();
  Command command = program.add_subcommand(
      "power", "How many people a study needs: from a pilot, or a rehearsal with simulated people");
  command.add_option("study", options->file, "the study file (.toml or .study)").required();
  command
      .add_option("--participants", options->question.participants,
                  "numbers of participants: 6,10,13,20")
      .required()
      .delimiter(',')
      .range(1, 1000);
  command
      .add_option("--studies", options->studies,
                  "drawn of each size (10000 from a pilot, 200 rehearsed)")
      .range(1, 1'000'000);
  command.add_option("--seed", options->question.seed, "of everything random (1)")
      .range(std::int64_t{0}, std::int64_t{INT64_MAX});
  command.add_option("--alpha", options->question.alpha, "level of the test (0.05)")
      .range(1e-6, 0.5);
  command.add_option("--task", options->effect.task, "one task; a rehearsal shows all without it");
  command.add_option("--measure", options->effect.measure,
                     "one measure; a rehearsal shows d_final and time_s without it");
  command
      .add_option("--jobs", options->question.threads,
                  "threads; the result does not depend on them")
      .range(1, 256);
  command.add_flag("--json", options->json, "one JSON document on stdout");
  add_pilot_options(command, *options);
  add_rehearsal_options(command, *options);
  command.callback([options] { run(*options); });
}

}  // namespace promenade::app
