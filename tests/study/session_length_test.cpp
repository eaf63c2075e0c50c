#include "study/session_length.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "toy.h"

namespace promenade::study {
namespace {

bool always() { return true; }

TEST(SessionLength, IsTheMedianOfAFewSimulatedPeople) {
  const StudyBundle bundle = toy::bundle();
  const SessionLength length = session_length(bundle, toy::registry(), 5, always);
  EXPECT_GT(length.least, 0.2);
  EXPECT_LE(length.least, length.median);
  EXPECT_LE(length.median, length.most);
  EXPECT_LT(length.most, 20);
  EXPECT_EQ(length.median, session_length(bundle, toy::registry(), 5, always).median);
}

TEST(SessionLength, GrowsWithWhatPeopleHaveToDo) {
  std::string text = toy::study_text();
  text += "[breaks]\nafter = 'block'\nleast_s = 600\n";
  const double before = session_length(toy::bundle(), toy::registry(), 3, always).median;
  EXPECT_GT(session_length(toy::bundle(text), toy::registry(), 3, always).median, before + 9);
}

TEST(SessionLength, StopsWhenItIsToldTo) {
  int asked = 0;
  session_length(toy::bundle(), toy::registry(), 5, [&] { return ++asked < 2; });
  EXPECT_EQ(asked, 2);
}

TEST(SessionLength, IsShorterFromEveryPageThanFromTheOneBefore) {
  const StudyBundle bundle = toy::bundle();
  const Plan plan = make_plan(bundle.study, 0);
  const std::vector<double> left = minutes_left(bundle, toy::registry(), plan, 3);
  ASSERT_EQ(left.size(), plan.pages.size());
  EXPECT_TRUE(std::is_sorted(left.rbegin(), left.rend()));
  EXPECT_GT(left.front(), 0.2);
  EXPECT_LT(left.back(), 1) << "of the last page";
}

}  // namespace
}  // namespace promenade::study
