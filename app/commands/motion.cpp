// `promenade motion`: what captures hold.
#include <charconv>
#include <cstdio>
#include <map>

#include "app/commands.h"
#include "app/print.h"
#include "motion/body_mapping.h"
#include "motion/bvh.h"
#include "motion/files.h"
#include "motion/load_clip.h"
#include "motion/scanner.h"

namespace promenade::app {
namespace {

const std::string& joint_name(const motion::Clip& clip, int joint) {
  return clip.skeleton.joints[static_cast<std::size_t>(joint)].name;
}

Json joints_json(const motion::Clip& clip) {
  Json joints = Json::array();
  for (std::size_t j = 0; j < clip.skeleton.joints.size(); ++j) {
    const motion::Joint& joint = clip.skeleton.joints[j];
    Json channels = Json::array();
    for (const motion::Channel channel : clip.channels[j].channels) {
      channels.push_back(motion::channel_name(channel));
    }
    const Json parent = joint.parent < 0 ? Json() : Json(joint_name(clip, joint.parent));
    joints.push_back({{"name", joint.name}, {"parent", parent}, {"channels", channels}});
  }
  return joints;
}

// {"UpperLeg_L": "UpperLeg_R", ...}: every left joint of the body and its other.
Json sides_json(const motion::Clip& clip, const motion::BodyMap& body) {
  Json sides = Json::object();
  for (const motion::BodyJoint part :
       {motion::left_clavicle, motion::left_shoulder, motion::left_elbow, motion::left_wrist,
        motion::left_hip, motion::left_knee, motion::left_ankle, motion::left_toe}) {
    if (body.borrowed[part] || body.borrowed[part + 4u]) continue;
    sides[joint_name(clip, body.joint[part])] = joint_name(clip, body.joint[part + 4u]);
  }
  return sides;
}

Json body_json(const motion::Clip& clip, const motion::BodyMap& map) {
  Json body = Json::object();
  for (std::size_t b = 0; b < motion::body_joint_count; ++b) {
    const auto name = motion::body_joint_name(static_cast<motion::BodyJoint>(b));
    body[std::string(name)] = map.borrowed[b] ? Json() : Json(joint_name(clip, map.joint[b]));
  }
  return body;
}

void add_figure(const motion::Clip& clip, Json& info, std::vector<Problem>& warnings) {
  try {
    const motion::Figure figure = motion::find_figure(clip);
    info["unit_m"] = figure.unit_m;
    info["up"] = figure.z_up ? "z" : "y";
    info["hips"] = joint_name(clip, figure.body.joint[motion::pelvis]);
    info["left_right"] = sides_json(clip, figure.body);
    info["body"] = body_json(clip, figure.body);
    info["heading"] = {figure.heading.x(), figure.heading.y()};
    info["travel_m"] = figure.travel_m;
    warnings.insert(warnings.end(), figure.notes.begin(), figure.notes.end());
  } catch (const InputError& error) {
    // A file without a walking body is still a file whose joints can be told.
    for (const char* key : {"unit_m", "up", "hips", "left_right", "body", "heading", "travel_m"}) {
      info[key] = nullptr;
    }
    for (Problem problem : error.problems()) {
      problem.severity = Severity::warning;
      warnings.push_back(std::move(problem));
    }
  }
}

Json info_json(const motion::Clip& clip) {
  Json info = {{"file", clip.file},
               {"format", clip.format},
               {"joints", joints_json(clip)},
               {"frames", clip.frames()},
               {"frame_time", clip.frame_time},
               {"seconds", clip.frames() * clip.frame_time}};
  std::vector<Problem> warnings = clip.warnings;
  add_figure(clip, info, warnings);
  info["warnings"] = Json::array();
  for (const Problem& warning : warnings) info["warnings"].push_back(to_text(warning));
  return info;
}

// All files are read before anything is said, so that all problems come at once.
std::vector<motion::Clip> load_all(const std::vector<std::string>& files,
                                   const motion::LoadOptions& options) {
  std::vector<motion::Clip> clips;
  std::vector<Problem> problems;
  for (const std::string& file : files) {
    try {
      clips.push_back(motion::load_clip(file, options));
    } catch (const InputError& error) {
      problems.insert(problems.end(), error.problems().begin(), error.problems().end());
    }
  }
  if (!problems.empty()) throw InputError(problems);
  return clips;
}

void print_plainly(const Json& info) {
  const std::string up = info["up"].is_null() ? "?" : info["up"].get<std::string>();
  const std::string hips = info["hips"].is_null() ? "none" : info["hips"].get<std::string>();
  std::printf("%s: %zu joints, %d frames, %s s, %s up, hips %s\n",
              info["file"].get<std::string>().c_str(), info["joints"].size(),
              info["frames"].get<int>(), info["seconds"].dump().c_str(), up.c_str(), hips.c_str());
}

void show_info(const std::vector<std::string>& files, const motion::LoadOptions& options,
               bool json) {
  Json list = Json::array();
  for (const motion::Clip& clip : load_all(files, options)) list.push_back(info_json(clip));
  if (json) return print_json(list);
  for (const Json& info : list) {
    print_plainly(info);
    for (const Json& warning : info["warnings"]) {
      std::fprintf(stderr, "%s\n", warning.get<std::string>().c_str());
    }
  }
}

// "0,,1" has three words; the one between is empty.
std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> words(1);
  for (const char letter : list) {
    if (letter == ',') {
      words.emplace_back();
    } else {
      words.back() += letter;
    }
  }
  return words;
}

Problem frame_trouble(const motion::Clip& clip, const std::string& word, bool number) {
  if (!number) {
    return {"--frames", 0, 0,
            "'" + word + "' is no whole number; numbers of frames from 0 are wanted, as in 0,10",
            Severity::error};
  }
  return {clip.file, 0, 0,
          "has no frame '" + word + "'; its frames are 0 to " + std::to_string(clip.frames() - 1),
          Severity::error};
}

// "0,10,20" as numbers of frames of the clip.
std::vector<int> frame_list(const motion::Clip& clip, const std::string& list) {
  std::vector<int> frames;
  std::vector<Problem> problems;
  for (const std::string& word : split(list)) {
    int frame = 0;
    const char* end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, frame);
    if (error != std::errc() || stop != end || frame < 0 || frame >= clip.frames()) {
      const bool number = stop == end && error != std::errc::invalid_argument;
      problems.push_back(frame_trouble(clip, word, number));
    } else {
      frames.push_back(frame);
    }
  }
  if (!problems.empty()) throw InputError(problems);
  return frames;
}

