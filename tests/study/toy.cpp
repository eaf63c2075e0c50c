#include "toy.h"

#include <algorithm>
#include <cmath>

#include "motion/canonical.h"

namespace promenade::study::toy {
namespace {

using motion::MotionSet;
using motion::Pose;

constexpr double two_pi = 6.283185307179586;

motion::Skeleton skeleton() {
  motion::Skeleton skeleton;
  skeleton.joints = {{"pelvis", -1, {0, 0, 0}},
                     {"chest", 0, {0, 0.5, 0}},
                     {"left_leg", 0, {0.1, -0.5, 0}},
                     {"right_leg", 0, {-0.1, -0.5, 0}}};
  return skeleton;
}

motion::BodyMap body() {
  motion::BodyMap map;
  for (int b = 0; b < motion::body_joint_count; ++b) {
    const bool hip = b == motion::pelvis || b == motion::left_hip || b == motion::right_hip;
    const int joint = hip ? 0 : b < motion::left_hip ? 1 : b < motion::right_hip ? 2 : 3;
    map.joint[static_cast<std::size_t>(b)] = joint;
    map.borrowed[static_cast<std::size_t>(b)] = true;
  }
  return map;
}

Eigen::Quaterniond turn(double angle, const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
}

// A figure that leans by `lean` and tilts by `tilt` while it sways.
Pose pose(double lean, double tilt, double share) {
  Pose pose;
  pose.root = {0, 1 + 0.02 * std::sin(2 * two_pi * share), 1.2 * share};
  pose.rotations.assign(4, Eigen::Quaterniond::Identity());
  pose.rotations[0] = turn(lean + 0.05 * std::sin(two_pi * share), Eigen::Vector3d::UnitX()) *
                      turn(tilt, Eigen::Vector3d::UnitZ());
  return pose;
}

void add_walk(MotionSet& set, const std::string& name, double lean, double tilt, double seconds) {
  std::vector<double> keytimes;
  for (const double phase : set.key_phases) keytimes.push_back(phase * seconds);
  motion::Cycle cycle = motion::canonical_cycle(
      set, keytimes, [&](double t) { return pose(lean, tilt, t / seconds); });
  cycle.name = name;
  cycle.style = name;
  cycle.source = "generated";
  set.cycles.push_back(std::move(cycle));
}

Eigen::VectorXd unit(int size, int at) {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(size);
  weights(at) = 1;
  return weights;
}

class Pick : public InterfaceState {
 public:
  explicit Pick(const InterfaceContext& context)
      : set_(&context.space.set), start_(context.start) {}
  std::unique_ptr<InterfaceState> clone() const override { return std::make_unique<Pick>(*this); }
  Applied apply(const ControlInput& input) override {
    const int found = input.kind == "pick" ? motion::find_cycle(*set_, input.target) : -1;
    if (found >= 0) picked_ = found;
    return found >= 0 ? Applied::done : Applied::refused;
  }
  void weights(std::int64_t, Eigen::VectorXd& weights) const override {
    weights = picked_ < 0 ? start_ : unit(set_->size(), picked_);
  }
  const MotionSet& set() const { return *set_; }

 private:
  const MotionSet* set_;
  Eigen::VectorXd start_;
  int picked_ = -1;
};

class Mix : public InterfaceState {
 public:
  explicit Mix(const InterfaceContext& context)
      : set_(&context.space.set),
        square_(std::get<std::string>(context.parameters.at("rule")) == "square"),
        start_(context.start),
        sliders_(Eigen::VectorXd::Zero(set_->size())) {}
  std::unique_ptr<InterfaceState> clone() const override { return std::make_unique<Mix>(*this); }
  Applied apply(const ControlInput& input) override {
    const int found = input.kind == "slide" ? motion::find_cycle(*set_, input.target) : -1;
    if (found < 0 || !(input.value >= 0 && input.value <= 1)) return Applied::refused;
    sliders_(found) = input.value;
    return Applied::done;
  }
  void weights(std::int64_t, Eigen::VectorXd& weights) const override {
    const Eigen::VectorXd shaped = square_ ? Eigen::VectorXd(sliders_.cwiseAbs2()) : sliders_;
    weights = shaped.sum() > 0 ? Eigen::VectorXd(shaped / shaped.sum()) : start_;
  }
  std::vector<ControlInput> settings() const override {
    std::vector<ControlInput> settings;
    for (int i = 0; i < set_->size(); ++i) {
      settings.push_back({.kind = "slide",
                          .target = set_->cycles[static_cast<std::size_t>(i)].name,
                          .value = sliders_(i)});
    }
    return settings;
  }
  const MotionSet& set() const { return *set_; }

 private:
  const MotionSet* set_;
  bool square_;
  Eigen::VectorXd start_, sliders_;
};

ControlInput control(const char* kind, const std::string& target, double value) {
  ControlInput input;
  input.kind = kind;
  input.target = target;
  input.value = value;
  return input;
}

InterfaceType pick_type() {
  InterfaceType type;
  type.name = "pick";
  type.sentence = "one walk at a time";
  type.start = [](const InterfaceContext& context) { return std::make_unique<Pick>(context); };
  type.simulate = [](const InterfaceState& state, Rng&) {
    std::vector<ControlInput> proposals;
    for (const auto& cycle : dynamic_cast<const Pick&>(state).set().cycles) {
      proposals.push_back(control("pick", cycle.name, 1));
    }
    return proposals;
  };
  return type;
}

InterfaceType mix_type() {
  InterfaceType type;
  type.name = "mix";
  type.sentence = "a slider for each walk";
  type.parameters = {
      {"rule", std::string("share"), {"share", "square"}, "how sliders become weights"},
      {"steps", 0.0, {}, "steps of a slider"},
      {"quick", false, {}, "whether it is quick"}};
  type.start = [](const InterfaceContext& context) { return std::make_unique<Mix>(context); };
  type.simulate = [](const InterfaceState& state, Rng& rng) {
    std::vector<ControlInput> proposals;
    for (const auto& cycle : dynamic_cast<const Mix&>(state).set().cycles) {
      for (int i = 0; i < 3; ++i) proposals.push_back(control("slide", cycle.name, rng.uniform()));
    }
    return proposals;
  };
  return type;
}

InterfaceRegistry make_registry() {
  InterfaceRegistry registry;
  registry.add(pick_type());
  registry.add(mix_type());
  return registry;
}

}  // namespace

MotionSet motion_set() {
  MotionSet set;
  set.name = "toy";
  set.credit = "made by a test";
  set.skeleton = skeleton();
  set.body = body();
  set.phases = 12;
  add_walk(set, "near", 0.0, 0.0, 1.0);
  add_walk(set, "side", 0.1, 0.5, 1.1);
  add_walk(set, "far", 0.7, -0.1, 1.4);
  return set;
}

const InterfaceRegistry& registry() {
  static const InterfaceRegistry registry = make_registry();
  return registry;
}

std::string study_text() {
  return R"([study]
name = "toy"
seed = 7
[[interface]]
name = "pick"
[[interface]]
name = "mix"
[[task]]
name = "copy"
kind = "match"
limit_s = 45
threshold = "auto"
targets = [{ example = "far" }]
practice = [{ example = "side" }]
[[task]]
name = "seek"
kind = "find"
qualities = [{ name = "jolly" }]
[[rating]]
item = "liked"
question = "How did you like it?"
)";
}

StudyBundle bundle(const std::string& text) {
  return read_study("toy.toml", text, registry(),
                    [](const std::string&, const std::string&) { return motion_set(); });
}

}  // namespace promenade::study::toy
