#include "analysis/published/published.h"

#include <algorithm>

#include "analysis/item.h"
#include "analysis/results.h"
#include "study/outline.h"

namespace promenade::analysis {
namespace {

std::string words_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::participants:
      return "participants";
    case Quantity::walks:
      return "walks in the set";
    case Quantity::interfaces:
      return "interfaces";
    case Quantity::practice_targets:
      return "practice targets";
    case Quantity::targets:
      return "targets";
    case Quantity::limit_s:
      return "time limit, s";
    case Quantity::threshold_m:
      return "threshold of D, m";
    case Quantity::rated_pairs:
      return "pairs of adjectives that were rated";
    case Quantity::kept_pairs:
      return "pairs of adjectives that were kept";
    case Quantity::clusters:
      return "clusters of adjectives";
  }
  return "";
}

// The first task in which a motion is to be made, and the last: the guess and what follows it.
const study::Task* first_match(const study::Study& study) {
  for (const study::Task& task : study.tasks) {
    if (study::has_target_motion(task.kind)) return &task;
  }
  return nullptr;
}

std::optional<double> longest_limit(const study::Study& study) {
  std::optional<double> limit;
  for (const study::Task& task : study.tasks) {
    if (task.limit_s) limit = std::max(limit.value_or(0), *task.limit_s);
  }
  return limit;
}

std::optional<double> number_of(std::size_t count) { return static_cast<double>(count); }

std::optional<double> of_task(Quantity quantity, const study::Study& study) {
  const study::Task* task = first_match(study);
  if (!task) return std::nullopt;
  if (quantity == Quantity::targets) return number_of(task->targets.size());
  if (quantity == Quantity::practice_targets) return number_of(task->practice.size());
  return task->threshold_m;
}

std::optional<double> of_adjectives(Quantity quantity, const study::AdjectiveModel* model,
                                    const PublishedPairs* pairs) {
  if (pairs && pairs->problem.empty()) {
    if (quantity == Quantity::kept_pairs) return pairs->kept;
    if (quantity == Quantity::clusters) return pairs->clusters;
    const auto rated = [](const PublishedPair& one) { return one.extreme.has_value(); };
    return static_cast<double>(std::count_if(pairs->pairs.begin(), pairs->pairs.end(), rated));
  }
  if (!model) return std::nullopt;
  if (quantity == Quantity::kept_pairs) return number_of(model->kept_pairs.size());
  if (quantity == Quantity::clusters) return number_of(model->names.size());
  return number_of(model->table.pairs.size());
}

std::optional<double> of_run(Quantity quantity, const Results& results,
                             const study::StudyBundle& bundle, const PublishedPairs* pairs) {
  switch (quantity) {
    case Quantity::participants:
      return number_of(results.data.people.size());
    case Quantity::walks:
      return bundle.space.set.size();
    case Quantity::interfaces:
      return number_of(bundle.study.interfaces.size());
    case Quantity::limit_s:
      return longest_limit(bundle.study);
    case Quantity::targets:
    case Quantity::practice_targets:
    case Quantity::threshold_m:
      return of_task(quantity, bundle.study);
    case Quantity::rated_pairs:
    case Quantity::kept_pairs:
    case Quantity::clusters:
      return of_adjectives(quantity, bundle.adjectives.get(), pairs);
  }
  return std::nullopt;
}

}  // namespace

int interface_of_type(const Results& results, std::string_view type) {
  const study::Outline outline = study::outline_of(results.log.config_text);
  const auto& interfaces = results.data.interfaces;
  for (std::size_t i = 0; i < std::min(outline.types.size(), outline.interfaces.size()); ++i) {
    const auto found = std::find(interfaces.begin(), interfaces.end(), outline.interfaces[i]);
    if (outline.types[i] == type && found != interfaces.end()) {
      return static_cast<int>(found - interfaces.begin());
    }
  }
  return -1;
}

void add_printed_counts(const Results& results, const study::StudyBundle* bundle,
                        Published& published) {
  for (const PrintedCount& count : published.study->counts) {
    PublishedRow row;
    row.kind = "design";
    row.what = words_of(count.quantity);
    row.place = std::string(count.place);
    row.printed = count.value;
    if (bundle) {
      row.run =
          of_run(count.quantity, results, *bundle, published.pairs ? &*published.pairs : nullptr);
    }
    if (row.run) row.agrees = *row.run == count.value;
    published.rows.push_back(std::move(row));
  }
}

Published published_of(const Results& results, const study::StudyBundle* bundle) {
  Published published;
  published.study = printed_study(study::outline_of(results.log.config_text).published);
  if (!published.study) return published;
  if (published.study->clusters) {
    published.pairs = published_pairs(results.rated_pairs, published.study->clusters);
  }
  add_printed_counts(results, bundle, published);
  add_printed_sliders(bundle, published);
  add_printed_claims(results, published);
  add_printed_preference(results, published);
  add_printed_tests(results, published);
  return published;
}

}  // namespace promenade::analysis
