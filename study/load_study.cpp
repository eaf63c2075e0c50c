#include "study/load_study.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "motion/builtin.h"
#include "motion/files.h"
#include "motion/set_file.h"
#include "study/adjective_model.h"
#include "study/embedded.h"
#include "study/identity.h"
#include "study/impressions.h"
#include "study/pack.h"
#include "study/plan.h"
#include "study/prereg_seal.h"
#include "study/ratings_csv.h"
#include "study/simulated_raters.h"
#include "study/stimulus.h"
#include "study/study_parts.h"

namespace promenade::study {
namespace {

constexpr std::string_view configs = "configs/";
constexpr std::string_view builtin_prefix = "builtin:";

bool is_builtin(const std::string& name) { return name.rfind(builtin_prefix, 0) == 0; }

std::optional<std::string> simulated_ratings_in(const std::string& path) {
  for (const char* set : {"A", "B", "N"}) {
    if (path != simulated_ratings_path(set)) continue;
    if (const auto table = simulated_ratings(set)) return ratings_csv(*table);
  }
  return std::nullopt;
}

// Of a file that comes with the program, or is made by it.
std::string builtin_content(const std::string& name) {
  const std::string path = name.substr(builtin_prefix.size());
  if (const auto text = embedded_file(path)) return std::string(*text);
  if (auto ratings = simulated_ratings_in(path)) return std::move(*ratings);
  throw InputError(name, "does not come with this version of Promenade");
}

std::string text_of(const std::string& file) {
  std::error_code ignored;
  const bool on_disk = std::filesystem::exists(file, ignored);
  if (!on_disk && file.rfind(configs, 0) == 0) {
    if (const auto text = embedded_file(std::string_view(file).substr(configs.size()))) {
      return std::string(*text);
    }
  }
  return read_file(file);
}

// The set that the study names, or nothing and a problem at the place of its name.
std::optional<motion::MotionSet> read_set(const TomlTable& root, const std::string& name,
                                          const SetLoader& load_set) {
  const std::string folder = std::filesystem::path(root.reader().file()).parent_path().string();
  try {
    return load_set(name, folder);
  } catch (const InputError& error) {
    const TomlTable section = root.table("study").value_or(root);
    const Problem& first = error.problems().front();
    section.error("set", "cannot use the motion set \"" + name + "\": " + first.message);
    for (const Problem& problem : error.problems()) {
      if (problem.line > 0) root.reader().add({problem});
    }
    return std::nullopt;
  }
}

// Or leaves it to the default; not where the line that did was left out.
bool names_its_set(const TomlTable& root) {
  const auto section = root.table("study");
  return root.reader().whole() || (section && section->has("set"));
}

// In the order of the set; ratings of other motions keep their own, and whoever uses them says
// so once.
RatingsTable ratings_in(const std::string& file, const std::string& text,
                        const motion::MotionSet& set) {
  try {
    return read_ratings_csv(file, text, motion::names_of(set));
  } catch (const InputError&) {
    return read_ratings_csv(file, text, {});
  }
}

// Made once, and only when an interface asks: of ratings by simulated raters, which are part
// of the study from then on.
std::shared_ptr<const AdjectiveModel> adjectives_of(StudyFiles& files, StudyBundle& bundle) {
  const auto builtin = motion::builtin_name(bundle.study.set);
  if (bundle.adjectives || !builtin) return bundle.adjectives;
  const std::string path = simulated_ratings_path(*builtin);
  RatingsTable table = ratings_in(builtin_path(path), files.read_builtin(path), bundle.space.set);
  const std::string source = describe(RaterOptions{.raters = table.raters});
  bundle.adjectives =
      std::make_shared<const AdjectiveModel>(make_adjective_model(std::move(table), source));
  return bundle.adjectives;
}

StudyTexts texts_of_languages(StudyFiles& files, const std::vector<std::string>& languages) {
  StudyTexts texts;
  for (const std::string& language : languages) {
    const std::string path = "languages/" + language + ".toml";
    texts.emplace(language, load_texts(language, builtin_path(path), files.read_builtin(path)));
  }
  return texts;
}

// What nobody may take for people's opinion.
void warn_of_simulated_raters(const TomlTable& root, const StudyBundle& bundle) {
  if (!bundle.adjectives || !bundle.adjectives->simulated()) return;
  const TomlTable section = root.table("study").value_or(root);
  section.warning(section.has("ratings") ? "ratings" : "set",
                  "the adjectives come from simulated raters (" + bundle.adjectives->source + ")");
}

void put(std::string& bytes, std::string_view part) {
  bytes += std::to_string(part.size());
  bytes += ':';
  bytes += part;
}

// What was drawn, and what the first participant gets: another program may draw otherwise. To
// six places, so that the last bits of another machine make no other study.
void put_draws(const Study& study, std::string& bytes) {
  for (std::size_t t = 0; t < study.tasks.size(); ++t) {
    for (const auto* targets : {&study.tasks[t].targets, &study.tasks[t].practice}) {
      for (const Target& target : *targets) {
        if (target.stream.empty()) continue;
        put(bytes, target.name);
        const Eigen::VectorXd weights =
            target.draw ? drawn_target(study, static_cast<int>(t), target, 0) : *target.weights;
        for (const double weight : weights) put(bytes, fmt::format("{:.6f}", weight));
      }
    }
  }
}

// Which walks were found: another program may search otherwise.
void put_walks(const Study& study, std::string& bytes) {
  for (const auto& stimulus : study.stimuli) {
    put(bytes, stimulus->name);
    for (const int edge : stimulus->edges) put(bytes, std::to_string(edge));
  }
}

}  // namespace

Eigen::VectorXd start_weights(const motion::MotionSpace& space) {
  return Eigen::VectorXd::Constant(space.set.size(), 1.0 / space.set.size());
}

std::string study_hash(const StudyBundle& bundle, const InterfaceRegistry& registry) {
  std::string bytes;
  put(bytes, bundle.config_text);
  put(bytes, bundle.set_sha256);
  put(bytes, std::to_string(bundle.parts.size()));
  for (const StudyPart& part : bundle.parts) {
    put(bytes, part.path);
    put(bytes, part.content);
  }
  for (const InterfaceUse& use : bundle.study.interfaces) {
    const InterfaceType* type = registry.find(use.type);
    put(bytes, type->name);
    put(bytes, type->sentence);
    // With the standards that the study does not say: they may change.
    for (const auto& [name, value] : use.parameters) {
      put(bytes, name);
      put(bytes, to_text(value));
    }
  }
  put_draws(bundle.study, bytes);
  put_walks(bundle.study, bytes);
  return sha256_hex(bytes);
}

std::string builtin_path(std::string_view path) {
  return std::string(builtin_prefix) + std::string(path);
}

std::string simulated_ratings_path(std::string_view builtin_set) {
  return "ratings/" + std::string(builtin_set) + ".csv";
}

std::string load_file(const std::string& name, const std::string& folder) {
  if (is_builtin(name)) return builtin_content(name);
  return text_of((std::filesystem::path(folder) / name).string());
}

StudyBundle read_study(const std::string& file, std::string text, const InterfaceRegistry& registry,
                       const SetLoader& load_set, const FileLoader& read, bool frozen) {
  TomlReader reader(file, text);
  if (!reader.parsed()) reader.finish();
  const TomlTable root = reader.root();
  StudyBundle bundle;
  Study& study = bundle.study;
  read_study_section(root, study);
  read_display(root, study);
  read_breaks(root, study);
  read_practice(root, study);
  read_safety(root, study);
  StudyFiles files(std::filesystem::path(file).parent_path().string(), read, frozen);
  read_prereg_file(root, text, files);
  bundle.texts = texts_of_languages(files, study.languages);
  std::optional<motion::MotionSet> set;
  if (names_its_set(root)) set = read_set(root, study.set, load_set);
  if (set) {
    bundle.space = motion::make_motion_space(std::move(*set));
    bundle.bank = motion::make_pose_bank(bundle.space);
    bundle.coverage = make_coverage_map(bundle.space);
    read_ratings_file(root, files, bundle);
  }
  bool asked = false;
  const InterfaceResources resources{bundle.space, [&bundle, &files, &asked] {
                                       asked = true;
                                       return adjectives_of(files, bundle);
                                     }};
  study.interfaces = read_interfaces(root, registry, set ? &resources : nullptr);
  InstrumentShelf instruments(files, study, bundle.texts);
  const StudyContext context{
      registry, study,        set ? &bundle.space : nullptr, instruments, bundle.texts,
      files,    &bundle.bank, resources.adjectives};
  study.stimuli = read_stimuli(root, context);
  study.tasks = read_tasks(root, context);
  if (asked) warn_of_simulated_raters(root, bundle);
  read_questionnaires(root, instruments, study);
  if (reader.ok()) warn_of_stimuli(root, bundle.space.set, study);
  if (reader.ok()) warn_of_numbers(root, study);
  bundle.impressions = std::make_shared<const Impressions>();
  bundle.warnings = reader.finish();
  bundle.parts = files.parts();
  bundle.file = file;
  bundle.config_text = std::move(text);
  bundle.set_bytes = motion::to_bytes(bundle.space.set);
  bundle.set_sha256 = sha256_hex(bundle.set_bytes);
  bundle.sha256 = study_hash(bundle, registry);
  return bundle;
}

StudyBundle read_frozen_study(const std::string& file, const FrozenStudy& frozen,
                              const InterfaceRegistry& registry) {
  const auto part = [&](const std::string& name, const std::string& folder) {
    for (const StudyPart& one : frozen.parts) {
      if (one.path == name) return one.content;
    }
    if (is_builtin(name)) return load_file(name, folder);
    throw InputError(file, "does not hold \"" + name + "\", which the study names");
  };
  const auto set = [&](const std::string&, const std::string&) {
    return motion::from_bytes(frozen.set_bytes, file);
  };
  StudyBundle bundle = read_study(file, frozen.config_text, registry, set, part, true);
  // As they were frozen, whatever else this program would take or write.
  bundle.parts = frozen.parts;
  bundle.set_bytes = frozen.set_bytes;
  bundle.set_sha256 = sha256_hex(bundle.set_bytes);
  bundle.sha256 = study_hash(bundle, registry);
  return bundle;
}

StudyBundle load_unsealed_study(const std::string& file, const InterfaceRegistry& registry) {
  std::string text = text_of(file);
  if (!is_packed(text)) return read_study(file, without_seal(text), registry, load_motion_set);
  FrozenStudy frozen = read_pack(text, file).study;
  const std::string document = prereg_file_in(frozen.config_text);
  frozen.config_text = without_seal(frozen.config_text);
  std::erase_if(frozen.parts, [&](const StudyPart& part) { return part.path == document; });
  return read_frozen_study(file, frozen, registry);
}

StudyBundle load_study(const std::string& file, const InterfaceRegistry& registry) {
  std::string text = text_of(file);
  if (is_packed(text)) return unpack_study(text, file, registry);
  return read_study(file, std::move(text), registry, load_motion_set);
}

}  // namespace promenade::study
