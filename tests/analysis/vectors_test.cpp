#include "analysis/vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "motion/files.h"
#include "motion/problem.h"
#include "tests/source_dir.h"

namespace promenade::analysis {
namespace {

using Json = nlohmann::json;

Json run(const std::string& text) { return Json::parse(run_vectors("v.json", text))["results"]; }

std::string message_of(const std::string& text) {
  try {
    run_vectors("v.json", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Vectors, GiveEveryCaseAnEntryAndNameWhatTheyCannotDo) {
  const Json results = run(R"({"families": {
      "wilson": [{"id": "w", "kind": "prop", "input": {"x": 0, "n": 0, "conf": 0.95}},
                 {"id": "bad", "kind": "prop", "input": {"x": 5, "n": 3, "conf": 0.95}},
                 {"id": "less", "kind": "prop", "input": {"n": 3, "conf": 0.95}}],
      "tarot": [{"id": "t", "input": {}}]}})");
  EXPECT_EQ(results["w"]["ci"], Json::parse("[0.0, 1.0]"));
  EXPECT_TRUE(results["w"]["estimate"].is_null());
  EXPECT_EQ(results["bad"]["error"], "input.x is larger than input.n");
  EXPECT_EQ(results["less"]["error"], "input.x is missing");
  EXPECT_EQ(results["t"]["error"], "the family tarot is not known");
}

TEST(Vectors, SayWhereAFileIsNoJson) {
  EXPECT_EQ(message_of("{\n \"families\": {,}\n}"), "v.json:2:15: error: is not JSON here");
  EXPECT_EQ(message_of("[1e999, -2e999, }"), "v.json:1:17: error: is not JSON here");
  EXPECT_EQ(message_of("[\n1e999"), "v.json:2:6: error: is not JSON here");
  EXPECT_NE(message_of(""), "");
  EXPECT_NE(message_of("[1, 2"), "");
}

TEST(Vectors, MustBeThere) {
  EXPECT_NE(message_of("[]").find("not a file of test vectors"), std::string::npos);
}

TEST(Vectors, WithoutAPlaceAreErrorsOfTheirOwnAndTheOthersAreDone) {
  const Json results = run(R"({"families": {"a": 1, "wilson": [{"id": "x"}, {}, {"id": "x"},
      {"id": "good", "input": {"x": 1, "n": 2, "conf": 0.95}}]}})");
  EXPECT_EQ(results["family a"]["error"], "is not a list of cases");
  EXPECT_EQ(results["x"]["error"], "the case has no input");
  EXPECT_EQ(results["case 1 of family wilson"]["error"], "the case has no id");
  EXPECT_EQ(results["case 2 of family wilson"]["error"], "the id x is that of an earlier case");
  EXPECT_EQ(results["good"]["estimate"], 0.5);
}

TEST(Vectors, WithANumberThatNoDoubleHoldsAreErrorsOfTheirOwnAndTheOthersAreDone) {
  const Json results = run(R"({"note": "1e999 \" 2e999", "families": {"wilcoxon": [
      {"id": "huge", "input": {"d": [1, -1e999, 2]}},
      {"id": "tiny", "input": {"d": [1, 1e-999, 2]}},
      {"id": "good", "input": {"d": [1, 2, 3]}}]}})");
  EXPECT_EQ(results["huge"]["error"],
            "input.d holds \"-1e999\", which is no number or out of range");
  EXPECT_EQ(results["tiny"]["n_zero"], 1);
  EXPECT_EQ(results["good"]["n"], 3);
}

TEST(Vectors, DropPairsWithANull) {
  const Json results = run(R"({"families": {"wilcoxon": [
      {"id": "m", "input": {"x": [3, null, 5], "y": [1, 2, null]}}]}})");
  EXPECT_EQ(results["m"]["n"], 1);
  EXPECT_EQ(results["m"]["n_missing"], 2);
  EXPECT_EQ(results["m"]["d"], Json::parse("[2.0]"));
  EXPECT_TRUE(results["m"]["hl_all"]["ci95"].is_null());
}

TEST(Vectors, CutATreeOnlyWhereThereAreLeavesEnough) {
  const Json result = run(R"({"families": {"ward": [
      {"id": "w", "input": {"points": [[0, 0], [3, 4], [3, 5]]}}]}})")["w"];
  EXPECT_EQ(result["R_merge"], Json::parse("[[-2, -3], [-1, 1]]"));
  EXPECT_EQ(result["labels_k2"], Json::parse("[0, 1, 1]"));
  EXPECT_TRUE(result["labels_k4"].is_null());
  // n1 n2/(n1 + n2) times the squared distance to (3, 4.5), doubled.
  EXPECT_NEAR(result["height_squared"][1].get<double>(), 4.0 / 3 * 29.25, 1e-12);
}

