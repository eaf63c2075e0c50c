#include "analysis/results.h"

#include <algorithm>

#include "analysis/format.h"
#include "analysis/made.h"
#include "analysis/outcomes.h"
#include "motion/problem.h"
#include "study/adjective_model.h"
#include "study/migrate.h"
#include "study/outline.h"
#include "study/sqlite.h"
#include "study/stored_study.h"

namespace promenade::analysis {
namespace {

// Why there is nothing, and what to do about it.
std::string nothing_to_report(const Selection& selection) {
  std::string sentence = "holds no finished trial of a finished session that counts";
  if (selection.left_out_simulated > 0) {
    sentence += "; " +
                count_of(selection.left_out_simulated, "simulated participant is",
                         "simulated participants are") +
                " left out, add --include-simulated to report them";
  }
  if (selection.left_out_pilot > 0) {
    sentence +=
        "; " +
        count_of(selection.left_out_pilot, "pilot participant is", "pilot participants are") +
        " left out, add --include-pilot to report them";
  }
  const int excluded = selection.count(Disposition::excluded);
  if (excluded > 0) sentence += "; " + count_of(excluded, "person is", "people are") + " excluded";
  return sentence;
}

std::optional<AdjectiveSource> adjectives_of(const study::StudyBundle* bundle) {
  if (bundle == nullptr || !bundle->adjectives) return std::nullopt;
  const study::AdjectiveModel& model = *bundle->adjectives;
  return AdjectiveSource{model.source, model.table.raters, model.simulated()};
}

// What rate tasks leave: pages about a walk that nobody made with an interface.
int count_rated(const std::vector<FilledPage>& pages) {
  const auto is_rated = [](const FilledPage& page) {
    return page.interface.empty() && !page.task.empty() && !page.target.empty();
  };
  return static_cast<int>(std::count_if(pages.begin(), pages.end(), is_rated));
}

}  // namespace

std::vector<const Comparison*> Results::pairs(int measure, int task) const {
  std::vector<const Comparison*> found;
  for (const Comparison& one : comparisons) {
    const bool wanted = one.measure == measure && one.task == task;
    if (wanted && one.pooling == Pooling::participants) found.push_back(&one);
  }
  return found;
}

std::vector<const Summary*> Results::summaries_of(int measure, int task) const {
  std::vector<const Summary*> found;
  for (const Summary& one : summaries) {
    if (one.measure == measure && one.task == task) found.push_back(&one);
  }
  return found;
}

Results compute_results(const std::vector<std::string>& databases, const SelectionOptions& options,
                        const Progress& progress, const study::InterfaceRegistry* registry) {
  Results results;
  results.log = read_log(databases);
  results.options = options;
  results.selection = select(results.log, options);
  results.data = make_dataset(results.log, results.selection);
  const Questionnaires filled = read_questionnaires(results.log, results.selection);
  results.rated_walks = count_rated(filled.pages);
  if (results.data.trials.empty() && results.rated_walks == 0) {
    throw InputError(listed(databases), nothing_to_report(results.selection));
  }
  std::optional<study::StudyBundle> stored;
  if (registry) {
    study::Database database = study::open_log(databases[0]);
    stored = study::read_newest_study(database, *registry);
    const study::StudyBundle* bundle = stored ? &*stored : nullptr;
    results.reachability = find_reachable(bundle, *registry);
    add_regret(results.reachability, results.data);
    add_measures_of_made(results.log, bundle, results.data);
    add_rated_quality(options, results.log, bundle, results.data);
    results.adjectives = adjectives_of(bundle);
    results.map_times = map_times(results.log, results.data, bundle);
  }
  results.comparisons = compare_all(results.data, progress);
  results.failures = failure_ratios(results.data);
  results.summaries = summaries(results.data);
  results.flow = flow_of(results.log, results.selection);
  results.quality = quality_of(results.log, results.selection, results.data);
  results.ratings = rating_quality(read_rated_motions(results.log, results.selection));
  results.rated_pairs = rated_pairs(results.log, results.selection, results.ratings);
  results.deviations = deviations_of(results.log, results.selection);
  results.order = order_effects_of(results.log, results.data);
  results.questionnaires = questionnaire_results(filled.pages, filled.instruments, results.data);
  results.sensitivity = sensitivity_of(results.log, options, results.selection, results.data);
  results.target_summaries = target_summaries(results.data);
  results.omnibus = omnibus_tests(results.data);
  results.failure_tests = failure_tests(results.data);
  results.times = task_times(results.data);
  results.preference =
      preference_of(results.data.interfaces,
                    preferred(filled.pages, study::outline_of(results.log.config_text).interfaces));
  results.published = published_of(results, stored ? &*stored : nullptr);
  return results;
}

}  // namespace promenade::analysis
