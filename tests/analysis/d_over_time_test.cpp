#include "analysis/d_over_time.h"

#include <gtest/gtest.h>

#include "tests/analysis/toy_log.h"

namespace promenade::analysis {
namespace {

TEST(Trace, HoldsItsLastValueAndHasNoneBeforeTheFirst) {
  const Trace trace{{0, 1, 1, 2.5}, {0.3, 0.2, 0.1, 0.4}};
  EXPECT_EQ(d_at(trace, 0), 0.3);
  EXPECT_EQ(d_at(trace, 0.99), 0.3);
  EXPECT_EQ(d_at(trace, 1), 0.1) << "the last of two at once";
  EXPECT_EQ(d_at(trace, 99), 0.4);
  EXPECT_FALSE(d_at({{0.5}, {0.1}}, 0.4));
  EXPECT_FALSE(d_at({}, 1));
}

TEST(Curve, IsTheMedianAndTheQuartilesAtEachTime) {
  const std::vector<Trace> traces = {
      {{0, 2}, {5, 1}}, {{0}, {4}}, {{0, 1}, {3, 0}}, {{1}, {100}}, {}};
  const Curve curve = curve_of(traces, 2, 3);
  EXPECT_EQ(curve.trials, 3) << "one begins late, one is empty";
  EXPECT_EQ(curve.times_s, (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(curve.median, (std::vector<double>{4, 4, 1}));
  EXPECT_EQ(curve.lower_quartile, (std::vector<double>{3.5, 2, 0.5}));
  EXPECT_EQ(curve.upper_quartile, (std::vector<double>{4.5, 4.5, 2.5}));
}

TEST(Curve, OfNothingIsEmpty) {
  EXPECT_EQ(curve_of({}, 2, 3).trials, 0);
  EXPECT_TRUE(curve_of({{}}, 2, 3).times_s.empty());
}

void sample(ToyLog& log, const std::string& trial, double time_s, double d) {
  study::Statement row(log.database(), "INSERT INTO sample VALUES (?, ?, ?, zeroblob(8), NULL)");
  row.bind(1, trial).bind(2, static_cast<std::int64_t>(time_s * 1e6)).bind(3, d).run();
}

TEST(Curves, AreReadFromTheSamplesOfTheTrialsThatCount) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    log.session({"P1"}).trial({.interface = "labels", .seconds = 4}).trial({.practice = true});
    log.session({"P2"}).trial({.interface = "labels", .seconds = 2});
    log.session({"S1", "finished", true}).trial({});
    log.database().exec("UPDATE trial SET started_us = 1000000, ended_us = ended_us + 1000000");
    for (const auto& [trial, d] :
         {std::pair{"1/1", 0.1}, {"1/2", 9.0}, {"2/1", 0.3}, {"3/1", 9.0}}) {
      sample(log, trial, 1, d);
    }
    sample(log, "2/1", 3, 0.5);
  }
  const Curves curves = curves_of(compute_results({folder.file("a.db")}, {}));
  ASSERT_EQ(curves.curves.size(), 1U);
  EXPECT_EQ(curves.curves[0].trials, 2);
  EXPECT_EQ(curves.curves[0].times_s.back(), 4);
  EXPECT_DOUBLE_EQ(curves.curves[0].median.front(), 0.2);
  EXPECT_DOUBLE_EQ(curves.curves[0].median.back(), 0.3);
}

TEST(Curves, LeaveOutWhatStoodStill) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    log.session({"P1"}).trial({}).trial({});
    log.database().exec("UPDATE trial SET paused_us = 5 WHERE uuid = '1/1'");
    sample(log, "1/1", 0, 9);
    sample(log, "1/2", 0, 1);
  }
  const Curves curves = curves_of(compute_results({folder.file("a.db")}, {}));
  EXPECT_EQ(curves.paused, 1);
  EXPECT_EQ(curves.curves.at(0).median.back(), 1);
}

}  // namespace
}  // namespace promenade::analysis