TEST(Vectors, TakeOneLeafAndRefuseWhatASumOrSquareCannotHold) {
  const Json results = run(R"({"families": {
      "ward": [{"id": "one", "input": {"points": [[1, 2]]}},
               {"id": "far", "input": {"points": [[1e308], [1e308], [1e308]]}},
               {"id": "away", "input": {"dist": [[0, 1e300], [1e300, 0]]}}],
      "sign_test": [{"id": "many", "input": {"n_pos": 2147483647, "n_neg": 3}}]}})");
  EXPECT_EQ(results["one"]["n"], 1);
  EXPECT_TRUE(results["one"]["cophenetic_correlation"].is_null());
  const std::string message = "the input holds a number above 1e150, whose square is out of range";
  EXPECT_EQ(results["far"]["error"], message);
  EXPECT_EQ(results["away"]["error"], message);
  EXPECT_EQ(results["many"]["error"], "input.n_pos is not a whole number from 0 to a billion");
}

TEST(Vectors, RefuseTablesThatAreNoDistances) {
  const Json results = run(R"({"families": {"classical_mds": [
      {"id": "square", "input": {"dist": [[0, 1]], "k": 2}},
      {"id": "even", "input": {"dist": [[0, 1], [2, 0]], "k": 2}},
      {"id": "sign", "input": {"dist": [[0, -1], [-1, 0]], "k": 2}}]}})");
  EXPECT_EQ(results["square"]["error"], "input.dist is not square");
  EXPECT_EQ(results["even"]["error"], "input.dist is not symmetric");
  EXPECT_EQ(results["sign"]["error"], "input.dist is negative");
}

TEST(Vectors, RefuseInputThatNoTestOfTheNewFamiliesCanTake) {
  const Json results = run(R"({"families": {
      "logrank": [{"id": "l", "input": {"time": [1], "event": [1], "group": [null]}},
                  {"id": "m", "input": {"time": [1, 2], "event": [1, 1], "group": [0, 1],
                                        "stratum": [1]}}],
      "krippendorff_alpha": [{"id": "k", "input": {"ratings_rater_by_unit": [[1, 2], [1]]}}],
      "bootstrap_median_ideal": [{"id": "b", "input": {"x": [1, 2], "conf": 0.95}}],
      "bootstrap_ci_given_replicates": [{"id": "s", "input": {"statistic": "mode"}}],
      "power_signflip_exact": [{"id": "n", "input": {"n": 3000, "alpha": 0.05}},
                               {"id": "p", "input": {"n": 5, "alpha": 0.05, "p_plus": 2}}],
      "power_paired_t": [{"id": "sd", "input": {"n": 5, "delta": 1, "sd": 0, "alpha": 0.05}}]}})");
  EXPECT_EQ(results["l"]["error"], "input.group is not all numbers or texts");
  EXPECT_EQ(results["m"]["error"], "input.time, input.group and input.stratum differ in length");
  EXPECT_EQ(results["k"]["error"], "the rows of input.ratings_rater_by_unit differ in length");
  EXPECT_EQ(results["b"]["error"], "input.x has no odd number of values");
  EXPECT_EQ(results["s"]["error"], "input.statistic is neither mean nor median");
  EXPECT_EQ(results["n"]["error"], "input.n is larger than 2000");
  EXPECT_EQ(results["p"]["error"], "input.p_plus is not from 0 to 1");
  EXPECT_EQ(results["sd"]["error"], "input.sd is not above 0");
}

TEST(Vectors, TakeGroupsInTheOrderOfTheirLabels) {
  const Json results = run(R"({"families": {"logrank": [
      {"id": "t", "input": {"time": [1, 2, 3], "event": [1, 0, 1], "group": ["b", "a", "b"]}},
      {"id": "none", "input": {"time": [], "event": [], "group": []}}]}})");
  EXPECT_EQ(results["t"]["observed"], Json::parse("[0.0, 2.0]"));
  EXPECT_EQ(results["none"]["df"], 0);
  EXPECT_TRUE(results["none"]["p"].is_null());
}

// What the header of the shared file says of one number. Those that it calls exact have 0.
struct Tolerance {
  double relative = 1e-9;
  double absolute = 1e-12;
};

