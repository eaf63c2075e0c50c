// How long until it is done, where some were stopped before (Kaplan & Meier 1958), with
// Greenwood's standard error and the mean restricted to a horizon.
#pragma once

#include <optional>
#include <vector>

#include "analysis/statistics/interval.h"

namespace promenade::analysis {

struct Duration {
  double time = 0;
  bool done = false;  // false: stopped (censored) then
};

// At one time at which something happened.
struct SurvivalStep {
  double time = 0;
  int at_risk = 0, done = 0, censored = 0;
  double survival = 1;             // the part that takes longer
  std::optional<double> se;        // and its 95 % intervals; nothing where survival is 0
  std::optional<Interval> log;     // on the scale of log S, at most 1
  std::optional<Interval> loglog;  // on that of log(-log S); nothing at S = 1, too
};

struct Survival {
  std::vector<SurvivalStep> steps;        // by time; those who are done come before the stopped
  std::optional<double> median;           // the first time with S <= 1/2
  std::optional<double> median_midpoint;  // as R: halfway where S stays at 1/2
};

Survival kaplan_meier(std::vector<Duration> durations);

struct RestrictedMean {
  double mean = 0;    // the area under S up to tau
  double se = 0;      // sqrt(sum A^2 d / (n (n - d))), A the area to the right of each time
  Interval interval;  // 95 %, normal; cut to 0..tau, between which the mean lies
};

// tau: 0 or more. The last S goes on to tau.
RestrictedMean restricted_mean(const Survival& survival, double tau);

}  // namespace promenade::analysis
