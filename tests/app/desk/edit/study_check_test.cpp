#include "app/desk/edit/study_check.h"

#include <gtest/gtest.h>

#include "app/registry.h"

namespace promenade::app {
namespace {

constexpr const char* good = R"([study]
name = "a"
[[interface]]
name = "labels"
[[task]]
name = "match"
kind = "match"
targets = [{ example = "proud" }]
)";

std::string with(const std::string& from, const std::string& to) {
  std::string text = good;
  return text.replace(text.find(from), from.size(), to);
}

StudyCheck check(const std::string& text) {
  return check_study("study.toml", text, interfaces(), study::load_motion_set);
}

TEST(StudyCheck, FindsNothingWrongWithAStudyThatCanBeRun) {
  const StudyCheck found = check(good);
  EXPECT_TRUE(found.problems.empty());
  ASSERT_NE(found.bundle, nullptr);
  EXPECT_EQ(found.motions, found.bundle);
}

TEST(StudyCheck, PutsAProblemAtItsValue) {
  const StudyCheck found = check(with("proud", "prowd"));
  EXPECT_TRUE(found.has_errors());
  ASSERT_EQ(found.problems.size(), 1);
  EXPECT_EQ(study::to_text(found.problems[0].path), "task[0].targets[0].example");
  EXPECT_EQ(found.problems[0].line, 8);
}

TEST(StudyCheck, PutsAProblemOfATableAtItsItem) {
  const StudyCheck found = check(with("targets = [{ example = \"proud\" }]\n", ""));
  ASSERT_FALSE(found.problems.empty());
  EXPECT_EQ(study::to_text(found.problems[0].path), "task[0]");
}

TEST(StudyCheck, KnowsTheWalksOfAStudyWithErrors) {
  const StudyCheck found = check(with("\"match\"\nkind", "\"a/b\"\nkind"));
  EXPECT_EQ(found.bundle, nullptr);
  ASSERT_NE(found.motions, nullptr);
  EXPECT_EQ(found.motions->space.set.size(), 10);
  EXPECT_EQ(found.motions->set_sha256, check(good).bundle->set_sha256);
}

TEST(StudyCheck, SurvivesATextThatIsNoToml) {
  const StudyCheck found = check("[study\n");
  EXPECT_TRUE(found.has_errors());
  EXPECT_EQ(found.motions, nullptr);
}

class Checker : public testing::Test {
 protected:
  // The text is seen for so long.
  void see(const std::string& text, std::int64_t for_us) {
    checker_.see(text, now_us_);
    now_us_ += for_us;
    checker_.see(text, now_us_);
  }
  std::string checked() {
    checker_.wait();
    return checker_.found() ? checker_.found()->text : "";
  }

  StudyChecker checker_{"study.toml", interfaces()};
  std::int64_t now_us_ = 1;
};

TEST_F(Checker, ChecksTheFirstTextAtOnceAndOthersWhenTheyStandStill) {
  see(good, 0);
  EXPECT_EQ(checked(), good);
  const std::string other = with("proud", "prowd");
  see(other, 200'000);
  EXPECT_TRUE(checker_.working());
  EXPECT_EQ(checked(), good);
  see(other, 200'000);
  EXPECT_EQ(checked(), other);
  EXPECT_FALSE(checker_.working());
}

TEST_F(Checker, EndsWithTheNewestText) {
  see(good, 0);
  for (const char* walk : {"sad", "happy", "old"}) see(with("proud", walk), 400'000);
  EXPECT_EQ(checked(), with("proud", "old"));
}

}  // namespace
}  // namespace promenade::app
