// Every file of configs/studies can be run as it stands.
#include <gtest/gtest.h>

#include <filesystem>

#include "app/registry.h"
#include "study/embedded.h"
#include "study/published.h"
#include "study/study.h"
#include "study/targets_csv.h"

namespace promenade::app {
namespace {

// From a folder without the source tree, so that the embedded files are read.
class PublishedStudies : public testing::TestWithParam<std::string> {
 protected:
  PublishedStudies() { std::filesystem::current_path("/"); }
  ~PublishedStudies() override { std::filesystem::current_path(before_); }
  PublishedStudies(const PublishedStudies&) = delete;
  PublishedStudies& operator=(const PublishedStudies&) = delete;

  static study::StudyBundle load() {
    return study::load_study("configs/studies/" + GetParam() + ".toml", interfaces());
  }

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
};

TEST_P(PublishedStudies, LoadWithoutAProblem) {
  const study::StudyBundle bundle = load();
  EXPECT_EQ(bundle.study.name, GetParam());
  EXPECT_EQ(GetParam().rfind(bundle.study.published, 0), 0U) << bundle.study.published;
  EXPECT_FALSE(bundle.study.published.empty());
  EXPECT_GT(bundle.study.participants, 0);
  EXPECT_EQ(bundle.study.languages, (std::vector<std::string>{"en", "ja"}));
}

// The set can then be replaced on its line alone.
TEST_P(PublishedStudies, NameNoWalkOfTheSetAsATarget) {
  const std::string text = load().config_text;
  EXPECT_EQ(text.find("example ="), std::string::npos);
  EXPECT_EQ(text.find("weights = {"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(All, PublishedStudies, testing::ValuesIn(study::embedded_names("studies")),
                         [](const auto& one) {
                           std::string name = one.param;
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

// A file that no longer fits its set would be drawn anew, and only a warning would say so.
TEST(TheTargetsOf2018, AreThoseOfTheirFile) {
  const auto bundle = study::load_study("configs/studies/oshita-2018.toml", interfaces());
  const auto file = study::embedded_file("studies/oshita-2018-targets.csv");
  ASSERT_TRUE(file);
  EXPECT_EQ(study::targets_csv(bundle.study.tasks[0].targets, motion::names_of(bundle.space.set)),
            *file);
}

}  // namespace
}  // namespace promenade::app
