// A small motion set with numbers of no meaning, for tests of what must hold for
// any set. Random numbers from a generator of its own: the same on every machine.
#pragma once

#include <cmath>
#include <cstdint>

#include "motion/motion_set.h"

namespace promenade::motion {

class ToyRandom {
 public:
  explicit ToyRandom(std::uint64_t seed) : state_(seed * 2654435769u + 1) {}
  // From -1 to 1.
  double operator()() {
    state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(state_ >> 11) / 4503599627370496.0 - 1;
  }

 private:
  std::uint64_t state_;
};

inline Eigen::Quaterniond toy_rotation(ToyRandom& random, double size) {
  const Eigen::Vector3d axis(random(), random(), random());
  const double angle = size * axis.norm();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis.normalized()));
}

// Body joint b is joint b of the skeleton.
inline Skeleton toy_skeleton(BodyMap& body) {
  Skeleton skeleton;
  ToyRandom random(7);
  for (int b = 0; b < body_joint_count; ++b) {
    const auto joint = static_cast<BodyJoint>(b);
    skeleton.joints.push_back({std::string(body_joint_name(joint)),
                               body_parent(joint),
                               {0.2 * random(), 0.4 * random(), 0.2 * random()}});
    body.joint[static_cast<std::size_t>(b)] = b;
  }
  skeleton.end_sites.push_back({head, {0, 0.2, 0}});
  return skeleton;
}

// A loop through `harmonics` sines per joint, of about `size` radians around 0.
inline Cycle toy_cycle(const MotionSet& set, std::uint64_t seed, double size = 0.4) {
  ToyRandom random(seed);
  const int joints = set.skeleton.size();
  Cycle cycle;
  cycle.name = "toy_" + std::to_string(seed);
  cycle.style = "toy";
  cycle.source = "generated";
  cycle.seconds = 1.1 + 0.2 * random();
  for (const double phase : set.key_phases) cycle.keytimes.push_back(phase * cycle.seconds);
  for (std::size_t k = 1; k + 1 < cycle.keytimes.size(); ++k) cycle.keytimes[k] += 0.03 * random();
  cycle.rotations.resize(4, set.phases * joints);
  cycle.root.resize(3, set.phases);
  for (int j = 0; j < joints; ++j) {
    const Eigen::Vector3d a(random(), random(), random()), b(random(), random(), random());
    for (int f = 0; f < set.phases; ++f) {
      const double angle = 2 * M_PI * f / set.phases;
      const Eigen::Vector3d turn = size * (a + b * std::sin(angle));
      cycle.rotations.col(f * joints + j) =
          Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized())).coeffs();
    }
  }
  for (int f = 0; f < set.phases; ++f) {
    const double angle = 2 * M_PI * f / set.phases;
    cycle.root.col(f) << 0.02 * std::sin(angle), 0.9 + 0.02 * std::cos(2 * angle), 0;
  }
  cycle.velocity << 0.01 * random(), 1.2 + 0.3 * random();
  cycle.loop_error_m = 0.01;
  return cycle;
}

inline MotionSet toy_set(int cycles, int phases = 12) {
  MotionSet set;
  set.name = "toys";
  set.credit = "nobody";
  set.skeleton = toy_skeleton(set.body);
  set.phases = phases;
  for (int i = 0; i < cycles; ++i) {
    set.cycles.push_back(toy_cycle(set, static_cast<std::uint64_t>(i + 1)));
  }
  return set;
}

}  // namespace promenade::motion