bool is_exact(const std::string& key) {
  static const std::set<std::string> keys = {
      "T",        "b",       "c",      "column_totals",  "crit_T",       "crit_T_asym",
      "df",       "k",       "merges", "merged_members", "crit_T_exact", "n",
      "n_censor", "n_event", "n_neg",  "n_missing",      "n_nonzero",    "n_pairable",
      "n_pos",    "n_risk",  "n_zero", "observed",       "order_stats",  "posthoc_pairs",
      "rank",     "R_merge", "W_plus", "W_minus",        "merge_id_a",   "merge_id_b"};
  return keys.count(key) > 0 || key.rfind("labels", 0) == 0;
}

Tolerance tolerance_of(const std::string& family, const std::string& key) {
  if (is_exact(key)) return {0, 0};
  if (family == "wilcoxon" && key.rfind("p_exact", 0) == 0) return {1e-10, 0};
  if (key == "posthoc_p_nemenyi" || family == "power_paired_t") return {0, 1e-6};
  if (family == "icc" && key.rfind("ci95", 0) == 0) return {0, 1e-7};
  return {};
}

std::vector<double> numbers_in(const Json& table) {
  if (!table.is_array()) return {table.get<double>()};
  std::vector<double> numbers;
  for (const Json& part : table) {
    const std::vector<double> inner = numbers_in(part);
    numbers.insert(numbers.end(), inner.begin(), inner.end());
  }
  return numbers;
}

// Tables of a principal component analysis are within 1e-7 (1e-9) of their largest value.
bool near_as_a_whole(const Json& actual, const Json& expected, double tolerance) {
  const std::vector<double> a = numbers_in(actual);
  const std::vector<double> e = numbers_in(expected);
  double largest = 0;
  for (const double value : e) largest = std::max(largest, std::abs(value));
  return std::equal(a.begin(), a.end(), e.begin(), e.end(),
                    [&](double x, double y) { return std::abs(x - y) <= tolerance * largest; });
}

bool agree(const Json& actual, const Json& expected, const std::string& family,
           const std::string& key) {
  if (key == "points" || key == "rotation" || key == "scores")
    return near_as_a_whole(actual, expected, 1e-7);
  if (key == "eig" || key == "sdev") return near_as_a_whole(actual, expected, 1e-9);
  if (expected.is_number() && actual.is_number()) {
    const double a = actual;
    const double e = expected;
    const auto [relative, absolute] = tolerance_of(family, key);
    return std::abs(a - e) <= std::max(relative * std::abs(e), absolute);
  }
  if (!expected.is_structured()) return actual == expected;
  if (expected.is_array() && actual.size() != expected.size()) return false;
  for (const auto& item : expected.items()) {
    const bool list = expected.is_array();
    if (!list && !actual.contains(item.key())) return false;
    const Json& mine = list ? actual[std::stoul(item.key())] : actual[item.key()];
    if (!agree(mine, item.value(), family, list ? key : item.key())) return false;
  }
  return true;
}

// Both were simulated: within four standard errors of their difference.
bool simulations_agree(const Json& actual, const Json& expected) {
  const double p = expected["power"];
  const double variance = p * (1 - p) / actual["n_experiments"].get<double>() +
                          std::pow(expected["mc_se"].get<double>(), 2);
  return actual["crit_T"] == expected["crit_T"] &&
         std::abs(actual["power"].get<double>() - p) <= 4 * std::sqrt(variance);
}

bool agrees(const Json& actual, const Json& expected, const std::string& family) {
  if (actual.contains("error")) return false;
  if (family == "power_simulated") return simulations_agree(actual, expected);
  return agree(actual, expected, family, "");
}

std::filesystem::path shared_vectors() {
  const char* data = std::getenv("PROMENADE_DATA");
  const std::filesystem::path folder = data ? data : source_dir() / "../shared/data";
  return folder / "../stats/vectors.json";
}

TEST(Vectors, AgreeWithOtherProgramsOnEverySharedCase) {
  if (!std::filesystem::exists(shared_vectors())) {
    GTEST_SKIP() << "no shared test vectors at " << shared_vectors();
  }
  const std::string text = read_file(shared_vectors());
  const Json results = run(text);
  const Json shared = Json::parse(text);
  EXPECT_EQ(shared["families"].size(), known_families().size());
  for (const auto& [family, cases] : shared["families"].items()) {
    EXPECT_EQ(cases.size(), shared["header"]["cases_per_family"][family]);
    for (const Json& one : cases) {
      const std::string id = one["id"];
      EXPECT_TRUE(agrees(results[id], one["expected"], family)) << id << " " << results[id];
    }
  }
}

}  // namespace
}  // namespace promenade::analysis
