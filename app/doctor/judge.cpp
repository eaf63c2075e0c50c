#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/doctor/report.h"
#include "motion/quantile.h"

namespace promenade::app {
namespace {

constexpr std::size_t least_frames = 50;    // as Psychtoolbox asks for
constexpr double psychtoolbox_sd_ms = 0.2;  // its gate, Bridges et al. 2020
constexpr double least_on_time = 0.99;      // of the frames
constexpr double good_wait_ms = 2;
constexpr double slow_commit_ms = 50, longest_commit_ms = 500;
constexpr std::int64_t least_bytes = 100'000'000, enough_bytes = 1'000'000'000;
constexpr std::int64_t coarse_ns = 10'000, useless_ns = 1'000'000;

double ms_at(const std::vector<std::int64_t>& times_us, double share) {
  return times_us.empty() ? 0 : 1e-3 * motion::quantile({times_us.begin(), times_us.end()}, share);
}

bool in_software(const std::string& renderer) {
  constexpr std::array<const char*, 5> names = {"llvmpipe", "softpipe", "swrast", "SwiftShader",
                                                "Software Rasterizer"};
  return std::any_of(names.begin(), names.end(),
                     [&](const char* name) { return renderer.find(name) != std::string::npos; });
}

Check judge_display(const DisplayFinding& display) {
  Check check{.name = "display"};
  if (!display.problem.empty()) {
    check.verdict = Verdict::failure;
    check.says = display.problem;
    return check;
  }
  check.figures = {{"width", display.width},
                   {"height", display.height},
                   {"refresh_hz", display.refresh_hz},
                   {"scale", display.scale}};
  check.says = fmt::format("{} x {} pixels at {:g} Hz, scale {:g}", display.width, display.height,
                           display.refresh_hz, display.scale);
  if (display.width < 1280 || display.height < 720) {
    check.verdict = Verdict::warning;
    check.says = fmt::format(
        "the window has only {} x {} pixels; pages are made for 1280 x 720, choose a larger mode",
        display.width, display.height);
  } else if (display.refresh_hz <= 0) {
    check.verdict = Verdict::warning;
    check.says = fmt::format(
        "{} x {} pixels, but the display does not say how often it refreshes, so the program "
        "paces 60 frames a second itself; use a real screen for a study",
        display.width, display.height);
  }
  return check;
}

Check judge_renderer(const DisplayFinding& display) {
  Check check{.name = "renderer"};
  check.figures = {{"renderer", display.renderer}, {"opengl", display.opengl}};
  check.says = "drawn by " + display.renderer;
  if (in_software(display.renderer)) {
    check.verdict = Verdict::warning;
    check.says = "the figures are drawn in software (" + display.renderer +
                 "); install the driver of the graphics card, or let nothing else run beside "
                 "a session";
  }
  return check;
}

struct Pacing {
  double mean_ms = 0, sd_ms = 0, on_time = 0, late = 0;  // the last two: 0 to 1
};

Pacing pacing_of(const PacingFinding& finding) {
  Pacing pacing;
  const auto count = static_cast<double>(finding.interval_us.size());
  const double wanted_ms = 1e3 / finding.wanted_hz;
  for (const std::int64_t time_us : finding.interval_us) {
    const double ms = 1e-3 * static_cast<double>(time_us);
    pacing.mean_ms += ms / count;
    if (std::abs(ms - wanted_ms) <= 0.5 * wanted_ms) pacing.on_time += 1 / count;
    if (ms > 1.5 * wanted_ms) pacing.late += 1 / count;
  }
  double squares = 0;
  for (const std::int64_t time_us : finding.interval_us) {
    squares += std::pow(1e-3 * static_cast<double>(time_us) - pacing.mean_ms, 2);
  }
  if (count > 1) pacing.sd_ms = std::sqrt(squares / (count - 1));
  return pacing;
}

Check judge_pacing(const PacingFinding& finding) {
  Check check{.name = "frames"};
  const Pacing pacing = pacing_of(finding);
  const std::size_t count = finding.interval_us.size();
  check.figures = {{"frames", count},
                   {"wanted_hz", finding.wanted_hz},
                   {"mean_ms", pacing.mean_ms},
                   {"sd_ms", pacing.sd_ms},
                   {"on_time_share", pacing.on_time},
                   {"late_share", pacing.late},
                   {"p99_ms", ms_at(finding.interval_us, 0.99)},
                   {"below_psychtoolbox_sd", count > 1 && pacing.sd_ms < psychtoolbox_sd_ms}};
  check.says = fmt::format(
      "{:.1f} % of {} frames came within half a frame of their time; {:.2f} ms apart, standard "
      "deviation {:.2f} ms (Psychtoolbox asks for less than {:g})",
      100 * pacing.on_time, count, pacing.mean_ms, pacing.sd_ms, psychtoolbox_sd_ms);
  // What shares do not reach by rounding does not decide.
  if (pacing.on_time < least_on_time - 1e-9) {
    check.verdict = Verdict::failure;
    check.says +=
        "; 99 % are needed: close other programs, install the driver of the graphics "
        "card, or use a faster machine";
  } else if (count < least_frames) {
    check.verdict = Verdict::warning;
    check.says += fmt::format("; {} are needed to be sure: give it more --seconds", least_frames);
  }
  return check;
}

Check judge_input(const InputFinding& finding, double wanted_hz) {
  Check check{.name = "input"};
  const double wait_ms = 1e-3 * wait_quantile_us(finding, 0.99);
  const double longest_ms = ms_at(finding.gap_us, 1);
  check.figures = {
      {"polls", finding.gap_us.size()}, {"wait_p99_ms", wait_ms}, {"longest_gap_ms", longest_ms}};
  check.says = fmt::format(
      "while frames are drawn, 99 % of events are stamped within {:.1f} ms, all within {:.1f} ms",
      wait_ms, longest_ms);
  if (wait_ms <= good_wait_ms) return check;
  check.verdict = wait_ms * 1e-3 * wanted_hz <= 1 ? Verdict::warning : Verdict::failure;
  check.says += fmt::format("; {:g} ms are wanted: close other programs, or use a faster machine",
                            good_wait_ms);
  return check;
}

Check judge_disk(const DiskFinding& disk) {
  Check check{.name = "disk"};
  check.figures = {{"folder", disk.folder}};
  if (!disk.problem.empty()) {
    check.verdict = Verdict::failure;
    check.says = disk.problem;
    return check;
  }
  const double median_ms = ms_at(disk.commit_us, 0.5);
  const double worst_ms = ms_at(disk.commit_us, 1);
  check.figures.update({{"commits", disk.commit_us.size()},
                        {"median_ms", median_ms},
                        {"worst_ms", worst_ms},
                        {"free_bytes", disk.free_bytes}});
  check.says = fmt::format(
      "a commit that survives a power cut takes {:.1f} ms, at worst {:.1f} ms; {:.1f} GB are free "
      "in {}",
      median_ms, worst_ms, 1e-9 * static_cast<double>(disk.free_bytes), disk.folder);
  if (disk.free_bytes < enough_bytes) {
    check.verdict = disk.free_bytes < least_bytes ? Verdict::failure : Verdict::warning;
    check.says += "; make room, or name another place with --db";
  } else if (median_ms > slow_commit_ms || worst_ms > longest_commit_ms) {
    check.verdict = Verdict::warning;
    check.says += "; pages after a trial will come late: name a faster disk with --db";
  }
  return check;
}

Check judge_fonts(const FontFinding& fonts) {
  Check check{.name = "fonts", .says = "every character of every text can be shown"};
  check.figures = {{"missing", fonts.missing}};
  if (!fonts.problem.empty()) {
    check.verdict = Verdict::failure;
    check.says = fonts.problem;
  } else if (!fonts.missing.empty()) {
    check.verdict = Verdict::failure;
    check.says = "the fonts lack";
    for (const std::string& character : fonts.missing) check.says += " " + character;
    check.says +=
        "; install the packages fonts-noto-core and fonts-ipafont-gothic of Debian 12, or use "
        "other words";
  }
  return check;
}

Check judge_clock(const ClockFinding& clock) {
  Check check{.name = "clock"};
  check.figures = {
      {"step_ns", clock.step_ns}, {"ran_back", clock.ran_back}, {"source", clock.source}};
  check.says = fmt::format("the clock goes in steps of {} ns", clock.step_ns);
  if (!clock.source.empty()) check.says += " (" + clock.source + ")";
  if (clock.ran_back || clock.step_ns > useless_ns) {
    check.verdict = Verdict::failure;
    check.says = fmt::format("the clock {}; this machine cannot time anything, use another one",
                             clock.ran_back ? "ran backwards" : "has steps of over 1 ms");
  } else if (clock.step_ns > coarse_ns) {
    check.verdict = Verdict::warning;
    check.says += "; a clock source like tsc is finer, see /sys/devices/system/clocksource";
  }
  return check;
}

}  // namespace

// An event in a gap waits for the rest of it; outside, for nothing.
double wait_quantile_us(const InputFinding& input, double share) {
  if (input.gap_us.empty() || input.watched_us <= 0) return 0;
  const double allowed_us = (1 - share) * static_cast<double>(input.watched_us);
  double low = 0;
  auto high = static_cast<double>(*std::max_element(input.gap_us.begin(), input.gap_us.end()));
  for (int k = 0; k < 40; ++k) {
    const double middle = 0.5 * (low + high);
    double beyond_us = 0;  // time at which an event would have to wait longer than this
    for (const std::int64_t gap_us : input.gap_us) {
      beyond_us += std::max(0.0, static_cast<double>(gap_us) - middle);
    }
    (beyond_us > allowed_us ? low : high) = middle;
  }
  return high;
}

DoctorReport judge(const Findings& findings) {
  DoctorReport report;
  report.checks.push_back(judge_display(findings.display));
  if (findings.display.problem.empty()) {
    report.checks.push_back(judge_renderer(findings.display));
  }
  const double wanted_hz = findings.pacing ? findings.pacing->wanted_hz : 60;
  if (findings.pacing) report.checks.push_back(judge_pacing(*findings.pacing));
  if (findings.input) report.checks.push_back(judge_input(*findings.input, wanted_hz));
  report.checks.push_back(judge_disk(findings.disk));
  report.checks.push_back(judge_fonts(findings.fonts));
  report.checks.push_back(judge_clock(findings.clock));
  return report;
}

}  // namespace promenade::app
