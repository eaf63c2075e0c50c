#include "motion/blemishes.h"

#include <algorithm>

#include "motion/scanner.h"

namespace promenade::motion {
namespace {

using Eigen::Vector3d;

constexpr int least_frozen_figure = 4;
constexpr int least_frozen_joint = 10;
constexpr int most_gaps_of_joint = 50;  // more are the way in which it was written

// From shoulder to wrist, if the arm is straight; else zero.
Vector3d straight_arm(const WorldPose& pose, const BodyMap& body, unsigned side) {
  const auto at = [&](unsigned part) -> Vector3d {
    return pose.positions.col(body.joint[part + side]);
  };
  const Vector3d shoulder = at(left_shoulder), elbow = at(left_elbow), wrist = at(left_wrist);
  const double length = (elbow - shoulder).norm() + (wrist - elbow).norm();
  const Vector3d arm = wrist - shoulder;
  return arm.norm() > 0.95 * length ? arm : Vector3d::Zero();
}

bool has_arms(const BodyMap& body) {
  for (const unsigned part : {left_shoulder, left_elbow, left_wrist}) {
    if (body.borrowed[part] || body.borrowed[part + 4U]) return false;
  }
  return true;
}

// Both arms within 25 degrees of the horizontal and of one line, each to its own side.
bool stands_in_t(const WorldPose& pose, const BodyMap& body, bool z_up) {
  const Vector3d up = z_up ? Vector3d::UnitZ() : Vector3d::UnitY();
  const Vector3d left = straight_arm(pose, body, 0);
  const Vector3d right = straight_arm(pose, body, 4);
  const Vector3d across =
      pose.positions.col(body.joint[left_hip]) - pose.positions.col(body.joint[right_hip]);
  constexpr double sine = 0.42, cosine = 0.64;  // of 25 and 50 degrees
  const double lengths = left.norm() * right.norm();
  return lengths > 0 && std::abs(left.dot(up)) < sine * left.norm() &&
         std::abs(right.dot(up)) < sine * right.norm() && left.dot(right) < -cosine * lengths &&
         left.dot(across) > 0;
}

// The furthest that a joint of the body is from where it was, in lengths of a leg.
double moved(const WorldPose& pose, const WorldPose& before, const BodyMap& body) {
  const auto at = [&](BodyJoint part) -> Vector3d {
    return before.positions.col(body.joint[part]);
  };
  const double leg =
      (at(left_hip) - at(left_knee)).norm() + (at(left_knee) - at(left_ankle)).norm();
  double most = 0;
  for (const int joint : body.joint) {
    most = std::max(most, (pose.positions.col(joint) - before.positions.col(joint)).norm());
  }
  return most / leg;
}

constexpr double little_moved = 0.1;

// Does the figure go on from this frame as no body can: far, and then no further?
bool leaps(const Clip& clip, const BodyMap& body, int frame) {
  const WorldPose before = forward_kinematics(clip, frame);
  const WorldPose pose = forward_kinematics(clip, frame + 1);
  const double leap = moved(pose, before, body);
  if (frame + 2 >= clip.frames()) return leap > little_moved;
  const WorldPose after = forward_kinematics(clip, frame + 2);
  return leap > little_moved && leap > 3 * moved(after, pose, body);
}

bool is_rest_pose(const Clip& clip, int frame) {
  for (const JointChannels& joint : clip.channels) {
    int row = joint.first_row;
    for (const Channel channel : joint.channels) {
      if (is_rotation(channel) && clip.values(row, frame) != 0) return false;
      ++row;
    }
  }
  return true;
}

// Do rows first to last hold the same in this frame and the one before?
bool repeats(const Clip& clip, int first, int count, int frame) {
  const double* const now = clip.values.data() + clip.values.rows() * frame + first;
  return std::equal(now, now + count, now - clip.values.rows());
}

// Runs of at least so many equal frames, and how many frames repeat outside of them.
std::vector<FrameRange> still_runs(const Clip& clip, int first, int count, int least, int& others) {
  std::vector<FrameRange> runs;
  others = 0;
  for (int f = 1, start = 0; f <= clip.frames(); ++f) {
    if (f < clip.frames() && repeats(clip, first, count, f)) continue;
    if (f - start >= least) {
      runs.push_back({start, f - 1});
    } else {
      others += f - 1 - start;
    }
    start = f;
  }
  return runs;
}

bool is_within(const FrameRange& inner, const std::vector<FrameRange>& outer) {
  return std::any_of(outer.begin(), outer.end(), [&](const FrameRange& range) {
    return range.first <= inner.first && inner.last <= range.last;
  });
}

int turning_axes(const Clip& clip, const JointChannels& joint) {
  int count = 0;
  int r = joint.first_row;
  for (const Channel channel : joint.channels) {
    const auto row = clip.values.row(r);
    count += is_rotation(channel) && (row.array() != row(0)).any() ? 1 : 0;
    ++r;
  }
  return count;
}

// Are the values of a joint the same in two frames?
bool same_values(const Clip& clip, const JointChannels& joint, int a, int b) {
  const auto count = static_cast<Eigen::Index>(joint.channels.size());
  return clip.values.block(joint.first_row, a, count, 1) ==
         clip.values.block(joint.first_row, b, count, 1);
}

bool is_turned(const Clip& clip, const JointChannels& joint, int frame) {
  int row = joint.first_row;
  for (const Channel channel : joint.channels) {
    if (is_rotation(channel) && clip.values(row, frame) != 0) return true;
    ++row;
  }
  return false;
}

// Does the joint come to rest in the same way in another run too?
bool returns(const Clip& clip, const JointChannels& joint, const std::vector<FrameRange>& runs,
             const FrameRange& own) {
  return std::any_of(runs.begin(), runs.end(), [&](const FrameRange& run) {
    return run.first != own.first && same_values(clip, joint, run.first, own.first);
  });
}

// A hinge that is held straight repeats, so does a toe on the ground, and so does what is
// written with few digits: only a joint that turns in all ways, does not repeat elsewhere
// and stays in a turned position of no other time is believed.
void add_gaps_of_joint(const Clip& clip, int joint, const std::vector<FrameRange>& of_figure,
                       std::vector<Gap>& gaps) {
  const JointChannels& own = clip.channels[static_cast<std::size_t>(joint)];
  if (own.channels.empty()) return;
  int others = 0;
  const std::vector<FrameRange> runs = still_runs(
      clip, own.first_row, static_cast<int>(own.channels.size()), least_frozen_joint, others);
  int still = others;
  for (const FrameRange& run : runs) still += run.last - run.first;
  if (runs.empty() || static_cast<int>(runs.size()) > most_gaps_of_joint) return;
  if (20 * others > clip.frames() || 2 * still > clip.frames()) return;
  if (turning_axes(clip, own) < 3) return;
  for (const FrameRange& run : runs) {
    const bool rests = !is_turned(clip, own, run.first) || returns(clip, own, runs, run);
    if (!rests && !is_within(run, of_figure)) gaps.push_back({joint, run});
  }
}

std::string text_of(const FrameRange& range) {
  if (range.first == range.last) return std::to_string(range.first);
  return std::to_string(range.first) + " to " + std::to_string(range.last);
}

// "2 to 9, 20 to 31 and 4 more"
std::string text_of(const std::vector<Gap>& gaps, int joint) {
  constexpr int most = 8;
  std::string text;
  int count = 0;
  for (const Gap& gap : gaps) {
    if (gap.joint != joint) continue;
    if (++count <= most) text += (count > 1 ? ", " : "") + text_of(gap.frames);
  }
  return count > most ? text + " and " + std::to_string(count - most) + " more" : text;
}

}  // namespace

int frames_in_t_pose(const Clip& clip, const BodyMap& body, bool z_up) {
  const bool arms = has_arms(body);
  const WorldPose first = forward_kinematics(clip, 0);
  const auto in_t_pose = [&](int frame) {
    if (is_rest_pose(clip, frame)) return true;
    if (!arms) return false;
    const WorldPose pose = forward_kinematics(clip, frame);
    return stands_in_t(pose, body, z_up) && moved(pose, first, body) < little_moved;
  };
  int count = 0;
  while (count < clip.frames() && in_t_pose(count)) ++count;
  if (count == 0 || count == clip.frames()) return 0;
  // Some people walk with their arms held out.
  constexpr double standing_s = 0.25;
  const bool stands = count * clip.frame_time >= standing_s || is_rest_pose(clip, count - 1);
  return stands || leaps(clip, body, count - 1) ? count : 0;
}

std::vector<Gap> find_gaps(const Clip& clip) {
  int others = 0;
  const auto rows = static_cast<int>(clip.values.rows());
  const std::vector<FrameRange> of_figure = still_runs(clip, 0, rows, least_frozen_figure, others);
  std::vector<Gap> gaps;
  for (const FrameRange& run : of_figure) {
    if (run.last - run.first + 1 == clip.frames()) return {};
    gaps.push_back({-1, run});
  }
  for (int j = 0; j < clip.skeleton.size(); ++j) add_gaps_of_joint(clip, j, of_figure, gaps);
  return gaps;
}

std::vector<Problem> describe_blemishes(const Clip& clip, int t_pose_frames,
                                        const std::vector<Gap>& gaps) {
  std::vector<Problem> notes;
  const auto note = [&](std::string message) {
    notes.push_back({clip.file, 0, 0, std::move(message), Severity::warning});
  };
  if (t_pose_frames > 0) {
    note("a T-pose (or rest pose) stands in front of the motion: frame" +
         std::string(t_pose_frames > 1 ? "s " : " ") + text_of({0, t_pose_frames - 1}));
  }
  constexpr std::size_t most = 10;
  int last = -2;
  for (const Gap& gap : gaps) {
    if (gap.joint == last || notes.size() == most) continue;
    last = gap.joint;
    const std::string who =
        last < 0 ? "the figure" : quoted(clip.skeleton.joints[static_cast<std::size_t>(last)].name);
    note(who + " is frozen in place in frames " + text_of(gaps, last) + ": a gap in the recording");
  }
  return notes;
}

}  // namespace promenade::motion
