// `promenade model`: the models behind the interfaces, without an interface.
#include <fmt/format.h>

#include <memory>

#include "app/commands.h"
#include "app/commands/model_parts.h"
#include "app/commands/numbers.h"
#include "app/print.h"
#include "motion/cycle_clip.h"
#include "study/study.h"

namespace promenade::app {
namespace {

using Eigen::VectorXd;

VectorXd blend_weights(const motion::MotionSet& set, const std::string& text) {
  VectorXd weights = parse_numbers("--weights", text);
  if (weights.size() != set.size()) {
    throw InputError("--weights", fmt::format("{} weights for the {} cycles of {}; give one for "
                                              "each, in the order of `set info`",
                                              weights.size(), set.size(), set.name));
  }
  const double sum = weights.sum();
  if (std::abs(sum - 1) > 1e-3)
    throw InputError("--weights", fmt::format("the weights sum to {}, not to 1", sum));
  return weights / sum;
}

// As many frames as the blended cycles have, so that a unit weight gives the frames that
// `set export` writes for that cycle.
motion::Cycle blended_cycle(const motion::MotionSpace& space, const VectorXd& weights) {
  motion::Cycle cycle = motion::blend(space, weights);
  double frames = 0;
  for (int i = 0; i < space.set.size(); ++i) {
    frames += weights(i) * space.set.cycles[static_cast<std::size_t>(i)].frames;
  }
  cycle.frames = std::max(0, static_cast<int>(std::round(frames)));
  return cycle;
}

struct Frames {
  std::vector<std::string> joints;
  std::vector<Eigen::Matrix3Xd> positions;  // of each frame, 3 x J, metres
  double frame_time = 0;
};

Frames play(const motion::MotionSet& set, const motion::Cycle& cycle) {
  const motion::Clip clip = motion::cycle_clip(set, cycle);
  Frames frames;
  frames.frame_time = clip.frame_time;
  for (const motion::Joint& joint : set.skeleton.joints) frames.joints.push_back(joint.name);
  for (int f = 0; f < clip.frames(); ++f) {
    frames.positions.push_back(motion::forward_kinematics(clip, f).positions);
  }
  return frames;
}

Json position_json(const Eigen::Matrix3Xd& positions) {
  Json points = Json::array();
  for (const auto& at : positions.colwise()) points.push_back({at.x(), at.y(), at.z()});
  return points;
}

std::string frames_csv(const Frames& frames) {
  std::string text = "frame,joint,x,y,z\n";
  for (std::size_t f = 0; f < frames.positions.size(); ++f) {
    for (std::size_t j = 0; j < frames.joints.size(); ++j) {
      const Eigen::Vector3d at = frames.positions[f].col(static_cast<Eigen::Index>(j));
      text +=
          fmt::format("{},{},{},{},{}\n", f, csv_cell(frames.joints[j]), at.x(), at.y(), at.z());
    }
  }
  return text;
}

void show_blend(const std::string& name, const std::string& weights_text, bool csv) {
  const motion::MotionSpace space = motion::make_motion_space(study::load_motion_set(name, ""));
  const VectorXd weights = blend_weights(space.set, weights_text);
  const motion::Cycle cycle = blended_cycle(space, weights);
  const Frames frames = play(space.set, cycle);
  if (csv) return print_text(frames_csv(frames));
  Json positions = Json::array();
  for (const Eigen::Matrix3Xd& one : frames.positions) positions.push_back(position_json(one));
  print_json({{"weights", to_list(weights)},
              {"seconds", cycle.seconds},
              {"keytimes", cycle.keytimes},
              {"frames", frames.positions.size()},
              {"frame_time", frames.frame_time},
              {"velocity", {cycle.velocity.x(), cycle.velocity.y()}},
              {"unit", "m"},
              {"joints", frames.joints},
              {"positions", positions}});
}

void add_blend(Command model) {
  struct Arguments {
    std::string set, weights;
    bool json = false, csv = false;
  };
  Command command = model.add_subcommand("blend", "The cycle of blend weights, as joint positions");
  const auto given = std::make_shared<Arguments>();
  command.add_option("set", given->set, "A file, or builtin:A, B or N").required();
  command.add_option("--weights", given->weights, "w1,w2,...: one for each cycle, sum 1")
      .required();
  command.add_flag("--csv", given->csv, "Rows of frame, joint, x, y, z");
  command.add_flag("--json", given->json, "One JSON document (as without it)").excludes("--csv");
  command.callback([given] { show_blend(given->set, given->weights, given->csv); });
}

}  // namespace

void add_model_command(Command program) {
  Command command = program.add_subcommand("model", "The models behind the interfaces");
  command.require_subcommand();
  add_blend(command);
  add_model_map(command);
  add_model_features(command);
  add_model_adjectives(command);
  add_model_raters(command);
  add_model_targets(command);
  add_model_outcomes(command);
}

}  // namespace promenade::app
