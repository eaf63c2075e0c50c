// [study] ratings: a file of people's ratings gives the adjectives of the set.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "motion/problem.h"
#include "study/adjective_model_file.h"
#include "study/reach_models.h"
#include "tests/test_folder.h"
#include "toy.h"

namespace promenade::study {
namespace {

// An interface that asks for adjectives and shows nothing of them.
InterfaceRegistry asking_registry() {
  InterfaceRegistry registry;
  InterfaceType type = *toy::registry().find("pick");
  type.prepare = [](const InterfaceResources& resources, const Parameters&) -> PreparedModel {
    return {nullptr, resources.adjectives() ? "" : "nobody has rated"};
  };
  registry.add(type);
  registry.add(*toy::registry().find("mix"));
  return registry;
}

class RatingsFile : public testing::Test {
 protected:
  void write(const std::string& rows) {
    std::ofstream(folder_.file("r.csv")) << "rater,motion,pair,value\n" << rows;
  }
  StudyBundle load(const std::string& ratings = "r.csv") const {
    std::string text = toy::study_text();
    const std::string line = "[study]\n";
    text.insert(text.find(line) + line.size(), "ratings = \"" + ratings + "\"\n");
    return read_study(folder_.file("study.toml"), text, asking_registry(),
                      [](const std::string&, const std::string&) { return toy::motion_set(); });
  }
  std::string problems() const {
    try {
      load();
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  // Raters who agree: near is fast, far is slow.
  static std::string people(const std::string& rater = "p") {
    std::string rows;
    for (const char* const who : {"1", "2", "3", "4", "5", "6"}) {
      rows += rater + who + ",near,slow-fast,2\n" + rater + who + ",side,slow-fast,0\n";
      rows += rater + who + ",far,slow-fast,-2\n";
    }
    return rows;
  }

  TestFolder folder_;
};

TEST_F(RatingsFile, GivesTheAdjectivesOfTheSet) {
  write(people());
  const StudyBundle bundle = load();
  ASSERT_NE(bundle.adjectives, nullptr);
  EXPECT_FALSE(bundle.adjectives->simulated());
  EXPECT_EQ(bundle.adjectives->quantification.primary, Eigen::RowVector3d(1, 0.5, 0));
  EXPECT_TRUE(bundle.warnings.empty());
}

TEST_F(RatingsFile, IsWhatCheckJudgesBy) {
  write(people());
  const ReachModels models = make_reach_models(load());
  ASSERT_TRUE(models.adjectives);
  EXPECT_EQ(models.adjectives->source, "r.csv");
}

TEST_F(RatingsFile, IsPartOfTheStudysHash) {
  write(people());
  const std::string before = load().sha256;
  EXPECT_EQ(load().sha256, before);
  write(people("q"));
  EXPECT_NE(load().sha256, before);
}

TEST_F(RatingsFile, OfSimulatedRatersIsWarnedAbout) {
  write(people("simulated-"));
  const StudyBundle bundle = load();
  ASSERT_EQ(bundle.warnings.size(), 1U);
  EXPECT_NE(bundle.warnings[0].message.find("simulated raters"), std::string::npos);
  EXPECT_GT(bundle.warnings[0].line, 0);
}

TEST_F(RatingsFile, HasItsProblemsNamedAtTheirPlaces) {
  write(people() + "p1,neer,slow-fast,1\n");
  EXPECT_NE(problems().find("r.csv:20:"), std::string::npos) << problems();
  EXPECT_NE(problems().find("did you mean \"near\""), std::string::npos) << problems();
}

TEST_F(RatingsFile, MustHaveRatedEveryMotion) {
  write("p,near,slow-fast,1\np,far,slow-fast,1\n");
  EXPECT_NE(problems().find("no rating of \"side\""), std::string::npos) << problems();
}

TEST_F(RatingsFile, MustShowThatItsRatersAgree) {
  std::string rows;
  for (const char* const orders : {"-2,0,2", "2,-2,0", "0,2,-2", "2,0,-2", "-2,2,0", "0,-2,2"}) {
    const std::string order = orders;
    const std::string rater = "p" + std::to_string(rows.size());
    const std::size_t first = order.find(','), second = order.rfind(',');
    rows += rater + ",near,slow-fast," + order.substr(0, first) + "\n" + rater +
            ",side,slow-fast," + order.substr(first + 1, second - first - 1) + "\n" + rater +
            ",far,slow-fast," + order.substr(second + 1) + "\n";
  }
  write(rows);
  const std::string text = problems();
  EXPECT_NE(text.find("study.toml:2:"), std::string::npos) << text;
  EXPECT_NE(text.find("the ratings do not agree: 0 of 1 pairs are left"), std::string::npos)
      << text;
}

TEST_F(RatingsFile, CanBeAModelFileWithNamesOfItsOwn) {
  write(people());
  AdjectiveModel model = *load().adjectives;
  model = named(std::move(model), {{{{"en", "haste"}}, {}, {}}});
  std::ofstream(folder_.file("m.toml")) << adjective_model_toml(model);
  const StudyBundle bundle = load("m.toml");
  ASSERT_NE(bundle.adjectives, nullptr);
  EXPECT_EQ(bundle.adjectives->names, std::vector<std::string>{"haste"});
  EXPECT_EQ(bundle.adjectives->quantification.primary, Eigen::RowVector3d(1, 0.5, 0));
  EXPECT_TRUE(std::any_of(bundle.parts.begin(), bundle.parts.end(),
                          [](const StudyPart& part) { return part.path == "m.toml"; }));
  std::ofstream(folder_.file("m.toml"), std::ios::app) << "more = 1\n";
  EXPECT_THROW(load("m.toml"), InputError);
}

TEST_F(RatingsFile, MustBeThere) {
  std::filesystem::remove(folder_.file("r.csv"));
  const std::string text = problems();
  EXPECT_NE(text.find("study.toml:"), std::string::npos) << text;
  EXPECT_NE(text.find("cannot use the ratings \"r.csv\""), std::string::npos) << text;
}

}  // namespace
}  // namespace promenade::study
