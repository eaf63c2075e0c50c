#include "motion/graph/window_distance.h"

#include <gtest/gtest.h>

#include "motion/angles.h"
#include "tests/motion/graph/random_clouds.h"

namespace promenade::motion {
namespace {

using Eigen::Vector3d;

struct Windows {
  Clouds a, b;
  std::vector<double> taper;
};

Windows some_windows(std::uint64_t seed) {
  const Clouds a = random_clouds(seed, 6, 5);
  return {a, {random_clouds(seed + 100, 6, 5, 3).points, a.weights}, uneven_taper(6)};
}

WindowDistance closed_form(const Windows& windows) {
  return window_distance(windows.a, 0, windows.b, 5, windows.taper);
}

double sum_under(const Windows& windows, const PlanarMove& move) {
  double sum = 0;
  for (int f = 0; f < 6; ++f) {
    for (int m = 0; m < 5; ++m) {
      const Vector3d p = windows.a.points.col(f * 5 + m), q = windows.b.points.col(f * 5 + m);
      sum += windows.taper[static_cast<std::size_t>(f)] * windows.a.weights(m) *
             (p - moved(move, q)).squaredNorm();
    }
  }
  return sum;
}

Vector3d weighted_mean(const Windows& windows, const Clouds& clouds) {
  Vector3d sum = Vector3d::Zero();
  double weight = 0;
  for (int f = 0; f < 6; ++f) {
    for (int m = 0; m < 5; ++m) {
      const double w = windows.taper[static_cast<std::size_t>(f)] * clouds.weights(m);
      sum += w * clouds.points.col(f * 5 + m);
      weight += w;
    }
  }
  return sum / weight;
}

// The best shift for an angle lays one mean upon the other.
double best_sum_at(const Windows& windows, double theta) {
  const Vector3d a = weighted_mean(windows, windows.a);
  const Vector3d b = moved(PlanarMove{theta, 0, 0}, weighted_mean(windows, windows.b));
  return sum_under(windows, {theta, a.x() - b.x(), a.z() - b.z()});
}

// By trying angles: all around in steps, then the best step in golden sections.
double best_angle(const Windows& windows) {
  const double step = 2 * pi / 720, golden = 0.5 * (std::sqrt(5.0) - 1);
  double best = 0;
  for (int n = 0; n < 720; ++n) {
    if (best_sum_at(windows, n * step) < best_sum_at(windows, best)) best = n * step;
  }
  double low = best - step, high = best + step;
  while (high - low > 1e-9) {
    const double l = high - golden * (high - low), h = low + golden * (high - low);
    (best_sum_at(windows, l) < best_sum_at(windows, h) ? high : low) =
        best_sum_at(windows, l) < best_sum_at(windows, h) ? h : l;
  }
  return 0.5 * (low + high);
}

TEST(WindowDistance, IsTheLeastThatTryingFinds) {
  int far_turns = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Windows windows = some_windows(seed);
    const WindowDistance distance = closed_form(windows);
    const double angle = best_angle(windows);
    // The sum is flat at its least: the angle is found to the root of the rounding.
    EXPECT_NEAR(std::remainder(distance.move.theta - angle, 2 * pi), 0, 1e-6) << seed;
    EXPECT_NEAR(distance.sum, best_sum_at(windows, angle), 1e-12 * distance.sum) << seed;
    far_turns += std::abs(distance.move.theta) > pi / 2 ? 1 : 0;
  }
  EXPECT_GT(far_turns, 2);
}

TEST(WindowDistance, NoShiftIsBetterThanItsOwn) {
  const Windows windows = some_windows(20);
  const WindowDistance distance = closed_form(windows);
  EXPECT_NEAR(sum_under(windows, distance.move), distance.sum, 1e-12 * distance.sum);
  for (const auto& [x, z] : {std::pair(1e-3, 0.0), {-1e-3, 0.0}, {0.0, 1e-3}, {0.0, -1e-3}}) {
    PlanarMove other = distance.move;
    other.x0 += x;
    other.z0 += z;
    EXPECT_GT(sum_under(windows, other), distance.sum);
  }
}

TEST(WindowDistance, AMovedCopyIsFoundAgain) {
  for (const double theta : {0.3, -1.2, 1.8, 2.9, -3.1, pi}) {
    Windows windows = some_windows(30);
    const PlanarMove away{theta, 1.7, -0.4};
    windows.b = moved(away, windows.a);
    const WindowDistance distance = closed_form(windows);
    const PlanarMove back = after(away, distance.move);
    EXPECT_NEAR(std::sin(back.theta), 0, 1e-13) << theta;
    EXPECT_NEAR(back.x0, 0, 1e-13) << theta;
    EXPECT_NEAR(back.z0, 0, 1e-13) << theta;
    EXPECT_LT(distance.rms(), 1e-14);
  }
}

TEST(WindowDistance, AnAngleOfHalfATurnIsPositive) {
  const Clouds a = {Eigen::Matrix3Xd::Identity(3, 3), Eigen::Vector3d::Ones()};
  Clouds b = a;
  b.points.row(0) *= -1;
  b.points.row(2) *= -1;
  EXPECT_EQ(window_distance(a, 0, b, 0, even_taper(1)).move.theta, pi);
  EXPECT_EQ(window_distance(b, 0, a, 0, even_taper(1)).move.theta, pi);
}

TEST(WindowDistance, HeightsAreNotMoved) {
  Windows windows = some_windows(40);
  windows.b = windows.a;
  windows.b.points.row(1).array() += 0.25;
  EXPECT_NEAR(closed_form(windows).rms(), 0.25, 1e-14);
}

TEST(WindowDistance, WhatHasNoWeightDoesNotCount) {
  Windows windows = some_windows(50);
  windows.b = moved({2, 1, 1}, windows.a);
  windows.b.points.middleCols(2 * 5, 5).setRandom();
  windows.taper[2] = 0;
  EXPECT_LT(closed_form(windows).rms(), 1e-14);
}

TEST(WindowDistance, OnePointMeetsAnother) {
  const Clouds a = {Vector3d(1, 2, 3), Eigen::VectorXd::Ones(1)};
  const Clouds b = {Vector3d(-4, 1, 7), Eigen::VectorXd::Ones(1)};
  const WindowDistance distance = window_distance(a, 0, b, 0, even_taper(1));
  EXPECT_EQ(distance.rms(), 1);
  EXPECT_TRUE(std::isfinite(distance.move.theta));
}

}  // namespace
}  // namespace promenade::motion
