// The models behind the interfaces, at the sizes of docs and papers: 27 cycles of 31
// joints on screen, 55 walks on the map. Run: build/release/tests/bench_models
#include <benchmark/benchmark.h>

#include "motion/models/map.h"
#include "motion/models/radial_basis.h"
#include "motion/models/ward.h"
#include "motion/pose_blender.h"
#include "tests/motion/models/random.h"

namespace promenade::motion {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// The body of 20 joints and a chain of further ones.
Skeleton bench_skeleton(int joints, BodyMap& body) {
  Skeleton skeleton;
  Random random(1);
  for (int j = 0; j < joints; ++j) {
    const int parent = j < body_joint_count ? body_parent(static_cast<BodyJoint>(j)) : j - 1;
    skeleton.joints.push_back({"joint", parent, 0.2 * random.normals(3, 1)});
    if (j < body_joint_count) body.joint[static_cast<std::size_t>(j)] = j;
  }
  return skeleton;
}

Cycle bench_cycle(const MotionSet& set, Random& random) {
  const int joints = set.skeleton.size();
  Cycle cycle;
  cycle.seconds = 1 + 0.2 * random.uniform();
  for (const double phase : set.key_phases) cycle.keytimes.push_back(phase * cycle.seconds);
  cycle.rotations.resize(4, set.phases * joints);
  cycle.root = Eigen::Matrix3Xd::Zero(3, set.phases);
  for (int j = 0; j < joints; ++j) {
    const Eigen::Vector3d axis = Eigen::Vector3d(random.normals(3, 1)).normalized();
    for (int f = 0; f < set.phases; ++f) {
      const double angle = 0.4 * std::sin(2 * M_PI * f / set.phases + j);
      cycle.rotations.col(f * joints + j) =
          Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)).coeffs();
    }
  }
  return cycle;
}

const MotionSpace& bench_space() {
  static const MotionSpace space = [] {
    MotionSet set;
    set.skeleton = bench_skeleton(31, set.body);
    Random random(2);
    for (int i = 0; i < 27; ++i) set.cycles.push_back(bench_cycle(set, random));
    return make_motion_space(set);
  }();
  return space;
}

VectorXd positive_weights(std::uint64_t seed) {
  const VectorXd weights = Random(seed).uniforms(27, 1);
  return weights / weights.sum();
}

// Both neighbouring phases are blended anew for each pose, as after a change of weights;
// with `kept` they are there already, as in a walk that goes on.
void pose_of_27_cycles(benchmark::State& state) {
  const PoseBank bank = make_pose_bank(bench_space());
  PoseBlend blend = make_pose_blend(bank);
  set_weights(bank, positive_weights(3), blend);
  Pose pose;
  WorldPose world;
  double phase = 0;
  for (auto _ : state) {
    if (state.range(1) == 0) blend.made.setConstant(false);
    pose_at(bank, blend, phase += 0.0137, pose);
    if (state.range(0) == 1) forward_kinematics(bank.set.skeleton, pose, world);
    benchmark::DoNotOptimize(pose.rotations.data());
    benchmark::DoNotOptimize(world.positions.data());
  }
}
BENCHMARK(pose_of_27_cycles)->ArgNames({"kinematics", "kept"})->ArgsProduct({{0, 1}, {0, 1}});

void new_weights_for_a_pose(benchmark::State& state) {
  const PoseBank bank = make_pose_bank(bench_space());
  PoseBlend blend = make_pose_blend(bank);
  const VectorXd weights = positive_weights(4);
  for (auto _ : state) {
    set_weights(bank, weights, blend);
    benchmark::DoNotOptimize(blend.root.data());
  }
}
BENCHMARK(new_weights_for_a_pose);

