// What people said of motions on pairs of adjectives, and whether they mean the same.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/cells.h"
#include "analysis/report/rated_pair_tables.h"
#include "analysis/report/report_sections.h"

namespace promenade::analysis {
namespace {

using study::AdjectiveModel;

int rated_motions(const RatedPairs& rated) {
  const std::vector<int>& counts = rated.statistics.motions;
  return size_of(counts) - static_cast<int>(std::count(counts.begin(), counts.end(), 0));
}

std::string who_rated(const RatedPairs& rated) {
  const int raters = rated.model.table.raters;
  const bool simulated = rated.simulated == raters;
  const int motions = rated_motions(rated);
  const int all = size_of(rated.model.table.motions);
  return fmt::format(
      "{} rated {} on {}",
      simulated ? count_of(raters, "simulated person", "simulated people")
                : count_of(raters, "person", "people"),
      motions == all ? count_of(motions, "motion", "motions")
                     : fmt::format("{} of {} motions", motions, all),
      count_of(rated.model.agreement.asked, "pair of adjectives", "pairs of adjectives"));
}

std::string fates_of(const AdjectiveModel& model) {
  const study::RaterAgreement& found = model.agreement;
  std::string words = fmt::format("{} kept", count_of(found.kept, "pair is", "pairs are"));
  const auto add = [&](int count, const std::string& why) {
    if (count > 0) words += fmt::format(", {} dropped because {}", count, why);
  };
  add(found.never_extreme,
      "no motion is far from neutral (μ* below " + exact_number(model.options.least_extreme) + ")");
  add(found.disagreed,
      "raters differ too much (σ above " + exact_number(model.options.most_deviation) + ")");
  add(found.unrated, "not every motion was rated, or none by two people");
  return words;
}

std::string alpha_sentence(const KrippendorffAlpha& alpha) {
  if (!alpha.ordinal) return "Krippendorff’s alpha is not defined.";
  return fmt::format("Krippendorff’s ordinal alpha over all pairs is {}.",
                     fixed(*alpha.ordinal, 2));
}

// What the permutation test says, and what it is about.
std::string agreement_sentence(const study::RaterAgreement& found) {
  if (!found.enough()) {
    return fmt::format("Too few pairs are left for sliders: {}, and {} needed.", found.kept,
                       count_of(found.wanted, "is", "are"));
  }
  const std::string share =
      fmt::format("on the kept pairs the motions explain {} of the variance within raters",
                  percent(found.explained));
  const std::string test =
      fmt::format("(p {}, {} shuffles)", p_text(found.p), study::RaterAgreement::shuffles);
  if (!found.agrees()) {
    return fmt::format(
        "Raters do not agree beyond chance: {}, but ratings whose motions were shuffled do as well "
        "too often {}; at most {} would count as agreement.",
        share, test, exact_number(study::RaterAgreement::level));
  }
  return fmt::format(
      "Raters agree: {}, and ratings whose motions were shuffled hardly ever do as well {}.", share,
      test);
}

Html words_on(const RatedPairs& rated) {
  Html html = element("p", who_rated(rated) + ": " + fates_of(rated.model) + ". " +
                               alpha_sentence(rated.statistics.alpha) + " " +
                               agreement_sentence(rated.model.agreement));
  if (rated.simulated == 0) return html;
  const bool all = rated.simulated == rated.model.table.raters;
  return html + note(all ? "All raters are simulated: no person judged these motions."
                         : count_of(rated.simulated, "rater is", "raters are") +
                               " simulated: no person gave their ratings.");
}

nlohmann::json clusters_json(const AdjectiveModel& model) {
  nlohmann::json list = nlohmann::json::array();
  for (int c = 0; c < size_of(model.names); ++c) {
    list.push_back({{"name", item(model.names, c)},
                    {"agreement", item(model.name_agreement, c)},
                    {"pairs", pairs_of(model, c)}});
  }
  return list;
}

nlohmann::json json_of(const RatedPairs& rated, const std::vector<Table>& tables) {
  const study::RaterAgreement& found = rated.model.agreement;
  const auto& alpha = rated.statistics.alpha;
  const auto number = [](const std::optional<double>& value) {
    return value ? nlohmann::json(*value) : nlohmann::json();
  };
  return {{"raters", rated.model.table.raters},
          {"simulated_raters", rated.simulated},
          {"motions", rated_motions(rated)},
          {"motions_in_set", size_of(rated.model.table.motions)},
          {"pairs_asked", found.asked},
          {"pairs_kept", found.kept},
          {"pairs_needed", found.wanted},
          {"never_extreme", found.never_extreme},
          {"disagreed", found.disagreed},
          {"unrated", found.unrated},
          {"least_extreme", rated.model.options.least_extreme},
          {"most_deviation", rated.model.options.most_deviation},
          {"alpha_ordinal", number(alpha.ordinal)},
          {"alpha_interval", number(alpha.interval)},
          {"explained", found.explained},
          {"p", found.p},
          {"agrees", found.agrees()},
          {"clusters", clusters_json(rated.model)},
          {"pairs", json_rows(tables[0])},
          {"by_rater", json_rows(tables[1])}};
}

// Beside what is said of the motions of the set.
void add_stimuli(const RatedPairs& rated, Section& section) {
  if (rated.stimuli.empty()) return;
  const Table table = stimulus_rating_table(rated);
  section.html +=
      note(
          "Stimuli are no mixtures of the motions of the set: what was said of them is not part of "
          "the pairs, the clusters and the agreement.") +
      folded(shown_stimuli(rated));
  section.json["ratings"]["stimuli"] = json_rows(table);
  section.tables.push_back(table);
}

}  // namespace

Section ratings_section(const Results& results) {
  if (!results.rated_pairs) return {};
  const RatedPairs& rated = *results.rated_pairs;
  Section section;
  section.title = "Ratings";
  if (!rated.problem.empty()) {
    section.html =
        element("p", rated.stimuli.empty()
                         ? "There is nothing to say of the ratings: " + rated.problem + "."
                         : "No motion of the set was rated: " + rated.problem + ".");
    section.json["ratings"] = {{"problem", rated.problem}};
    add_stimuli(rated, section);
    return section;
  }
  section.html = words_on(rated) + wide_words(shown_clusters(rated.model)) +
                 folded(shown_pairs(rated)) + folded(shown_raters(results));
  section.tables = {rated_pair_table(rated), pair_rater_table(results)};
  section.json["ratings"] = json_of(rated, section.tables);
  add_stimuli(rated, section);
  return section;
}

}  // namespace promenade::analysis
