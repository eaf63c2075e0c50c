// M. Oshita, A. Honda, M. Katsurada, Y. Aosaki: Motion interpolation using adjectives and motion
// features, and the shorter paper of NICOGRAPH International 2016.
#include "analysis/published/printed.h"

namespace promenade::analysis {
namespace {

constexpr std::string_view adjectives = "adjectives", features = "features", weights = "weights";

// p of targets 1 to 5, then of all.
struct TestRow {
  std::string_view measure, a, b;
  double p[6];
  int ties;  // bit k: the p of target k + 1 needs ties
};

// The papers call the interfaces p (adjectives), f (features) and w (blend weights). One of the
// times is printed as .08, with two digits.
constexpr TestRow rows[] = {
    {"d_final", adjectives, features, {.382, .011, .807, .087, .007, .000}, 0},
    {"d_final", adjectives, weights, {.133, .002, .019, .007, .004, .000}, 0},
    {"d_final", features, weights, {.006, .002, .005, .003, .001, .000}, 0},
    {"time_s", adjectives, features, {.695, .007, .002, .075, .009, .652}, 0b00001},
    {"time_s", adjectives, weights, {.034, .003, .075, .055, .08, .000}, 0b10001},
    {"time_s", features, weights, {.201, .001, .013, .015, .001, .000}, 0b01001},
};

std::vector<PrintedTest> tests() {
  std::vector<PrintedTest> all;
  for (const TestRow& row : rows) {
    for (int k = 0; k < 6; ++k) {
      const bool ties = ((row.ties >> k) & 1) != 0;
      all.push_back({row.measure, row.a, row.b, k < 5 ? k + 1 : 0, row.p[k], ties});
    }
  }
  return all;
}

PrintedStudy questionnaire(std::string_view name, std::string_view title, int walks, int kept_pairs,
                           std::string_view table) {
  PrintedStudy study;
  study.name = name;
  study.title = title;
  study.counts = {{Quantity::walks, static_cast<double>(walks), "[O] 3"},
                  {Quantity::rated_pairs, 41, "[O] Table 1"},
                  {Quantity::kept_pairs, static_cast<double>(kept_pairs), table},
                  {Quantity::clusters, 4, table}};
  return study;
}

PrintedStudy questionnaire_a() {
  PrintedStudy study =
      questionnaire("oshita-questionnaire-a", "Oshita et al., questionnaire on motion set A", 10,
                    27, "[O] Table 2");
  study.counts.insert(study.counts.begin(), {Quantity::participants, 14, "[O] 3"});
  study.clusters = &motion::AdjectivePair::set_a;
  study.notes = {
      "The name “activeness” of the third cluster is lost in the printed Table 2, and restored "
      "here."};
  return study;
}

PrintedStudy questionnaire_b() {
  PrintedStudy study =
      questionnaire("oshita-questionnaire-b", "Oshita et al., questionnaire on motion set B", 27,
                    29, "[O] Table 3");
  study.clusters = &motion::AdjectivePair::set_b;
  return study;
}

PrintedStudy study_of_2016() {
  PrintedStudy study;
  study.name = "oshita-2016";
  study.title = "Oshita et al., NICOGRAPH International 2016";
  study.counts = {{Quantity::walks, 10, "[O] 3"}, {Quantity::interfaces, 2, "2016"}};
  study.notes = {"We know no test of this study, so that its report has its design alone."};
  return study;
}

PrintedStudy study_of_2018() {
  PrintedStudy study;
  study.name = "oshita-2018";
  study.title = "Oshita et al., user study";
  study.counts = {{Quantity::participants, 13, "[O] 6"},  {Quantity::walks, 27, "[O] 6"},
                  {Quantity::interfaces, 3, "[O] 6"},     {Quantity::practice_targets, 3, "[O] 6"},
                  {Quantity::targets, 5, "[O] 6"},        {Quantity::limit_s, 300, "[O] 6"},
                  {Quantity::threshold_m, 0.06, "[O] 6"}, {Quantity::kept_pairs, 29, "[O] Table 3"},
                  {Quantity::clusters, 4, "[O] Table 3"}};
  study.tests = tests();
  study.notes = {
      "Targets 1 to 5 of the paper are other walks than those of this study: compare how many "
      "tests are significant rather than target with target.",
      "The paper tests without continuity correction and, for all targets together, takes the "
      "trials of one person for independent; the p of this run are made in the same way, with the "
      "exact p beside them (for all targets: of one value per participant).",
      "Eq. 8 prints a sum where text and threshold want a mean; D here is the mean. The limit of "
      "300 s is printed for two of the three steps.",
      "One passage says that targets were generated at random, another that five were kept that "
      "cover different walks."};
  return study;
}

}  // namespace

std::vector<PrintedStudy> printed_by_oshita() {
  return {questionnaire_a(), questionnaire_b(), study_of_2016(), study_of_2018()};
}

}  // namespace promenade::analysis
