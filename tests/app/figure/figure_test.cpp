// The figure by its numbers: measure, ground, quads, shadow and camera.
#include <gtest/gtest.h>

#include <cmath>

#include "app/figure/part_quad.h"
#include "app/figure/shadow.h"
#include "tests/app/panel_bench.h"

namespace promenade::app {
namespace {

std::vector<Part> parts_at(const Mannequin& mannequin, int cycle, double phase) {
  const motion::MotionSet& set = bench::space().set;
  const motion::Pose pose =
      motion::pose_at(set, set.cycles[static_cast<std::size_t>(cycle)], phase);
  std::vector<Part> parts;
  place_parts(mannequin, motion::forward_kinematics(set.skeleton, pose), parts);
  return parts;
}

float lowest(const std::vector<Part>& parts) {
  float low = 1e9f;
  for (const Part& part : parts) {
    // Flattened parts lie flat on the ground where they are lowest.
    low = std::min(
        {low, part.a.y() - part.flat * part.radius_a, part.b.y() - part.flat * part.radius_b});
  }
  return low;
}

TEST(Figure, StandsOnTheGroundInEveryStyle) {
  const Mannequin mannequin = make_mannequin(bench::space().set);
  for (int cycle = 0; cycle < bench::space().set.size(); ++cycle) {
    for (const double phase : {0.0, 0.2, 0.45, 0.7, 0.95}) {
      const float low = lowest(parts_at(mannequin, cycle, phase));
      // A shoe's thickness: the sole is a solid, the skeleton has only a line.
      EXPECT_NEAR(low, 0, 0.03) << bench::space().set.cycles[static_cast<std::size_t>(cycle)].name
                                << " at " << phase;
    }
  }
}

TEST(Figure, IsAsTallAsItSays) {
  const Mannequin mannequin = make_mannequin(bench::space().set);
  const int normal = motion::find_cycle(bench::space().set, "normal");
  float top = 0;
  for (const Part& part : parts_at(mannequin, normal, 0.2)) {
    top = std::max(top, part.a.y() + part.radius_a);
  }
  EXPECT_NEAR(top, mannequin.height, 0.06 * mannequin.height);
}

TEST(Figure, LooksWhereItWalks) {
  const Mannequin mannequin = make_mannequin(bench::space().set);
  // In this skeleton's frames that is +Z, up to how the styles hold their heads.
  EXPECT_GT(mannequin.head_ahead.z(), 0.95);
  EXPECT_GT(mannequin.foot_ahead[0].z(), 0.8);
}

// Captures of the CMU data base have helper joints without length.
TEST(Figure, IsWholeWhereChestAndNeckAreOne) {
  const motion::MotionSet& set = bench::space().set;
  const Mannequin mannequin = make_mannequin(set);
  motion::WorldPose world =
      motion::forward_kinematics(set.skeleton, motion::pose_at(set, set.cycles[0], 0.3));
  world.positions.col(set.body.joint[motion::chest]) =
      world.positions.col(set.body.joint[motion::neck]);
  std::vector<Part> parts;
  place_parts(mannequin, world, parts);
  for (const Part& part : parts) {
    const Eigen::Vector3f axis = (part.b - part.a).normalized();
    EXPECT_NEAR(axis.norm(), 1, 1e-3f);
    EXPECT_NEAR(part.thin.norm(), 1, 1e-5f);
    EXPECT_NEAR(part.thin.dot(axis), 0, 1e-3f);
  }
}

TEST(Figure, EveryPartLiesWithinItsQuad) {
  const View view = make_view({}, 1.7, 400, {424, 540}, {0, 0, 848, 720});
  const Mannequin mannequin = make_mannequin(bench::space().set);
  for (const Part& part : parts_at(mannequin, 0, 0.3)) {
    const PartQuad quad = make_quad(view, part, Rgb::Ones());
    for (int k = 0; k < 64; ++k) {
      const float turn = 0.098f * static_cast<float>(k);
      const Eigen::Vector3f around = std::cos(turn) * view.right + std::sin(turn) * view.up;
      for (const auto& [centre, radius] :
           {std::pair(part.a, part.radius_a), std::pair(part.b, part.radius_b)}) {
        const Eigen::Vector2f away = view.pixel(centre + radius * around) - quad.middle;
        EXPECT_LE(std::abs(away.dot(quad.along)), quad.along.squaredNorm());
        EXPECT_LE(std::abs(away.dot(quad.aside)), quad.aside.squaredNorm());
      }
    }
  }
}

TEST(Figure, ARayThroughAPixelMeetsThePoint) {
  const View view = make_view({0.3f, 0.2f, 1.5f}, 1.7, 400, {424, 540}, {0, 0, 848, 720});
  const Eigen::Vector3f point(0.4f, 1.1f, -0.3f);
  const Eigen::Vector3f ray = view.ray(view.pixel(point));
  EXPECT_LT((point - view.eye).normalized().cross(ray.normalized()).norm(), 1e-5);
}

TEST(Figure, IsDrawnInTheSizeAskedFor) {
  const View view = make_view({}, 1.7, 400, {424, 540}, {0, 0, 848, 720});
  const float top = view.pixel({0, 1.7f, 0}).y();
  const float foot = view.pixel({0, 0, 0}).y();
  EXPECT_NEAR(foot - top, 400, 4);  // seen slightly from above: 1 %
}

TEST(Figure, TheShadowIsDarkestUnderTheFeetAndFadesOut) {
  const Mannequin mannequin = make_mannequin(bench::space().set);
  Shadow shadow;
  shadow.splat(parts_at(mannequin, 0, 0.2), Eigen::Vector3f::UnitY());
  const auto& texels = shadow.texels();
  const auto darkest = std::min_element(texels.begin(), texels.end()) - texels.begin();
  const auto x = static_cast<int>(darkest % shadow_size) - shadow_size / 2;
  const auto z = static_cast<int>(darkest / shadow_size) - shadow_size / 2;
  EXPECT_LT(std::hypot(x, z) * shadow_metres / shadow_size, 0.5);
  EXPECT_LT(texels[static_cast<std::size_t>(darkest)], 0.5f);
  EXPECT_GT(texels[0], 0.97f);
}

TEST(Figure, AShadowOnTheGroundIsSharperThanOneFromAbove) {
  const auto dark_texels = [](float height) {
    Part part;
    part.a = Eigen::Vector3f(0, height, 0);
    part.b = Eigen::Vector3f(0.01f, height, 0);
    part.radius_a = part.radius_b = 0.05f;
    Shadow shadow;
    shadow.splat({part}, Eigen::Vector3f::UnitY());
    return std::count_if(shadow.texels().begin(), shadow.texels().end(),
                         [](float light) { return light < 0.999f; });
  };
  EXPECT_LT(dark_texels(0.05f), dark_texels(0.8f));
}

}  // namespace
}  // namespace promenade::app
