#include "app/commands/set_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "motion/foot_measures.h"

namespace promenade::app {
namespace {

using motion::Side;

std::string table_row(const motion::MotionSet& set, const motion::CycleReport& report) {
  if (report.cycle.empty()) return fmt::format("refused: {}: {}\n", report.file, report.refusal);
  const int index = motion::find_cycle(set, report.cycle);
  const motion::Cycle& cycle = set.cycles[static_cast<std::size_t>(index)];
  return fmt::format("{:20} {:36} {:7} {:6} {:7.3f} {:5} {:7.1f} {:7.1f} {:6.1f} {:6.1f} {:7.1f}\n",
                     cycle.name, cycle.source, cycle.first_frame, cycle.frames, cycle.seconds,
                     cycle.origin.cycles_found, 1e3 * report.seam.gap_m, 1e3 * report.seam.inside_m,
                     1e3 * std::max(report.slide_left_m, report.slide_right_m),
                     1e3 * cycle.loop_error_m, 1e3 * report.from_capture_m);
}

// Where one foot stands: seconds, the second beyond the cycle where it runs over the seam.
Json contacts_json(const motion::Cycle& cycle) {
  const std::vector<double>& keys = cycle.keytimes;
  return Json::array({{{"foot", "right"}, {"on", keys[1]}, {"off", keys[4]}},
                      {{"foot", "left"}, {"on", keys[3]}, {"off", keys[2] + cycle.seconds}}});
}

// Share of the cycle in which both feet stand.
double double_support(const motion::Cycle& cycle) {
  const std::vector<double>& keys = cycle.keytimes;
  return (keys[2] - keys[1] + keys[4] - keys[3]) / cycle.seconds;
}

void add_seam(const motion::MotionSet& set, const motion::Cycle& cycle, Json& json) {
  const motion::Seam seam = motion::seam(set, cycle);
  json["seam_position_jump_m"] = seam.position_m;
  json["seam_velocity_jump_m_s"] = seam.velocity_m_s;
  json["inside_velocity_jump_m_s"] = seam.inside_m / seam.step_s;
}

void add_feet(const motion::MotionSet& set, const motion::Cycle& cycle, Json& json) {
  for (const char* name : {"stance_slide_left_m", "stance_slide_right_m", "penetration_m",
                           "toe_level_m", "double_support", "contacts"}) {
    json[name] = nullptr;
  }
  if (!set.walk) return;
  json["stance_slide_left_m"] = motion::stance_slide_m(set, cycle, Side::left);
  json["stance_slide_right_m"] = motion::stance_slide_m(set, cycle, Side::right);
  json["penetration_m"] = motion::penetration_m(set, cycle);
  json["toe_level_m"] = motion::toe_level(set, cycle);
  json["double_support"] = double_support(cycle);
  json["contacts"] = contacts_json(cycle);
}

void add_origin(const motion::CycleOrigin& origin, Json& json) {
  json["cycles_found"] = origin.cycles_found;
  json["turn_rad"] = origin.turn;
  json["straightness"] = origin.straightness;
  json["scale"] = origin.scale;
  json["moved_m"] = origin.moved_m;
  json["source_frame_time"] = origin.frame_time;
  json["source_sha256"] = origin.sha256.empty() ? Json() : Json(origin.sha256);
}

Json vector_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Json skeleton_json(const motion::MotionSet& set) {
  Json joints = Json::array(), ends = Json::array(), body = Json::object();
  const auto name = [&set](int joint) {
    return joint < 0 ? Json() : Json(set.skeleton.joints[static_cast<std::size_t>(joint)].name);
  };
  for (const motion::Joint& joint : set.skeleton.joints) {
    joints.push_back({{"name", joint.name},
                      {"parent", name(joint.parent)},
                      {"offset", vector_json(joint.offset)}});
  }
  for (const motion::EndSite& site : set.skeleton.end_sites) {
    ends.push_back({{"joint", name(site.joint)}, {"offset", vector_json(site.offset)}});
  }
  for (std::size_t b = 0; b < motion::body_joint_count; ++b) {
    const auto part = motion::body_joint_name(static_cast<motion::BodyJoint>(b));
    body[std::string(part)] = name(set.body.joint[b]);
  }
  return {{"joints", joints}, {"end_sites", ends}, {"body", body}};
}

Json cycle_json(const motion::MotionSet& set, const motion::Cycle& cycle) {
  Json json = {{"name", cycle.name},
               {"style", cycle.style},
               {"source", cycle.source},
               {"first_frame", cycle.first_frame},
               {"frames", cycle.frames},
               {"seconds", cycle.seconds},
               {"keytimes", cycle.keytimes},
               {"loop_error_m", cycle.loop_error_m},
               {"velocity", {cycle.velocity.x(), cycle.velocity.y()}},
               {"speed_m_s", cycle.velocity.norm()}};
  add_seam(set, cycle, json);
  add_feet(set, cycle, json);
  add_origin(cycle.origin, json);
  return json;
}

}  // namespace

std::string build_table(const motion::BuiltSet& built) {
  std::string text = fmt::format(
      "{:20} {:36} {:>7} {:>6} {:>7} {:>5} {:>7} {:>7} {:>6} {:>6} {:>7}\n", "cycle", "source",
      "first", "frames", "seconds", "found", "seam", "inside", "slide", "loop", "moved");
  for (const motion::CycleReport& report : built.reports) text += table_row(built.set, report);
  text += fmt::format(
      "{} cycles of {} joints. found: cycles that the take offers; seam, inside: largest jump of "
      "a joint in 1/60 s, at\nthe seam and elsewhere; slide: of a standing foot; loop: gap before "
      "it was closed; moved: largest change of a\njoint from the capture; all in mm\n",
      built.set.size(), built.set.skeleton.size());
  return text;
}

Json build_json(const motion::BuiltSet& built) {
  Json list = Json::array();
  for (const motion::CycleReport& report : built.reports) {
    if (report.cycle.empty()) {
      list.push_back({{"source", report.file}, {"refusal", report.refusal}});
      continue;
    }
    const int index = motion::find_cycle(built.set, report.cycle);
    Json cycle = cycle_json(built.set, built.set.cycles[static_cast<std::size_t>(index)]);
    cycle["ankles_moved_m"] = report.plant.moved_m;
    cycle["pelvis_lowered_m"] = report.plant.lowered_m;
    cycle["speed_change_m_s"] = report.plant.speed_change;
    list.push_back(std::move(cycle));
  }
  return list;
}

std::string info_table(const motion::MotionSet& set) {
  std::string text = fmt::format("{}: {} cycles, {} joints\n{}\n\n{:20} {:36} {:>7} {:>6} {:>6}\n",
                                 set.name, set.size(), set.skeleton.size(), set.credit, "cycle",
                                 "source", "seconds", "m/s", "loop");
  for (const motion::Cycle& cycle : set.cycles) {
    text += fmt::format("{:20} {:36} {:7.3f} {:6.2f} {:6.1f}\n", cycle.name, cycle.source,
                        cycle.seconds, cycle.velocity.norm(), 1e3 * cycle.loop_error_m);
  }
  return text + "loop: gap at the seam before it was closed, mm\n";
}

Json info_json(const motion::MotionSet& set) {
  Json cycles = Json::array();
  for (const motion::Cycle& cycle : set.cycles) cycles.push_back(cycle_json(set, cycle));
  return {{"name", set.name},     {"credit", set.credit},
          {"cycles", cycles},     {"skeleton", skeleton_json(set)},
          {"phases", set.phases}, {"key_phases", set.key_phases},
          {"walk", set.walk},     {"unit", "m"}};
}

}  // namespace promenade::app
