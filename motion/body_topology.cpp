#include "motion/body_topology.h"

#include <algorithm>
#include <cmath>

namespace promenade::motion {
namespace {

int parent_of(const Skeleton& skeleton, int joint) {
  return skeleton.joints[static_cast<std::size_t>(joint)].parent;
}

// How far it is from each joint to the farthest one below it, and where to go.
struct Reach {
  Eigen::VectorXd length;  // J, bones below
  std::vector<int> next;   // child on the way, -1 at a tip
  std::vector<std::vector<int>> children;
};

Reach find_reach(const Skeleton& skeleton, const Eigen::VectorXd& bones) {
  const auto size = static_cast<std::size_t>(skeleton.size());
  Reach reach{Eigen::VectorXd::Zero(skeleton.size()), std::vector<int>(size, -1),
              std::vector<std::vector<int>>(size)};
  for (int j = skeleton.size() - 1; j > 0; --j) {
    const int parent = parent_of(skeleton, j);
    reach.children[static_cast<std::size_t>(parent)].push_back(j);
    const double length = bones(j) + reach.length(j);
    int& next = reach.next[static_cast<std::size_t>(parent)];
    if (next < 0 || length >= reach.length(parent)) {
      reach.length(parent) = length;
      next = j;
    }
  }
  return reach;
}

// The branches of a joint, the longest first.
std::vector<int> branches(const Reach& reach, const Eigen::VectorXd& bones, int joint) {
  std::vector<int> found = reach.children[static_cast<std::size_t>(joint)];
  const auto length = [&](int j) { return bones(j) + reach.length(j); };
  std::sort(found.begin(), found.end(),
            [&](int a, int b) { return length(a) != length(b) ? length(a) > length(b) : a < b; });
  return found;
}

// The first joint, from the root, with at least `count` branches longer than `least`.
int first_fork(const Reach& reach, const Eigen::VectorXd& bones, int from, std::size_t count,
               double least) {
  for (int j = from; j >= 0; j = reach.next[static_cast<std::size_t>(j)]) {
    const std::vector<int> found = branches(reach, bones, j);
    if (found.size() >= count) {
      const int last = found[count - 1];
      if (bones(last) + reach.length(last) > least) return j;
    }
  }
  return -1;
}

// The joints of a limb: the ends of its two longest bones, and what comes before
// and behind them.
struct Limb {
  int before = -1, upper = -1, middle = -1, lower = -1, tip = -1;
};

Limb find_limb(const Skeleton& skeleton, const Reach& reach, const Eigen::VectorXd& bones,
               int branch) {
  std::vector<int> path;
  for (int j = branch; j >= 0; j = reach.next[static_cast<std::size_t>(j)]) path.push_back(j);
  if (path.size() < 3) return {};
  std::vector<int> order(path.begin() + 1, path.end());
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return bones(a) != bones(b) ? bones(a) > bones(b) : a < b; });
  Limb limb;
  limb.middle = std::min(order[0], order[1]);
  limb.lower = std::max(order[0], order[1]);
  limb.upper = parent_of(skeleton, limb.middle);
  if (limb.upper != branch) limb.before = branch;
  for (const int j : path) {
    if (j > limb.lower && bones(j) > 0.05 * bones(limb.lower) && limb.tip < 0) limb.tip = j;
  }
  return limb;
}

void set_leg(NamedJoints& found, const Limb& limb, int shift) {
  found[static_cast<std::size_t>(left_hip + shift)] = limb.upper;
  found[static_cast<std::size_t>(left_knee + shift)] = limb.middle;
  found[static_cast<std::size_t>(left_ankle + shift)] = limb.lower;
  found[static_cast<std::size_t>(left_toe + shift)] = limb.tip;
}

void set_arm(NamedJoints& found, const Limb& limb, int shift) {
  found[static_cast<std::size_t>(left_clavicle + shift)] = limb.before;
  found[static_cast<std::size_t>(left_shoulder + shift)] = limb.upper;
  found[static_cast<std::size_t>(left_elbow + shift)] = limb.middle;
  found[static_cast<std::size_t>(left_wrist + shift)] = limb.lower;
}

void find_upper_body(const Skeleton& skeleton, const Reach& reach, const Eigen::VectorXd& bones,
                     int trunk, double leg, NamedJoints& found) {
  const int fork = first_fork(reach, bones, trunk, 2, 0.4 * leg);
  if (fork < 0) return;
  const std::vector<int> limbs = branches(reach, bones, fork);
  set_arm(found, find_limb(skeleton, reach, bones, limbs[0]), 0);
  set_arm(found, find_limb(skeleton, reach, bones, limbs[1]), right_clavicle - left_clavicle);
  if (limbs.size() < 3) return;
  found[neck] = limbs[2];
  found[head] = reach.next[static_cast<std::size_t>(limbs[2])];
}

}  // namespace

bool is_below(const Skeleton& skeleton, int joint, int ancestor) {
  while (joint > ancestor) joint = parent_of(skeleton, joint);
  return joint == ancestor;
}

int common_ancestor(const Skeleton& skeleton, int a, int b) {
  while (a != b) (a > b ? a : b) = parent_of(skeleton, std::max(a, b));
  return a;
}

bool legs_are_whole(const Skeleton& skeleton, const NamedJoints& joints) {
  for (const int shift : {0, right_hip - left_hip}) {
    const auto at = [&](BodyJoint part) { return joints[static_cast<std::size_t>(part + shift)]; };
    const int hip = at(left_hip), knee = at(left_knee), ankle = at(left_ankle);
    if (hip < 0 || knee <= hip || ankle <= knee) return false;
    if (!is_below(skeleton, knee, hip) || !is_below(skeleton, ankle, knee)) return false;
  }
  const int meet = common_ancestor(skeleton, joints[left_hip], joints[right_hip]);
  return meet != joints[left_hip] && meet != joints[right_hip];
}

NamedJoints joints_by_topology(const Skeleton& skeleton, const Eigen::VectorXd& bones) {
  NamedJoints found;
  found.fill(-1);
  const Reach reach = find_reach(skeleton, bones);
  const int pelvis = first_fork(reach, bones, 0, 3, 0.3 * reach.length(0));
  if (pelvis < 0) return found;
  std::vector<int> limbs = branches(reach, bones, pelvis);
  limbs.resize(3);
  const auto length = [&](int i) {
    const int joint = limbs[static_cast<std::size_t>(i)];
    return bones(joint) + reach.length(joint);
  };
  const bool first_is_trunk = length(0) - length(1) > length(1) - length(2);
  const int trunk = first_is_trunk ? limbs[0] : limbs[2];
  limbs.erase(std::find(limbs.begin(), limbs.end(), trunk));
  set_leg(found, find_limb(skeleton, reach, bones, limbs[0]), 0);
  set_leg(found, find_limb(skeleton, reach, bones, limbs[1]), right_hip - left_hip);
  find_upper_body(skeleton, reach, bones, trunk, length(1), found);
  return found;
}

}  // namespace promenade::motion
