#include "motion/foot_contacts.h"

#include <algorithm>
#include <cmath>

#include "motion/leg_ik.h"
#include "motion/quantile.h"

namespace promenade::motion {
namespace {

// A foot comes down when its heel or toe is as low as where it stands (shares of the leg),
// while it may still have this share of the speed of swinging feet: it slides and turns
// on. On generated walks the moment is found to 15 ms.
constexpr double floor_band = 0.005;
constexpr double touch_down_share = 0.2;
constexpr double landing_seconds = 1.0 / 60;  // over which that speed is measured

using BodyCourse = std::vector<Eigen::Matrix<double, 3, body_joint_count>>;

// The points of a foot over time.
struct FootPath {
  std::vector<Eigen::Vector3d> ankle, toe, heel;
  Heel shape;
  double ankle_low = 0, toe_low = 0;  // where they stand
};

FootPath find_path(const BodyCourse& body, const LegJoints& leg) {
  FootPath path;
  std::vector<double> ankle_height, toe_height, lengths;
  for (const auto& frame : body) {
    path.ankle.emplace_back(frame.col(leg.ankle));
    path.toe.emplace_back(frame.col(leg.toe));
    ankle_height.push_back(path.ankle.back().y());
    toe_height.push_back(path.toe.back().y());
    lengths.push_back((path.toe.back() - path.ankle.back()).norm());
  }
  path.ankle_low = quantile(ankle_height, 0.05);
  path.toe_low = quantile(toe_height, 0.05);
  const double length = quantile(lengths, 0.5), drop = path.toe_low - path.ankle_low;
  const double ahead = std::sqrt(std::max(length * length - drop * drop, 0.0));
  path.shape = find_heel(Eigen::Vector3d::Zero(), Eigen::Vector3d(0, drop, ahead));
  for (std::size_t f = 0; f < body.size(); ++f) {
    path.heel.push_back(heel_position(path.shape, path.ankle[f], path.toe[f]));
  }
  return path;
}

// Speed of the slowest point of the foot from now on: a landing foot that was still in the
// air a moment ago is down already.
double speed_from(const FootPath& path, std::size_t f, double frame_time) {
  const auto ahead =
      static_cast<std::size_t>(std::max(std::lround(landing_seconds / frame_time), 1L));
  const std::size_t b = std::min(f + ahead, path.ankle.size() - 1);
  if (b == f) return 0;
  const double seconds = static_cast<double>(b - f) * frame_time;
  double least = INFINITY;
  for (const auto* point : {&path.ankle, &path.toe, &path.heel}) {
    least = std::min(least, ((*point)[b] - (*point)[f]).norm() / seconds);
  }
  return least;
}

FootCourse find_course(const FootPath& path, double frame_time) {
  const std::size_t last = path.ankle.size() - 1;
  FootCourse course;
  for (std::size_t f = 0; f <= last; ++f) {
    const std::size_t a = f > 0 ? f - 1 : 0, b = std::min(f + 1, last);
    const double seconds = static_cast<double>(std::max<std::size_t>(b - a, 1)) * frame_time;
    const auto speed = [&](const std::vector<Eigen::Vector3d>& point) {
      return (point[b] - point[a]).norm() / seconds;
    };
    course.speed.push_back(std::min(speed(path.ankle), speed(path.toe)));
    course.sole_speed.push_back(speed_from(path, f, frame_time));
    course.height.push_back(
        std::min(path.ankle[f].y() - path.ankle_low, path.toe[f].y() - path.toe_low));
    course.sole_height.push_back(std::min(path.heel[f].y(), path.toe[f].y()) - path.toe_low);
  }
  return course;
}

// Where the speed crosses `still` between two frames of which one is below it.
double crossing(const FootCourse& course, std::size_t below, std::size_t above, double still) {
  const double a = course.speed[below], b = course.speed[above];
  const double share = b > a ? std::clamp((still - a) / (b - a), 0.0, 1.0) : 0.5;
  return static_cast<double>(below) +
         share * (static_cast<double>(above) - static_cast<double>(below));
}

std::vector<Stance> stances(const FootCourse& course, double still, double low, double least) {
  const std::size_t frames = course.speed.size();
  const auto stands = [&](std::size_t f) {
    return course.speed[f] < still && course.height[f] < low;
  };
  std::vector<Stance> found;
  for (std::size_t f = 0; f < frames; ++f) {
    if (!stands(f)) continue;
    Stance stance;
    stance.on = f == 0 ? 0 : crossing(course, f, f - 1, still);
    while (f + 1 < frames && stands(f + 1)) ++f;
    stance.off = f + 1 == frames ? static_cast<double>(f) : crossing(course, f, f + 1, still);
    if (!found.empty() && stance.on - found.back().off < least) {
      found.back().off = stance.off;
    } else {
      found.push_back(stance);
    }
  }
  const auto brief = [least](const Stance& stance) { return stance.off - stance.on < least; };
  found.erase(std::remove_if(found.begin(), found.end(), brief), found.end());
  return found;
}

// How high the sole is while it stands: the floor under this step, by the course's measure.
double floor_under(const FootCourse& course, const Stance& stance) {
  const auto from = static_cast<std::ptrdiff_t>(std::ceil(stance.on));
  const auto to = static_cast<std::ptrdiff_t>(std::floor(stance.off));
  if (to < from) return 0;
  return quantile({course.sole_height.begin() + from, course.sole_height.begin() + to + 1}, 0.5);
}

// A foot is down before it is still: it turns about its heel, and slides a little.
double touch_down(const FootCourse& course, const Stance& stance, double slow, double band) {
  const double low = floor_under(course, stance) + band;
  auto f = static_cast<std::size_t>(std::ceil(stance.on));
  while (f > 0 && course.sole_speed[f - 1] < slow && course.sole_height[f - 1] < low) --f;
  if (f == 0 || static_cast<double>(f) >= stance.on) return stance.on;
  const auto since = [f](const std::vector<double>& values, double limit) {
    const double a = values[f], b = values[f - 1];
    return b > limit ? std::clamp((limit - a) / (b - a), 0.0, 1.0) : 1;
  };
  const double share = std::min(since(course.sole_speed, slow), since(course.sole_height, low));
  return std::min(static_cast<double>(f) - share, stance.on);
}

// Frames from each foot's landing to the other's leaving, the median; negative: flight.
double median_overlap(const std::vector<Stance>& a, const std::vector<Stance>& b) {
  std::vector<double> overlaps;
  for (const auto& [landing, leaving] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
    for (const Stance& in : *landing) {
      for (const Stance& out : *leaving) {
        const double middle = 0.5 * (in.on + in.off);
        if (out.on < in.on && out.off < middle && out.off > in.on - (middle - in.on)) {
          overlaps.push_back(out.off - in.on);
        }
      }
    }
  }
  return overlaps.empty() ? 0 : quantile(overlaps, 0.5);
}

}  // namespace

FootContacts find_contacts(const Take& take) {
  BodyCourse body;
  for (int f = 0; f < take.frames(); ++f) body.push_back(body_at(take, f));
  const FootPath left_path = find_path(body, leg_joints(Side::left));
  const FootPath right_path = find_path(body, leg_joints(Side::right));
  FootContacts contacts;
  contacts.left_heel = left_path.shape;
  contacts.right_heel = right_path.shape;
  contacts.left_course = find_course(left_path, take.frame_time);
  contacts.right_course = find_course(right_path, take.frame_time);
  const FootCourse &left = contacts.left_course, &right = contacts.right_course;
  const double swing = 0.5 * (quantile(left.speed, 0.95) + quantile(right.speed, 0.95));
  const double low = 0.07 * leg_length(take.skeleton, take.body);
  const double least = 0.08 / take.frame_time;
  const double wanted_overlap = 0.04 / take.frame_time;
  for (const double share : {0.07, 0.085, 0.1, 0.115}) {
    contacts.still_m_s = std::max(share * swing, 0.05);
    contacts.left = stances(left, contacts.still_m_s, low, least);
    contacts.right = stances(right, contacts.still_m_s, low, least);
    if (median_overlap(contacts.left, contacts.right) >= wanted_overlap) break;
  }
  const double slow = touch_down_share * swing;
  const double band = floor_band * leg_length(take.skeleton, take.body);
  for (auto* foot : {&contacts.left, &contacts.right}) {
    const FootCourse& course = foot == &contacts.left ? left : right;
    for (Stance& stance : *foot) {
      stance.still = stance.on;
      stance.on = touch_down(course, stance, slow, band);
    }
  }
  return contacts;
}

}  // namespace promenade::motion