Json frame_json(const motion::Clip& clip, int frame) {
  const motion::WorldPose world = motion::forward_kinematics(clip, frame);
  Json positions = Json::array();
  for (int j = 0; j < clip.skeleton.size(); ++j) {
    const Eigen::Vector3d at = world.positions.col(j);
    positions.push_back({at.x(), at.y(), at.z()});
  }
  return {{"frame", frame}, {"positions", positions}};
}

std::string line_of(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// Written frame by frame: a long take has more numbers than memory should hold as JSON.
void show_positions(const std::string& file, const std::string& frames,
                    const motion::LoadOptions& options) {
  const motion::Clip clip = motion::load_clip(file, options);
  const std::vector<int> list = frame_list(clip, frames);
  print_problems(clip.warnings);
  Json joints = Json::array();
  for (const motion::Joint& joint : clip.skeleton.joints) joints.push_back(joint.name);
  print_text("{\"file\": " + line_of(file) +
             ", \"unit\": \"file\",\n\"joints\": " + line_of(joints) + ",\n\"frames\": [");
  for (std::size_t i = 0; i < list.size(); ++i) {
    print_text((i == 0 ? "\n" : ",\n") + line_of(frame_json(clip, list[i])));
  }
  print_text("\n]}\n");
}

void convert(const std::string& in, const std::string& out, const motion::LoadOptions& options) {
  if (!motion::same_word(std::filesystem::path(out).extension().string(), ".bvh")) {
    throw InputError(out, "would be a BVH file; give it a name that ends in .bvh");
  }
  std::error_code ignored;
  if (std::filesystem::equivalent(in, out, ignored)) {
    throw InputError(out, "is the capture itself; name another file to write");
  }
  const motion::Clip clip = motion::load_clip(in, options);
  print_problems(clip.warnings);
  write_file(out, motion::bvh_text(clip));
}

void add_load_options(Command command, motion::LoadOptions& options) {
  command.add_option("--skeleton", options.skeleton,
                     "The .asf file of an .amc; looked for beside it if not given");
  command
      .add_option("--rate", options.rate,
                  "Frames a second of an .amc, which does not say it; 120 if not given")
      .range(1.0, 10000.0);
}

void add_info(Command motion_command) {
  struct Arguments {
    std::vector<std::string> files;
    motion::LoadOptions load;
    bool json = false;
  };
  Command command = motion_command.add_subcommand("info", "What capture files hold");
  const auto given = std::make_shared<Arguments>();
  command.add_option("files", given->files, "Captures (.bvh, .amc)").required();
  command.add_flag("--json", given->json, "One JSON document on stdout");
  add_load_options(command, given->load);
  command.callback([given] { show_info(given->files, given->load, given->json); });
}

void add_positions(Command motion_command) {
  struct Arguments {
    std::string file;
    std::string frames;
    motion::LoadOptions load;
    bool json = false;
  };
  Command command = motion_command.add_subcommand(
      "positions", "Joint positions by forward kinematics, as JSON, in units and axes of the file");
  const auto given = std::make_shared<Arguments>();
  command.add_option("file", given->file, "A capture (.bvh, .amc)").required();
  command.add_option("--frames", given->frames, "Frames, counted from 0: A,B,...").required();
  command.add_flag("--json", given->json, "One JSON document on stdout (there is no other form)");
  add_load_options(command, given->load);
  command.callback([given] { show_positions(given->file, given->frames, given->load); });
}

void add_convert(Command motion_command) {
  struct Arguments {
    std::string in, out;
    motion::LoadOptions load;
  };
  Command command = motion_command.add_subcommand("convert", "Any readable capture to plain BVH");
  const auto given = std::make_shared<Arguments>();
  command.add_option("in", given->in, "A capture (.bvh, .amc)").required();
  command.add_option("out", given->out, "The file to write (.bvh)").required();
  add_load_options(command, given->load);
  command.callback([given] { convert(given->in, given->out, given->load); });
}

}  // namespace

void add_motion_command(Command program) {
  Command command = program.add_subcommand("motion", "Look into captures and convert them");
  command.require_subcommand();
  add_info(command);
  add_positions(command);
  add_convert(command);
}

}  // namespace promenade::app
