#include "study/targets_csv.h"

#include <gtest/gtest.h>

#include "motion/problem.h"

namespace promenade::study {
namespace {

const std::vector<std::string> motions = {"near", "side", "far"};

std::string problems_of(const std::string& text) {
  try {
    read_targets_csv("t.csv", text, motions);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(TargetsCsv, ReadsATargetARow) {
  const auto targets =
      read_targets_csv("t.csv", "far,name,near\n0.75,m,0.25\n1,\"a, b\",\n", motions);
  ASSERT_EQ(targets.size(), 2U);
  EXPECT_EQ(targets[0].name, "m");
  EXPECT_EQ(*targets[0].weights, Eigen::Vector3d(0.25, 0, 0.75));
  EXPECT_EQ(targets[1].name, "a, b");
  EXPECT_EQ(*targets[1].weights, Eigen::Vector3d(0, 0, 1));
}

TEST(TargetsCsv, GivesTheVeryNumbersBack) {
  std::vector<Target> targets(2);
  targets[0].name = "a,\"b\"";
  targets[0].weights = Eigen::Vector3d(1.0 / 3, -0.1, 1.1 - 1.0 / 3);
  targets[1].name = "drawn later";  // has no weights yet
  const auto back = read_targets_csv("t.csv", targets_csv(targets, motions), motions);
  ASSERT_EQ(back.size(), 1U);
  EXPECT_EQ(back[0].name, targets[0].name);
  EXPECT_EQ(*back[0].weights, *targets[0].weights);
}

struct Broken {
  const char* text;
  const char* problems;
};

TEST(TargetsCsv, NamesEveryProblemWithItsPlace) {
  for (const Broken& broken :
       {Broken{"",
               "t.csv: error: is empty; a header with \"name\" and the names of motions is "
               "wanted"},
        Broken{"name,fra\nm,1\n",
               "t.csv:1:6: error: the set has no motion \"fra\"; did you mean \"far\"?"},
        Broken{"far,far\n1,0\n",
               "t.csv:1:5: error: there is another column \"far\" before\n"
               "t.csv:1:1: error: there is no column \"name\""},
        Broken{"name,far\n", "t.csv:1:1: error: there are no targets below the header"},
        Broken{"name,far,near\nm,0.5,0.4\n",
               "t.csv:2:1: error: the weights sum to 0.9, but must sum to 1"},
        Broken{"name,far\nm,one\n,1\nn,1,2\n",
               "t.csv:2:3: error: the weight \"one\" is not a number from -100 to 100\n"
               "t.csv:3:1: error: the target has no name\n"
               "t.csv:4:5: error: 3 cells where the header has 2"}}) {
    EXPECT_EQ(problems_of(broken.text), broken.problems) << broken.text;
  }
}

}  // namespace
}  // namespace promenade::study