// Sliders to weights, to the timing and path, to D and, with 1, to all poses of the cycle.
void a_control_moved(benchmark::State& state) {
  const PoseBank bank = make_pose_bank(bench_space());
  PoseBlend blend = make_pose_blend(bank);
  const RadialBasis basis = fit_radial_basis(Random(5).uniforms(4, 27));
  const VectorXd slider = Random(6).uniforms(4, 1);
  DistancePoints points, target;
  distance_points(bank, blend, target);
  VectorXd weights(27);
  Cycle cycle;
  for (auto _ : state) {
    raw_weights(basis, slider, weights);
    apply_rule(NegativeRule::clamp, weights);
    set_weights(bank, weights, blend);
    if (state.range(0) == 1) blended_cycle(bank, blend, cycle);
    distance_points(bank, blend, points);
    benchmark::DoNotOptimize(distance(points, target));
    benchmark::DoNotOptimize(cycle.rotations.data());
  }
}
BENCHMARK(a_control_moved)->ArgName("whole_cycle")->Arg(0)->Arg(1);

void cycle_by_definition(benchmark::State& state) {
  const VectorXd weights = positive_weights(7);
  for (auto _ : state) benchmark::DoNotOptimize(blend(bench_space(), weights));
}
BENCHMARK(cycle_by_definition);

void cycle_by_definition_and_distance(benchmark::State& state) {
  const MotionSpace& space = bench_space();
  const VectorXd weights = positive_weights(8);
  const DistancePoints target = distance_points(space.set, space.set.cycles[0]);
  for (auto _ : state) {
    benchmark::DoNotOptimize(distance(distance_points(space.set, blend(space, weights)), target));
  }
}
BENCHMARK(cycle_by_definition_and_distance);

void components_of_55_by_5952(benchmark::State& state) {
  const MatrixXd x = Random(9).normals(5952, 55);
  for (auto _ : state) benchmark::DoNotOptimize(principal_components(x));
}
BENCHMARK(components_of_55_by_5952)->Unit(benchmark::kMicrosecond);

void a_move_on_the_map(benchmark::State& state) {
  const Pca pca = principal_components(Random(10).normals(600, 55));
  const auto heuristic = static_cast<MapHeuristic>(state.range(0));
  const Minimap map = make_minimap(pca, {.heuristic = heuristic});
  MapState now = start_map(map);
  VectorXd weights(55);
  std::int64_t t = 0;
  for (auto _ : state) {
    now = move(map, std::move(now), {{0.1, 0.2}, false, t += 8000}, [] { return 0.1; });
    weights_at(map, now, t, weights);
    benchmark::DoNotOptimize(weights.data());
  }
}
BENCHMARK(a_move_on_the_map)->ArgName("heuristic")->DenseRange(0, 3);

void radial_basis_fit(benchmark::State& state) {
  const MatrixXd p = Random(11).uniforms(4, 27);
  for (auto _ : state) benchmark::DoNotOptimize(fit_radial_basis(p));
}
BENCHMARK(radial_basis_fit);

void radial_basis_evaluate(benchmark::State& state) {
  Random random(12);
  const RadialBasis basis = fit_radial_basis(random.uniforms(4, 27));
  const VectorXd at = random.uniforms(4, 1);
  VectorXd weights(27);
  for (auto _ : state) {
    raw_weights(basis, at, weights);
    apply_rule(NegativeRule::clamp, weights);
    benchmark::DoNotOptimize(weights.data());
  }
}
BENCHMARK(radial_basis_evaluate);

void ward_of_points(benchmark::State& state) {
  const MatrixXd points = Random(13).normals(state.range(1), state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(ward(points));
}
BENCHMARK(ward_of_points)
    ->ArgNames({"points", "dimensions"})
    ->Args({27, 2})
    ->Args({27, 10})
    ->Args({5000, 2})
    ->Args({5000, 10})
    ->Unit(benchmark::kMicrosecond);

void ward_of_a_matrix(benchmark::State& state) {
  const MatrixXd distances = euclidean_distances(Random(14).normals(10, state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(ward_of_distances(distances));
}
BENCHMARK(ward_of_a_matrix)->Arg(27)->Arg(5000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace promenade::motion
