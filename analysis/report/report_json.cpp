#include "analysis/report/report_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/item.h"
#include "analysis/report/sentences.h"
#include "analysis/report/tables.h"

namespace promenade::analysis {
namespace {

using Json = nlohmann::ordered_json;

Json number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json();
}

Json pair(const std::optional<Interval>& interval) {
  return interval ? Json::array({interval->lower, interval->upper}) : Json();
}

Json target_of(const Dataset& data, int task, int target) {
  return target < 0 ? Json() : Json(item(item(data.tasks, task).targets, target));
}

Json comparison_json(const Dataset& data, const Comparison& one) {
  const SignedRankTest& test = one.test;
  const bool any = test.n > 0;
  const auto ci = interval_of(one.hl_ci);
  return {{"measure", item(data.measures, one.measure).name},
          {"task", item(data.tasks, one.task).name},
          {"target", target_of(data, one.task, one.target)},
          {"pooling", one.pooling == Pooling::none ? Json() : Json(to_text(one.pooling))},
          {"a", item(data.interfaces, one.a)},
          {"b", item(data.interfaces, one.b)},
          {"n", test.n},
          {"n_missing", one.missing},
          {"n_zero", test.n_zero},
          {"n_tied", test.n_tied},
          {"tie_sum", test.tie_sum},
          {"W_plus", test.w_plus},
          {"W_minus", test.w_minus},
          {"p_exact_two", any && test.exact ? Json(test.exact->two) : Json()},
          {"p_asym_two", test.normal ? Json(test.normal->two) : Json()},
          {"p_asym_cc_two", test.normal_corrected ? Json(test.normal_corrected->two) : Json()},
          {"p_holm", number(one.p_holm)},
          {"holm_family", one.family},
          {"p_holm_from", !one.p ? Json() : Json(is_approximate(one) ? "asymptotic" : "exact")},
          {"rank_biserial", number(test.rank_biserial)},
          {"rank_biserial_ci", pair(one.rank_biserial_ci)},
          {"hl", number(one.hl)},
          {"hl_ci", pair(ci)},
          {"hl_ci_level", one.hl_ci ? Json(one.hl_ci->level) : Json()}};
}

Json failure_json(const Dataset& data, const FailureRatio& one) {
  return {{"task", item(data.tasks, one.task).name},
          {"target", target_of(data, one.task, one.target)},
          {"interface", item(data.interfaces, one.interface)},
          {"trials", one.trials},
          {"failed", one.failed},
          {"timeouts", one.timeouts},
          {"ratio", static_cast<double>(one.failed) / one.trials},
          {"wilson_ci", pair(one.wilson)},
          {"clopper_pearson_ci", pair(one.clopper_pearson)}};
}

Json summary_json(const Dataset& data, const Summary& one) {
  return {{"measure", item(data.measures, one.measure).name},
          {"task", item(data.tasks, one.task).name},
          {"interface", item(data.interfaces, one.interface)},
          {"n", one.n},
          {"mean", number(one.mean)},
          {"sd", number(one.sd)},
          {"median", number(one.median)},
          {"median_ci", pair(one.median_ci)}};
}

Json files_json(const Log& log) {
  Json files = Json::array();
  for (const LoggedFile& file : log.files) {
    files.push_back({{"file", file.file},
                     {"program_version", file.program_version},
                     {"sessions", file.sessions},
                     {"trials", file.trials},
                     {"answers", file.answers}});
  }
  return files;
}

Json versions_json(const Log& log) {
  Json versions = Json::array();
  for (const LoggedVersion& one : log.versions) {
    versions.push_back({{"version", one.version},
                        {"sha256", one.sha256},
                        {"reason", one.reason.empty() ? Json() : Json(one.reason)},
                        {"amended_utc", one.amended_utc.empty() ? Json() : Json(one.amended_utc)},
                        {"sessions", one.sessions},
                        {"finished", one.finished},
                        {"trials", one.trials}});
  }
  return versions;
}

// "removed" are those of the withdrawn of whom nothing was kept.
Json participants_json(const Results& results) {
  const Flow& flow = results.flow;
  const Selection& selection = results.selection;
  const bool roster = flow.booked > 0;
  const auto place = [&](int count) { return roster ? Json(count) : Json(); };
  Json counts = {{"booked", place(flow.booked)},
                 {"no_show", place(flow.no_show)},
                 {"replaced", place(flow.replaced)},
                 {"expected", place(flow.expected)},
                 {"began", flow.began},
                 {"declined", flow.declined},
                 {"withdrawn", flow.withdrawn},
                 {"removed", flow.removed},
                 {"unfinished", flow.unfinished},
                 {"excluded", flow.excluded},
                 {"analysed", flow.analysed}};
  counts["left_out_simulated"] = selection.left_out_simulated;
  counts["left_out_pilot"] = selection.left_out_pilot;
  return counts;
}

Json measures_json(const Dataset& data) {
  Json measures = Json::array();
  for (const Measure& measure : data.measures) {
    measures.push_back({{"name", measure.name}, {"label", measure.label}, {"unit", measure.unit}});
  }
  return measures;
}

Json tasks_json(const Dataset& data) {
  Json tasks = Json::array();
  for (const Task& task : data.tasks) {
    tasks.push_back({{"name", task.name},
                     {"targets", task.targets},
                     {"limit_s", number(task.limit_s)},
                     {"threshold_m", number(task.threshold_m)}});
  }
  return tasks;
}

Json sentences_json(const Results& results) {
  Json sentences = Json::array();
  for (const Spotlight& spot : spotlights(results)) {
    sentences.push_back(sentence_on_measure(results, spot.measure, spot.task));
  }
  return sentences;
}

}  // namespace

std::string report_json(const Results& results, const std::vector<Section>& sections) {
  const Dataset& data = results.data;
  Json json = {{"program_version", PROMENADE_VERSION},
               {"study",
                {{"name", results.log.study},
                 {"version", results.log.version},
                 {"sha256", results.log.sha256}}},
               {"versions", versions_json(results.log)},
               {"databases", files_json(results.log)},
               {"includes_simulated", results.selection.any_simulated()},
               {"includes_pilot", results.selection.any_pilot()},
               {"participants", participants_json(results)},
               {"interfaces", data.interfaces},
               {"tasks", tasks_json(data)},
               {"measures", measures_json(data)},
               {"trials", {{"analysed", data.trials.size()}, {"missing", data.left_out_trials}}},
               {"sentences", sentences_json(results)},
               {"caveats", caveats(results)},
               {"exclusions", Json::array()},
               {"wilcoxon", Json::array()},
               {"failures", Json::array()},
               {"summaries", Json::array()}};
  for (const Comparison& one : results.comparisons) {
    json["wilcoxon"].push_back(comparison_json(data, one));
  }
  for (const FailureRatio& one : results.failures) {
    json["failures"].push_back(failure_json(data, one));
  }
  for (const Summary& one : results.summaries) {
    json["summaries"].push_back(summary_json(data, one));
  }
  for (const Exclusion& one : results.selection.exclusions) {
    json["exclusions"].push_back(
        {{"code", one.code}, {"reason", one.reason}, {"rule", one.rule}, {"date", one.date}});
  }
  for (const Section& section : sections) json.update(section.json);
  // Codes and names may hold bytes that are no UTF-8.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace promenade::analysis
