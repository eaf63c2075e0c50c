#include "study/frame_histogram.h"

#include <gtest/gtest.h>

namespace promenade::study {
namespace {

using Rows = std::vector<TimeHistogram::Row>;

TEST(FrameHistogram, EachTimeIsInTheBinThatBeginsAtOrBelowIt) {
  TimeHistogram histogram;
  for (const std::int64_t time_us : {16'000, 16'999, 17'000, 999}) histogram.add(time_us);
  EXPECT_EQ(histogram.rows(), (Rows{{0, 1}, {16'000, 2}, {17'000, 1}}));
  EXPECT_EQ(histogram.count(), 4);
}

TEST(FrameHistogram, TheLastBinHasAllThatIsLonger) {
  TimeHistogram histogram;
  for (const std::int64_t time_us : {199'000, 200'000, 90'000'000}) histogram.add(time_us);
  EXPECT_EQ(histogram.rows(), (Rows{{199'000, 3}}));
}

TEST(FrameHistogram, AClockThatStoodStillIsInTheFirstBin) {
  TimeHistogram histogram;
  for (const std::int64_t time_us : {0, -5}) histogram.add(time_us);
  EXPECT_EQ(histogram.rows(), (Rows{{0, 2}}));
}

TEST(FrameHistogram, OneWithoutFramesIsEmpty) {
  FrameHistogram histogram;
  EXPECT_TRUE(histogram.empty());
  EXPECT_TRUE(histogram.interval.rows().empty());
  histogram.work.add(5);
  EXPECT_FALSE(histogram.empty());
}

}  // namespace
}  // namespace promenade::study
