#include "motion/cycle_search.h"

#include <algorithm>
#include <cmath>

namespace promenade::motion {
namespace {

using Eigen::Vector3d;
using Body = Eigen::Matrix<double, 3, body_joint_count>;

constexpr double velocity_seconds = 0.08;  // what a gap in velocity weighs against one in position
constexpr double least_overlap = 0.025;    // both feet on the ground, share of the cycle
constexpr double most_turn = 0.45;         // radians in one cycle

Body body_velocity(const Take& take, double frame) {
  const double last = take.frames() - 1;
  const double before = std::max(frame - 1, 0.0), after = std::min(frame + 1, last);
  return (body_at(take, after) - body_at(take, before)) / ((after - before) * take.frame_time);
}

Body centred(Body body) {
  const Vector3d mean = body.rowwise().mean();
  body.row(0).array() -= mean.x();
  body.row(2).array() -= mean.z();
  return body;
}

double rms(const Body& gap) { return std::sqrt(gap.colwise().squaredNorm().mean()); }

// Speed over ground, radians turned and so on only make sense for a walk.
std::string trouble_of(const Take& take, const CycleCandidate& cycle) {
  const double seconds = cycle.length() * take.frame_time;
  const Vector3d travel =
      pose_at(take, cycle.keys.back()).root - pose_at(take, cycle.keys.front()).root;
  const double leg = leg_length(take.skeleton, take.body);
  if (seconds < 0.5 || seconds > 4) return "no cycle of 0.5 to 4 seconds";
  if (std::hypot(travel.x(), travel.z()) < 0.25 * leg) return "the figure does not walk on";
  if (std::abs(cycle.turn) > most_turn) return "the figure turns all the time";
  return {};
}

// The stance of `foot` that begins within (from, to), if there is just one.
const Stance* landing_within(const std::vector<Stance>& foot, double from, double to) {
  const Stance* found = nullptr;
  for (const Stance& stance : foot) {
    if (stance.on <= from || stance.on >= to) continue;
    if (found) return nullptr;
    found = &stance;
  }
  return found;
}

// Where a foot leaves before the other lands, both are moved to the middle, so that
// one always stands: the cycle is a walk.
void make_overlap(double& on, double& off, double least) {
  if (off - on >= least) return;
  const double middle = 0.5 * (on + off);
  on = middle - 0.5 * least;
  off = middle + 0.5 * least;
}

bool ascending(const std::array<double, 5>& keys) {
  return std::is_sorted(keys.begin(), keys.end()) && keys[1] - keys[0] > 1 && keys[3] - keys[2] > 1;
}

// The walk from the end of right stance `i` to the end of the next one.
std::optional<CycleCandidate> candidate_at(const Take& take, const FootContacts& contacts,
                                           std::size_t i) {
  const Stance& first = contacts.right[i];
  const Stance& second = contacts.right[i + 1];
  if (second.off >= take.frames() - 1.0) return std::nullopt;  // cut by the end
  const double late = 0.08 / take.frame_time;  // in a light step it lands after the other left
  const Stance* left = landing_within(contacts.left, second.on, second.off + late);
  const Stance* left_before = nullptr;
  for (const Stance& stance : contacts.left) {
    if (stance.on < second.on && stance.off > first.off) left_before = &stance;
  }
  if (!left || !left_before || left == left_before) return std::nullopt;
  CycleCandidate cycle;
  cycle.keys = {first.off, second.on, left_before->off, left->on, second.off};
  const double least = least_overlap * cycle.length();
  make_overlap(cycle.keys[1], cycle.keys[2], least);
  make_overlap(cycle.keys[3], cycle.keys[4], least);
  // What moved the end moves the start: the length stays that of the steps.
  cycle.keys[0] += cycle.keys[4] - second.off;
  if (!ascending(cycle.keys)) return std::nullopt;
  return cycle;
}

// The end moves by up to two frames to where the loop closes best: an instant of
// leaving is known no better than that.
void refine_end(const Take& take, CycleCandidate& cycle) {
  const double reach = std::min(0.07 / take.frame_time, 0.1 * cycle.length());
  const double detected = cycle.keys.back();
  double best = INFINITY;
  for (int step = -8; step <= 8; ++step) {
    const double end = detected + reach * step / 8;
    if (end > take.frames() - 1.0) continue;
    const PoseGap gap = pose_gap(take, cycle.keys.front(), end);
    const double score = std::hypot(gap.position_m, velocity_seconds * gap.velocity_m_s);
    if (score >= best) continue;
    best = score;
    cycle.keys.back() = end;
    cycle.turn = gap.turn;
    cycle.loop_error_m = gap.position_m;
    cycle.velocity_gap = gap.velocity_m_s;
  }
  cycle.keys[3] = std::min(cycle.keys[3], cycle.keys.back() - least_overlap * cycle.length());
  cycle.score = best + 0.1 * std::abs(cycle.turn);
}

double median_length(const std::vector<CycleCandidate>& cycles) {
  std::vector<double> lengths;
  for (const CycleCandidate& cycle : cycles) lengths.push_back(cycle.length());
  std::sort(lengths.begin(), lengths.end());
  return lengths[lengths.size() / 2];
}

}  // namespace

PoseGap pose_gap(const Take& take, double frame, double later) {
  const Body a = centred(body_at(take, frame)), b = centred(body_at(take, later));
  PoseGap gap;
  double sine = 0, cosine = 0;
  for (int j = 0; j < body_joint_count; ++j) {
    sine += b(0, j) * a(2, j) - b(2, j) * a(0, j);
    cosine += a(0, j) * b(0, j) + a(2, j) * b(2, j);
  }
  gap.turn = std::atan2(sine, cosine);
  const Eigen::Matrix3d back = Eigen::AngleAxisd(-gap.turn, Vector3d::UnitY()).toRotationMatrix();
  gap.position_m = rms(a - back * b);
  gap.velocity_m_s = rms(body_velocity(take, frame) - back * body_velocity(take, later));
  return gap;
}

CycleSearch find_cycles(const Take& take, const FootContacts& contacts) {
  CycleSearch search;
  search.refusal = "the feet do not step in turn often enough for one cycle";
  std::vector<CycleCandidate>& found = search.candidates;
  for (std::size_t i = 0; i + 1 < contacts.right.size(); ++i) {
    std::optional<CycleCandidate> cycle = candidate_at(take, contacts, i);
    if (!cycle) continue;
    refine_end(take, *cycle);
    const std::string trouble = trouble_of(take, *cycle);
    if (trouble.empty()) {
      found.push_back(*cycle);
    } else {
      search.refusal = trouble;
    }
  }
  if (found.empty()) return search;
  search.refusal.clear();
  // A cycle that is unlike the others of its take is a start, a stop or a stumble.
  const double usual = median_length(found);
  for (CycleCandidate& cycle : found) {
    cycle.score += 0.1 * std::abs(std::log(cycle.length() / usual));
  }
  std::stable_sort(
      found.begin(), found.end(),
      [](const CycleCandidate& a, const CycleCandidate& b) { return a.score < b.score; });
  return search;
}

Take unrolled(const Take& take) {
  const double seconds = (take.frames() - 1) * take.frame_time;
  if (take.frames() < 3 || seconds > 3 || seconds < 0.5) return take;
  const PoseGap gap = pose_gap(take, 0, take.frames() - 1);
  const Vector3d travel = take.poses.back().root - take.poses.front().root;
  if (gap.position_m > 0.02 || std::abs(gap.turn) > 0.1) return take;
  Take longer = take;
  longer.period = take.frames() - 1;
  for (int turn = 1; turn <= 2; ++turn) {
    for (int f = 1; f < take.frames(); ++f) {
      Pose pose = take.poses[static_cast<std::size_t>(f)];
      pose.root.x() += turn * travel.x();
      pose.root.z() += turn * travel.z();
      for (std::size_t j = 0; j < pose.rotations.size(); ++j) {
        const Eigen::Quaterniond& before = longer.poses.back().rotations[j];
        if (pose.rotations[j].dot(before) < 0) pose.rotations[j].coeffs() *= -1;
      }
      longer.poses.push_back(std::move(pose));
    }
  }
  return longer;
}

}  // namespace promenade::motion
