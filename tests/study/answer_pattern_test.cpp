#include "study/answer_pattern.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace promenade::study {
namespace {

std::vector<TimedAnswer> answers(const std::vector<double>& values, double step_s = 2) {
  std::vector<TimedAnswer> all;
  for (const double value : values) {
    const double t_us = 1e6 * step_s * static_cast<double>(all.size() + 1);
    all.push_back({value, static_cast<std::int64_t>(t_us)});
  }
  return all;
}

std::vector<double> varied(int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(i * i % 5 - 2);
  return values;
}

TEST(AnswerPattern, CountsTheLongestRunAndTheValues) {
  const AnswerPattern pattern = answer_pattern(answers({1, 1, 2, 2, 2, -1, 1}));
  EXPECT_EQ(pattern.items, 7);
  EXPECT_EQ(pattern.longest_run, 3);
  EXPECT_EQ(pattern.distinct, 3);
  EXPECT_DOUBLE_EQ(*pattern.median_s, 2);
  EXPECT_FALSE(pattern.flagged());
}

TEST(AnswerPattern, IsStraightWhereHalfOfTheAnswersInARowAreEqual) {
  std::vector<double> values = varied(41);
  EXPECT_FALSE(answer_pattern(answers(values)).straight);
  std::fill(values.begin() + 10, values.begin() + 31, 1);
  EXPECT_TRUE(answer_pattern(answers(values)).straight);
  std::fill(values.begin(), values.end(), 0);
  values[20] = 1;
  EXPECT_FALSE(answer_pattern(answers(values)).straight) << "20 of 41 is less than half";
  values[20] = 0;
  EXPECT_TRUE(answer_pattern(answers(values)).straight);
}

TEST(AnswerPattern, SaysNothingOfTheValuesOfAShortForm) {
  EXPECT_FALSE(answer_pattern(answers({0, 0, 0, 0})).straight);
  EXPECT_TRUE(answer_pattern(answers(std::vector<double>(12, 0))).straight);
}

TEST(AnswerPattern, IsFastWhereNobodyCanHaveReadTheWords) {
  EXPECT_TRUE(answer_pattern(answers(varied(41), 0.5)).fast);
  EXPECT_FALSE(answer_pattern(answers(varied(41), 0.7)).fast);
  EXPECT_FALSE(answer_pattern(answers({1, 2, 0}, 0.1)).fast) << "too few to tell";
}

TEST(AnswerPattern, TakesTheTimesInTheOrderInWhichTheyCame) {
  std::vector<TimedAnswer> all = answers(varied(20));
  for (std::size_t i = 0; i < all.size() / 2; ++i) std::swap(all[i].t_us, all[19 - i].t_us);
  EXPECT_DOUBLE_EQ(*answer_pattern(all).median_s, 2);
}

TEST(AnswerPattern, OfNothingIsNothing) {
  EXPECT_FALSE(answer_pattern({}).median_s);
  EXPECT_EQ(answer_pattern({{1, 5}}).longest_run, 1);
  EXPECT_FALSE(answer_pattern({}).flagged());
}

}  // namespace
}  // namespace promenade::study
