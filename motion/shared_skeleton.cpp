#include "motion/shared_skeleton.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/angles.h"

namespace promenade::motion {
namespace {

// Rotations mean the same only where bones at rest point the same way.
constexpr double most_rest_angle = 50 * degree;

const Joint& joint_of(const Skeleton& skeleton, int j) {
  return skeleton.joints[static_cast<std::size_t>(j)];
}

// Some programs put the name of the figure before that of the joint: "Anna:Hips".
std::string plain_name(const std::string& name) { return name.substr(name.rfind(':') + 1); }

std::string parent_name(const Skeleton& skeleton, const Joint& joint) {
  return joint.parent < 0 ? "" : plain_name(joint_of(skeleton, joint.parent).name);
}

bool same_tree(const Skeleton& a, const Skeleton& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t j = 0; j < a.joints.size(); ++j) {
    const Joint &one = a.joints[j], &other = b.joints[j];
    if (plain_name(one.name) != plain_name(other.name) || one.parent != other.parent) return false;
  }
  return true;
}

std::size_t most_common(const std::vector<Take>& takes) {
  std::size_t best = 0;
  std::ptrdiff_t most = 0;
  for (std::size_t i = 0; i < takes.size(); ++i) {
    const auto followers = std::count_if(takes.begin(), takes.end(), [&](const Take& other) {
      return same_tree(takes[i].skeleton, other.skeleton);
    });
    if (followers > most) best = i;
    most = std::max(most, followers);
  }
  return best;
}

// J of `skeleton`: is the joint one of the body, or between two of them?
std::vector<bool> needed_joints(const SharedSkeleton& shared) {
  std::vector<bool> needed(shared.skeleton.joints.size(), false);
  for (int joint : shared.body.joint) {
    for (; joint >= 0; joint = joint_of(shared.skeleton, joint).parent) {
      needed[static_cast<std::size_t>(joint)] = true;
    }
  }
  return needed;
}

// The joint of the take that has the name and the parent of this one; -1: none.
int matching(const Skeleton& wanted, const Joint& joint, const Skeleton& skeleton) {
  for (int j = 0; j < skeleton.size(); ++j) {
    const Joint& other = joint_of(skeleton, j);
    if (plain_name(other.name) == plain_name(joint.name) &&
        parent_name(skeleton, other) == parent_name(wanted, joint)) {
      return j;
    }
  }
  return -1;
}

double rest_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < 6; ++i) text += (i > 0 ? ", " : "") + names[i];
  if (names.size() > 6) text += " and " + std::to_string(names.size() - 6) + " more";
  return text;
}

// For every joint of the shared skeleton that of the take, or -1.
std::vector<int> match(const SharedSkeleton& shared, const Skeleton& skeleton, Fitted& fitted) {
  const std::vector<bool> needed = needed_joints(shared);
  std::vector<int> matches;
  std::vector<std::string> missing, turned;
  for (std::size_t j = 0; j < shared.skeleton.joints.size(); ++j) {
    const Joint& joint = shared.skeleton.joints[j];
    const int found = j == 0 ? 0 : matching(shared.skeleton, joint, skeleton);
    matches.push_back(found);
    if (found < 0) {
      (needed[j] ? missing : fitted.lent).push_back(joint.name);
      continue;
    }
    const Eigen::Vector3d& bone = joint_of(skeleton, found).offset;
    const double least = 0.02;  // metres: shorter bones have no direction to speak of
    if (j > 0 && needed[j] && bone.norm() > least && joint.offset.norm() > least &&
        rest_angle(bone, joint.offset) > most_rest_angle) {
      turned.push_back(joint.name);
    }
  }
  if (!missing.empty()) {
    fitted.refusal = "cannot be brought to the skeleton of the set: it lacks " + listed(missing);
  } else if (!turned.empty()) {
    fitted.refusal =
        "cannot be brought to the skeleton of the set: at rest other bones point elsewhere: " +
        listed(turned);
  }
  return matches;
}

}  // namespace

SharedSkeleton shared_skeleton(const std::vector<Take>& takes, int model) {
  assert(!takes.empty() && model < static_cast<int>(takes.size()) && "a take to follow");
  const Take& leader = takes[model < 0 ? most_common(takes) : static_cast<std::size_t>(model)];
  SharedSkeleton shared{leader.skeleton, leader.body};
  if (model >= 0) return shared;
  for (Joint& joint : shared.skeleton.joints) joint.offset.setZero();
  int followers = 0;
  for (const Take& take : takes) {
    if (!same_tree(leader.skeleton, take.skeleton)) continue;
    ++followers;
    for (std::size_t j = 0; j < shared.skeleton.joints.size(); ++j) {
      shared.skeleton.joints[j].offset += take.skeleton.joints[j].offset;
    }
  }
  for (Joint& joint : shared.skeleton.joints) joint.offset /= static_cast<double>(followers);
  return shared;
}

Fitted fit_to(const SharedSkeleton& shared, const Take& take) {
  Fitted fitted;
  const std::vector<int> matches = match(shared, take.skeleton, fitted);
  if (!fitted.refusal.empty()) return fitted;
  fitted.take = take;
  fitted.take.skeleton = shared.skeleton;
  fitted.take.body = shared.body;
  for (std::size_t j = 0; j < matches.size(); ++j) {
    if (matches[j] < 0) continue;
    fitted.take.skeleton.joints[j].offset = joint_of(take.skeleton, matches[j]).offset;
  }
  for (std::size_t f = 0; f < take.poses.size(); ++f) {
    std::vector<Eigen::Quaterniond>& rotations = fitted.take.poses[f].rotations;
    rotations.assign(matches.size(), Eigen::Quaterniond::Identity());
    for (std::size_t j = 0; j < matches.size(); ++j) {
      if (matches[j] >= 0) {
        rotations[j] = take.poses[f].rotations[static_cast<std::size_t>(matches[j])];
      }
    }
  }
  return fitted;
}

}  // namespace promenade::motion
