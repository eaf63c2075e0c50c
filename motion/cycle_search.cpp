#include "motion/cycle_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

#include "motion/graph/loops.h"
#include "motion/graph/window_distance.h"

namespace promenade::motion {
namespace {

using Eigen::Vector3d;
using Body = Eigen::Matrix<double, 3, body_joint_count>;

constexpr double velocity_seconds = 0.08;   // what a gap in velocity weighs against one in position
constexpr double window_seconds = 1.0 / 3;  // around either end of a loop
constexpr double least_overlap = 0.025;     // both feet on the ground, share of the cycle
constexpr double most_overlap = 0.35;       // an old or sad walk has up to 0.2
constexpr double most_wander = 0.15;        // leg lengths beside the way that an even turn goes

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

Eigen::Vector2d over_ground(const Take& take, double from, double to) {
  const Vector3d way = pose_at(take, to).root - pose_at(take, from).root;
  return {way.x(), way.z()};
}

// Way from end to end over the way walked, in an eighth of a cycle at a time: sway counts
// little, a curve much.
double straightness_of(const Take& take, const CycleCandidate& cycle) {
  constexpr int steps = 8;
  const double step = cycle.length() / steps;
  double walked = 0;
  for (int k = 0; k < steps; ++k) {
    walked += over_ground(take, cycle.first() + k * step, cycle.first() + (k + 1) * step).norm();
  }
  const double way = over_ground(take, cycle.first(), cycle.keys.back()).norm();
  return walked > 0 ? way / walked : 1;
}

// How far the pelvis gets beside the arc of an even turn from end to end, metres: sway, or
// a cycle that turns there and back and ends as it began.
double wander_m(const Take& take, const CycleCandidate& cycle) {
  const Eigen::Vector2d way = over_ground(take, cycle.first(), cycle.keys.back());
  const Eigen::Vector2d left = Eigen::Vector2d(way.y(), -way.x()).normalized();
  double most = 0;
  for (int k = 1; k < 8; ++k) {
    const double share = k / 8.0;
    const double aside =
        over_ground(take, cycle.first(), cycle.first() + share * cycle.length()).dot(left);
    const double arc = -0.5 * way.norm() * cycle.turn * share * (1 - share);
    most = std::max(most, std::abs(aside - arc));
  }
  return most;
}

// Speed over ground, radians turned and so on only make sense for a walk.
std::string trouble_of(const Take& take, const CycleCandidate& cycle,
                       const CycleSearchOptions& options) {
  const double seconds = cycle.length() * take.frame_time;
  const double leg = leg_length(take.skeleton, take.body);
  if (seconds < 0.5 || seconds > 4) return "last less than 0.5 or more than 4 seconds";
  if (over_ground(take, cycle.first(), cycle.keys.back()).norm() < 0.25 * leg) {
    return "do not walk on";
  }
  const double overlap = std::max(cycle.keys[2] - cycle.keys[1], cycle.keys[4] - cycle.keys[3]);
  if (overlap > most_overlap * cycle.length()) return "stand on both feet for too long";
  if (std::abs(cycle.turn) > options.most_turn) return "turn";
  if (wander_m(take, cycle) > most_wander * leg) return "turn there and back";
  if (cycle.loop_error_m > options.most_loop_error_m) return "do not come back to where they began";
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

bool step_in_turn(const std::vector<double>& keys) {
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
  if (!step_in_turn(cycle.keys)) return std::nullopt;
  return cycle;
}

void note_gap(const Take& take, CycleCandidate& cycle) {
  const PoseGap gap = pose_gap(take, cycle.first(), cycle.keys.back());
  cycle.turn = gap.turn;
  cycle.loop_error_m = gap.position_m;
  cycle.velocity_gap = gap.velocity_m_s;
}

// The body around a frame, in steps of a frame or more, from `before` of them to `after`.
Clouds clouds_around(const Take& take, const Eigen::VectorXd& weights, double frame, double step,
                     int before, int after) {
  Clouds clouds;
  clouds.weights = weights;
  clouds.points.resize(3, body_joint_count * Eigen::Index{before + after + 1});
  for (int p = -before; p <= after; ++p) {
    clouds.points.middleCols<body_joint_count>(body_joint_count * Eigen::Index{before + p}) =
        body_at(take, frame + p * step);
  }
  return clouds;
}

// How unlike the moments around both ends of a loop are.
double window_distance_m(const Take& take, const Eigen::VectorXd& weights, double first,
                         double last) {
  const double half = 0.5 * window_seconds / take.frame_time;
  const int steps = std::clamp(static_cast<int>(half), 1, 5);
  const double step = half / steps;
  const auto room = [step, steps](double frames) {
    return std::min(static_cast<int>(frames / step + 1e-9), steps);
  };
  const int before = room(first), after = room(take.frames() - 1 - last);
  const std::vector<double> taper(static_cast<std::size_t>(before + after + 1), 1);
  const Clouds a = clouds_around(take, weights, first, step, before, after);
  const Clouds b = clouds_around(take, weights, last, step, before, after);
  return window_distance(a, 0, b, before + after, taper).rms();
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
    const double unlike = std::hypot(gap.position_m, velocity_seconds * gap.velocity_m_s);
    if (unlike >= best) continue;
    best = unlike;
    cycle.keys.back() = end;
  }
  cycle.window_m = window_distance_m(take, body_weights(), cycle.first(), cycle.keys.back());
  note_gap(take, cycle);
  cycle.straightness = straightness_of(take, cycle);
  cycle.keys[3] = std::min(cycle.keys[3], cycle.keys.back() - least_overlap * cycle.length());
  cycle.score = cycle.window_m + 0.1 * std::abs(cycle.turn);
}

// Of cycles whose scores round to the same hundredth of a millimetre the earlier one comes first,
// whatever the last digits say.
void best_first(std::vector<CycleCandidate>& cycles) {
  const auto rounded = [](const CycleCandidate& cycle) { return std::round(1e5 * cycle.score); };
  std::stable_sort(cycles.begin(), cycles.end(),
                   [&](const CycleCandidate& a, const CycleCandidate& b) {
                     return std::pair(rounded(a), a.first()) < std::pair(rounded(b), b.first());
                   });
}

double median_length(const std::vector<CycleCandidate>& cycles) {
  std::vector<double> lengths;
  lengths.reserve(cycles.size());
  for (const CycleCandidate& cycle : cycles) lengths.push_back(cycle.length());
  std::sort(lengths.begin(), lengths.end());
  return lengths[lengths.size() / 2];
}

// "of 73 cycles 55 turn, 3 do not walk on": what is wrong, the most frequent first.
std::string said(const std::map<std::string, int>& troubles) {
  std::vector<std::pair<int, std::string>> list;
  for (const auto& [trouble, count] : troubles) list.emplace_back(-count, trouble);
  std::sort(list.begin(), list.end());
  std::string text;
  for (const auto& [count, trouble] : list) {
    text += (text.empty() ? "" : ", ") + std::to_string(-count) + " " + trouble;
  }
  return text;
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

CycleSearch find_cycles(const Take& take, const FootContacts& contacts,
                        const CycleSearchOptions& options) {
  std::map<std::string, int> troubles;
  CycleSearch search;
  std::vector<CycleCandidate>& found = search.candidates;
  for (std::size_t i = 0; i + 1 < contacts.right.size(); ++i) {
    std::optional<CycleCandidate> cycle = candidate_at(take, contacts, i);
    if (!cycle) continue;
    refine_end(take, *cycle);
    const std::string trouble = trouble_of(take, *cycle, options);
    if (trouble.empty()) {
      found.push_back(*cycle);
    } else {
      ++troubles[trouble];
    }
  }
  search.refusal = said(troubles);
  for (const auto& [trouble, count] : troubles) search.refused += count;
  search.turning = troubles["turn"] + troubles["turn there and back"];
  if (found.empty()) {
    if (search.refused == 0) search.refusal = "the feet do not step in turn for a whole cycle";
    return search;
  }
  // A cycle that is unlike the others of its take is a start, a stop or a stumble.
  const double usual = median_length(found);
  for (CycleCandidate& cycle : found) {
    cycle.score += 0.1 * std::abs(std::log(cycle.length() / usual));
  }
  best_first(found);
  return search;
}

CycleSearch find_any_loops(const Take& take, const CycleSearchOptions& options) {
  LoopOptions wanted;
  wanted.threshold_m = options.most_loop_error_m;
  CycleSearch search;
  int turning = 0;
  const double half = 0.5 * (std::round(wanted.window_s / take.frame_time) - 1);
  for (const Match& loop : find_loops(take, wanted)) {
    // In the middle of the windows, which are alike as a whole.
    CycleCandidate cycle = given_cycle(take, {loop.start_a + half, loop.start_b + half});
    cycle.window_m = loop.rms_m;
    if (std::abs(cycle.turn) > options.most_turn) {
      ++turning;
      continue;
    }
    constexpr double same_m = 0.001;  // loops that close better than this are as good
    cycle.score = (cycle.window_m + same_m) * cycle.length();
    search.candidates.push_back(std::move(cycle));
  }
  search.refused = search.turning = turning;
  if (turning > 0) search.refusal = std::to_string(turning) + " turn";
  if (search.candidates.empty() && turning == 0) {
    search.refusal = "it is nowhere like itself half a second to four seconds later";
  }
  best_first(search.candidates);
  return search;
}

std::vector<CycleCandidate> best_apart(const std::vector<CycleCandidate>& all, int count) {
  std::vector<CycleCandidate> chosen;
  for (const CycleCandidate& one : all) {
    const bool apart = std::all_of(chosen.begin(), chosen.end(), [&](const CycleCandidate& other) {
      return one.keys.back() <= other.first() + 1 || one.first() >= other.keys.back() - 1;
    });
    if (apart && static_cast<int>(chosen.size()) < count) chosen.push_back(one);
  }
  std::sort(chosen.begin(), chosen.end(),
            [](const CycleCandidate& a, const CycleCandidate& b) { return a.first() < b.first(); });
  return chosen;
}

std::string trouble_with_keys(const Take& take, const std::vector<double>& keys) {
  if (keys.size() < 2 || keys.front() < 0 || keys.back() > take.frames() - 1.0) {
    return "has frames " + std::to_string(take.first_frame) + " to " +
           std::to_string(take.first_frame + take.frames() - 1) + ", and the cycle lies outside";
  }
  for (std::size_t k = 1; k < keys.size(); ++k) {
    if (keys[k] <= keys[k - 1]) return "cannot have keytimes that do not ascend";
  }
  if (keys.back() - keys.front() < 2) return "cannot have a cycle of less than two frames";
  return {};
}

CycleCandidate given_cycle(const Take& take, std::vector<double> keys) {
  assert(trouble_with_keys(take, keys).empty() && "keytimes of the take");
  CycleCandidate cycle;
  cycle.keys = std::move(keys);
  cycle.window_m = window_distance_m(take, body_weights(), cycle.first(), cycle.keys.back());
  note_gap(take, cycle);
  cycle.straightness = straightness_of(take, cycle);
  return cycle;
}

Take unrolled(Take take) {
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
