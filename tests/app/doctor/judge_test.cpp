// What the doctor says about machines that are made up.
#include <gtest/gtest.h>

#include "app/doctor/report.h"

namespace promenade::app {
namespace {

// 200 frames at 60 Hz, and a poll every half millisecond.
Findings good_machine() {
  Findings findings;
  findings.display = {.width = 1920, .height = 1080, .refresh_hz = 60, .renderer = "Mesa Intel"};
  findings.pacing = PacingFinding{.interval_us = std::vector<std::int64_t>(200, 16'667)};
  findings.input =
      InputFinding{.gap_us = std::vector<std::int64_t>(6666, 500), .watched_us = 3'333'000};
  findings.disk = {.folder = "/data", .commit_us = {900, 1000, 1100}, .free_bytes = 5'000'000'000};
  findings.clock = {.step_ns = 20, .source = "tsc"};
  return findings;
}

const Check& check_of(const DoctorReport& report, const std::string& name) {
  for (const Check& check : report.checks) {
    if (check.name == name) return check;
  }
  throw std::logic_error("there is no check " + name);
}

Verdict verdict_of(const Findings& findings, const std::string& name) {
  return check_of(judge(findings), name).verdict;
}

TEST(Doctor, AGoodMachineIsFitInEveryRespect) {
  const DoctorReport report = judge(good_machine());
  EXPECT_TRUE(report.fit());
  EXPECT_EQ(report.checks.size(), 7U);
  for (const Check& check : report.checks) EXPECT_EQ(check.verdict, Verdict::ok) << check.says;
}

TEST(Doctor, WithoutADisplayTheRestIsJudged) {
  Findings findings = good_machine();
  findings.display = {.problem = "there is no display"};
  findings.pacing.reset();
  findings.input.reset();
  const DoctorReport report = judge(findings);
  EXPECT_FALSE(report.fit());
  EXPECT_EQ(report.checks.size(), 4U);
  EXPECT_EQ(check_of(report, "display").says, "there is no display");
  EXPECT_EQ(check_of(report, "disk").verdict, Verdict::ok);
}

TEST(Doctor, SmallOrSilentDisplaysAndSoftwareAreWarnings) {
  Findings findings = good_machine();
  findings.display.refresh_hz = 0;
  findings.display.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
  EXPECT_EQ(verdict_of(findings, "display"), Verdict::warning);
  EXPECT_EQ(verdict_of(findings, "renderer"), Verdict::warning);
  EXPECT_TRUE(judge(findings).fit());
  findings.display = {.width = 1024, .height = 768, .refresh_hz = 60};
  EXPECT_EQ(verdict_of(findings, "display"), Verdict::warning);
}

TEST(Doctor, OneFrameInAHundredMayBeLateNotTwo) {
  Findings findings = good_machine();
  std::vector<std::int64_t>& intervals = findings.pacing->interval_us;
  intervals[0] = intervals[1] = 33'333;
  EXPECT_EQ(verdict_of(findings, "frames"), Verdict::ok);
  intervals[2] = 33'333;
  EXPECT_EQ(verdict_of(findings, "frames"), Verdict::failure);
}

TEST(Doctor, FramesAreMeasuredAgainstTheDisplaysOwnRate) {
  Findings findings = good_machine();
  findings.pacing->wanted_hz = 144;
  EXPECT_EQ(verdict_of(findings, "frames"), Verdict::failure);
  findings.pacing->interval_us.assign(200, 6944);
  EXPECT_EQ(verdict_of(findings, "frames"), Verdict::ok);
}

TEST(Doctor, MeanDeviationAndLateShareAreFigures) {
  Findings findings = good_machine();
  findings.pacing->interval_us = {16'000, 17'000, 16'000, 31'000};
  const Json figures = check_of(judge(findings), "frames").figures;
  EXPECT_DOUBLE_EQ(figures["mean_ms"], 20);
  EXPECT_NEAR(figures["sd_ms"], 7.348469, 1e-6) << "square root of (16 + 9 + 16 + 121) / 3";
  EXPECT_DOUBLE_EQ(figures["late_share"], 0.25);
  EXPECT_DOUBLE_EQ(figures["on_time_share"], 0.75);
}

TEST(Doctor, FewFramesDecideNothing) {
  Findings findings = good_machine();
  findings.pacing->interval_us.resize(49);
  EXPECT_EQ(verdict_of(findings, "frames"), Verdict::warning);
}

TEST(Doctor, AnEventWaitsForTheRestOfTheGapInWhichItComes) {
  // Deaf for 10 ms of every 20: half of all events wait, evenly up to 10 ms.
  const InputFinding input{.gap_us = {10'000, 10'000, 10'000}, .watched_us = 60'000};
  EXPECT_NEAR(wait_quantile_us(input, 0.99), 9800, 1);
  EXPECT_NEAR(wait_quantile_us(input, 0.75), 5000, 1);
  EXPECT_NEAR(wait_quantile_us(input, 0.5), 0, 1);
  EXPECT_EQ(wait_quantile_us({}, 0.99), 0);
}

TEST(Doctor, InputThatWaitsIsAWarningAndForAFrameAFailure) {
  Findings findings = good_machine();
  findings.input->gap_us.assign(500, 6000);
  EXPECT_EQ(verdict_of(findings, "input"), Verdict::warning);
  findings.input->gap_us.assign(150, 20'000);
  EXPECT_EQ(verdict_of(findings, "input"), Verdict::failure);
}

TEST(Doctor, SlowFullAndClosedDisksAreNamed) {
  Findings findings = good_machine();
  findings.disk.commit_us = {900, 900, 600'000};
  EXPECT_EQ(verdict_of(findings, "disk"), Verdict::warning);
  findings.disk.free_bytes = 500'000'000;
  EXPECT_EQ(verdict_of(findings, "disk"), Verdict::warning);
  findings.disk.free_bytes = 50'000'000;
  EXPECT_EQ(verdict_of(findings, "disk"), Verdict::failure);
  findings.disk = {.folder = "/data", .problem = "nothing can be stored"};
  EXPECT_EQ(verdict_of(findings, "disk"), Verdict::failure);
}

TEST(Doctor, ACharacterWithoutAPictureIsNamed) {
  Findings findings = good_machine();
  findings.fonts.missing = {"歩", "é"};
  EXPECT_EQ(verdict_of(findings, "fonts"), Verdict::failure);
  EXPECT_NE(check_of(judge(findings), "fonts").says.find("歩 é"), std::string::npos);
}

TEST(Doctor, AClockIsFineCoarseOrUseless) {
  Findings findings = good_machine();
  findings.clock.step_ns = 50'000;
  EXPECT_EQ(verdict_of(findings, "clock"), Verdict::warning);
  findings.clock.step_ns = 4'000'000;
  EXPECT_EQ(verdict_of(findings, "clock"), Verdict::failure);
  findings.clock = {.step_ns = 20, .ran_back = true};
  EXPECT_EQ(verdict_of(findings, "clock"), Verdict::failure);
}

TEST(Doctor, TheReportIsOneDocument) {
  const Json json = to_json(judge(good_machine()));
  EXPECT_EQ(json["fit"], true);
  EXPECT_EQ(json["checks"][0]["name"], "display");
  EXPECT_EQ(json["checks"][0]["verdict"], "ok");
  EXPECT_EQ(json["checks"][0]["figures"]["width"], 1920);
}

}  // namespace
}  // namespace promenade::app
