// A model file holds all that the sliders are made of: it is read as it was written, and what
// is wrong with it is said at its place.
#include "study/adjective_model_file.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "motion/problem.h"
#include "study/ratings_csv.h"
#include "study/rng.h"

namespace promenade::study {
namespace {

// Six raters who agree about three motions on two pairs.
const std::string& written() {
  static const std::string text = [] {
    std::vector<NamedRating> ratings;
    for (const char* rater : {"anna", "ben", "cleo", "dan", "eve", "fay"}) {
      for (const auto& [motion, value] : {std::pair{"near", 2.0}, {"side", 0.0}, {"far", -2.0}}) {
        ratings.push_back({rater, motion, "slow-fast", value});
        ratings.push_back({rater, motion, "sad-happy", motion[0] == 's' ? 2.0 : -1.0});
      }
    }
    AdjectiveModel model = make_adjective_model(
        make_ratings_table(ratings, {"near", "side", "far"}), "r.csv",
        {.least_extreme = 0.5, .most_deviation = 1, .clusters = 2, .flip = true});
    return adjective_model_toml(
        named(std::move(model), {{{{"en", "speed"}, {"ja", "速さ"}}, {}, {}},
                                 {{{"en", "mood \"x\""}}, {{"en", "low"}}, {{"en", "high"}}}}));
  }();
  return text;
}

std::string replaced(const std::string& from, const std::string& to) {
  std::string text = written();
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from << "\n" << text;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

std::string problems(const std::string& text, const std::vector<std::string>& motions = {}) {
  try {
    read_adjective_model("m.toml", text, motions);
  } catch (const InputError& error) {
    std::string all;
    for (const Problem& problem : error.problems()) all += to_text(problem) + "\n";
    return all;
  }
  return "";
}

TEST(AdjectiveModelFile, IsReadAsItWasWritten) {
  const AdjectiveModel model = read_adjective_model("m.toml", written());
  EXPECT_EQ(adjective_model_toml(model), written());
  EXPECT_EQ(model.names, (std::vector<std::string>{"speed", "mood \"x\""}));
  EXPECT_EQ(text_in(model.words[0].name, "ja"), "速さ");
  EXPECT_EQ(text_in(model.words[1].high, "en"), "high");
  EXPECT_EQ(model.source, "r.csv");
  EXPECT_EQ(model.options.clusters, 2);
  EXPECT_EQ(model.options.least_extreme, 0.5);
  EXPECT_TRUE(model.options.flip);
  EXPECT_FALSE(model.simulated());
  EXPECT_EQ(model.table.motions, (std::vector<std::string>{"near", "side", "far"}));
  EXPECT_EQ(model.quantification.primary.row(0), Eigen::RowVector3d(1, 0.5, 0));
}

TEST(AdjectiveModelFile, NamesNoRater) {
  for (const char* name : {"anna", "fay"}) EXPECT_EQ(written().find(name), std::string::npos);
}

TEST(AdjectiveModelFile, IsReadInTheOrderOfTheMotionsOfTheSet) {
  const AdjectiveModel model = read_adjective_model("m.toml", written(), {"far", "side", "near"});
  EXPECT_EQ(model.quantification.primary.row(0), Eigen::RowVector3d(0, 0.5, 1));
  EXPECT_EQ(model.table.motions, (std::vector<std::string>{"far", "side", "near"}));
  const auto again = make_adjective_model(model.table, "r.csv", model.options);
  EXPECT_EQ(again.quantification.mean, model.quantification.mean) << "the ratings moved along";
}

// Pairs that are equally alike are clustered by the last bits of sums, which depend on the order
// of the motions.
TEST(AdjectiveModelFile, HasTheSameClustersInAnyOrderOfTheMotions) {
  const std::vector<std::string> motions = {"a", "b", "c", "d", "e", "f", "g"};
  const std::vector<std::string> backward(motions.rbegin(), motions.rend());
  int read = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Rng rng(seed, 0, "test");
    std::vector<NamedRating> ratings;
    for (int pair = 0; pair < 14; ++pair) {
      for (const std::string& motion : motions) {
        const double value = static_cast<double>(rng.below(5)) - 2;
        for (int rater = 0; rater < 3; ++rater) {
          ratings.push_back({std::to_string(rater), motion, "x" + std::to_string(pair) + "-y",
                             std::clamp(value + (rater == 0 && value < 2 ? 1 : 0), -2.0, 2.0)});
        }
      }
    }
    const auto model = make_adjective_model(make_ratings_table(ratings, motions), "r.csv");
    if (!model.agreement.agrees()) continue;
    const AdjectiveModel other =
        read_adjective_model("m.toml", adjective_model_toml(model), backward);
    EXPECT_EQ(other.quantification.cluster, model.quantification.cluster);
    ++read;
  }
  EXPECT_GT(read, 50);
}

TEST(AdjectiveModelFile, StaysSimulated) {
  const std::string text = replaced("simulated = false", "simulated = true");
  const AdjectiveModel model = read_adjective_model("m.toml", text);
  EXPECT_TRUE(model.simulated());
  EXPECT_NE(adjective_model_toml(model).find("\nsimulated-01,near"), std::string::npos);
  const AdjectiveModel hidden = read_adjective_model("m.toml", [&] {
    std::string all = adjective_model_toml(model);
    return all.replace(all.find("simulated = true"), 16, "simulated = false");
  }());
  EXPECT_TRUE(hidden.simulated()) << "the raters say so";
}

TEST(AdjectiveModelFile, IsNotMadeOfRatingsThatDoNotAgree) {
  std::vector<NamedRating> ratings;
  for (const char* rater : {"1", "2", "3"}) {
    for (const char* motion : {"a", "b"}) ratings.push_back({rater, motion, "x-y", 2});
  }
  const AdjectiveModel model = make_adjective_model(make_ratings_table(ratings, {}), "r.csv");
  EXPECT_THROW(adjective_model_toml(model), InputError);
}

struct Broken {
  std::string from, to, wanted;
};

class BrokenModelFile : public testing::TestWithParam<Broken> {};

TEST_P(BrokenModelFile, IsRefusedAtItsPlace) {
  const std::string text = problems(replaced(GetParam().from, GetParam().to));
  EXPECT_NE(text.find(GetParam().wanted), std::string::npos) << text;
}

INSTANTIATE_TEST_SUITE_P(
    Table, BrokenModelFile,
    testing::Values(
        Broken{"kind = \"adjective model\"\n", "", "kind"},
        Broken{"adjective model\"", "motion set\"", "m.toml:4:8: error: this is no adjective"},
        Broken{"version = 1", "version = 2", "m.toml:5:"}, Broken{"version = 1\n", "", "version"},
        Broken{"simulated = false", "simulated = 0", "m.toml:7:"},
        Broken{"simulated = false\n", "", "simulated"},
        Broken{"least_extreme = 0.5", "least_extreme = 3", "m.toml:8:"},
        Broken{"most_deviation = 1", "most_deviation = nan", "m.toml:9:"},
        Broken{"clusters = 2", "clusters = 0", "m.toml:10:"},
        Broken{"clusters = 2", "clusters = 1", "there are 2 sliders, but the ratings give 1"},
        Broken{"flip = true", "flip = \"yes\"", "m.toml:11:"},
        Broken{"\"near\", \"side\"", "\"near\", \"near\"", "named twice"},
        Broken{"\"near\", \"side\"", "\"neer\", \"side\"", "did you mean \"neer\"?"},
        Broken{"name = { en = \"speed\"", "name = { fr = \"vite\"", "English"},
        Broken{"name = \"mood \\\"x\\\"\"\n", "", "name"},
        Broken{"name = \"mood \\\"x\\\"\"", "name = \"speed\"", "another slider"},
        Broken{"name = \"mood \\\"x\\\"\"", "name = \"slow-fast\"", "is a pair of adjectives"},
        Broken{"name = \"mood \\\"x\\\"\"", "name = \"a/b\"", "none of them \"/\""},
        Broken{"pairs = [\"slow-fast\"]", "pairs = [\"sad-happy\"]", "give this slider"},
        Broken{"pairs = [\"slow-fast\"]", "", "this slider the pairs \"slow-fast\""},
        Broken{"pairs = [\"slow-fast\"]", "pears = [\"slow-fast\"]", "unknown key \"pears\""},
        Broken{"[ratings]", "[rating]", "ratings"}, Broken{"table = '''", "tables = '''", "table"},
        Broken{"rater,motion,pair,value", "rater,motion,pair", "no column \"value\""},
        Broken{"1,near,slow-fast,2", "1,near,slow-fast,3", "error: the value \"3\" is not"},
        Broken{"[[primary]]", "[primary]", "primary"}));

TEST(AdjectiveModelFile, TellsWhereInItsTableAProblemIs) {
  const std::string text = replaced("1,near,slow-fast,2", "1,near,slow-fast,3");
  const auto line =
      1 + std::count(text.begin(),
                     text.begin() + static_cast<std::ptrdiff_t>(text.find("slow-fast,3")), '\n');
  EXPECT_NE(problems(text).find("m.toml:" + std::to_string(line) + ":18: error"), std::string::npos)
      << problems(text);
}

TEST(AdjectiveModelFile, OfOtherMotionsIsRefused) {
  const std::string text = problems(written(), {"near", "far", "sode"});
  EXPECT_NE(text.find("m.toml:12:11: error: the set has no motion \"side\"; did you mean"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("there is no rating of \"sode\""), std::string::npos) << text;
}

TEST(AdjectiveModelFile, OfNoBytesIsRefused) { EXPECT_NE(problems(""), ""); }

}  // namespace
}  // namespace promenade::study
