#include "analysis/vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

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

TEST(Vectors, RefuseTablesThatAreNoDistances) {
  const Json results = run(R"({"families": {"classical_mds": [
      {"id": "square", "input": {"dist": [[0, 1]], "k": 2}},
      {"id": "even", "input": {"dist": [[0, 1], [2, 0]], "k": 2}},
      {"id": "sign", "input": {"dist": [[0, -1], [-1, 0]], "k": 2}}]}})");
  EXPECT_EQ(results["square"]["error"], "input.dist is not square");
  EXPECT_EQ(results["even"]["error"], "input.dist is not symmetric");
  EXPECT_EQ(results["sign"]["error"], "input.dist is negative");
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

// The tolerances that the header of the shared file states.
bool agree(const Json& actual, const Json& expected, const std::string& key) {
  if (key == "points" || key == "rotation" || key == "scores")
    return near_as_a_whole(actual, expected, 1e-7);
  if (key == "eig" || key == "sdev") return near_as_a_whole(actual, expected, 1e-9);
  if (expected.is_number() && actual.is_number()) {
    const double a = actual;
    const double e = expected;
    if (key.rfind("p_exact", 0) == 0) return std::abs(a - e) <= 1e-10 * std::abs(e);
    if (key == "posthoc_p_nemenyi") return std::abs(a - e) <= 1e-6;
    if (key[0] == 'W' || key[0] == 'T' || key[0] == 'n') return a == e;
    return std::abs(a - e) <= std::max(1e-9 * std::abs(e), 1e-12);
  }
  if (!expected.is_structured()) return actual == expected;
  if (expected.is_array() && actual.size() != expected.size()) return false;
  for (const auto& item : expected.items()) {
    const bool there = expected.is_array() || actual.contains(item.key());
    const Json& mine = expected.is_array() ? actual[std::stoul(item.key())] : actual[item.key()];
    if (!there || !agree(mine, item.value(), expected.is_array() ? key : item.key())) return false;
  }
  return true;
}

std::filesystem::path shared_vectors() {
  const char* data = std::getenv("PROMENADE_DATA");
  const std::filesystem::path folder =
      data ? data : source_dir() / "../shared/data";
  return folder / "../stats/vectors.json";
}

TEST(Vectors, AgreeWithOtherProgramsOnEverySharedCaseOfKnownFamilies) {
  if (!std::filesystem::exists(shared_vectors())) {
    GTEST_SKIP() << "no shared test vectors at " << shared_vectors();
  }
  const std::string text = read_file(shared_vectors());
  const Json results = run(text);
  const Json families = Json::parse(text)["families"];
  for (const std::string& family : known_families()) {
    for (const Json& one : families[family]) {
      const std::string id = one["id"];
      EXPECT_TRUE(agree(results[id], one["expected"], "")) << id << " " << results[id];
    }
  }
}

}  // namespace
}  // namespace promenade::analysis
