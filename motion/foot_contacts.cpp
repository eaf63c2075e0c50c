#include "motion/foot_contacts.h"

#include <algorithm>
#include <cmath>

namespace promenade::motion {
namespace {

// Per frame: speed of the slower one of ankle and toe (m/s), and how far the foot
// is above where it stands (m).
struct FootCourse {
  std::vector<double> speed, height;
};

double quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
  return values[at];
}

using BodyCourse = std::vector<Eigen::Matrix<double, 3, body_joint_count>>;

FootCourse find_course(const BodyCourse& body, double frame_time, BodyJoint ankle, BodyJoint toe) {
  const auto last = static_cast<int>(body.size()) - 1;
  FootCourse course;
  std::vector<double> ankle_height, toe_height;
  for (int f = 0; f <= last; ++f) {
    const int a = std::max(f - 1, 0), b = std::min(f + 1, last);
    const auto& before = body[static_cast<std::size_t>(a)];
    const auto& after = body[static_cast<std::size_t>(b)];
    const double seconds = std::max(b - a, 1) * frame_time;
    course.speed.push_back(std::min((after.col(ankle) - before.col(ankle)).norm(),
                                    (after.col(toe) - before.col(toe)).norm()) /
                           seconds);
    ankle_height.push_back(body[static_cast<std::size_t>(f)](1, ankle));
    toe_height.push_back(body[static_cast<std::size_t>(f)](1, toe));
  }
  const double ankle_low = quantile(ankle_height, 0.05);
  const double toe_low = quantile(toe_height, 0.05);
  for (std::size_t f = 0; f < body.size(); ++f) {
    course.height.push_back(std::min(ankle_height[f] - ankle_low, toe_height[f] - toe_low));
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
  const FootCourse left = find_course(body, take.frame_time, left_ankle, left_toe);
  const FootCourse right = find_course(body, take.frame_time, right_ankle, right_toe);
  const double swing = 0.5 * (quantile(left.speed, 0.95) + quantile(right.speed, 0.95));
  const double low = 0.07 * leg_length(take.skeleton, take.body);
  const double least = 0.08 / take.frame_time;
  const double wanted_overlap = 0.04 / take.frame_time;
  FootContacts contacts;
  for (const double share : {0.07, 0.085, 0.1, 0.115}) {
    contacts.still_m_s = std::max(share * swing, 0.05);
    contacts.left = stances(left, contacts.still_m_s, low, least);
    contacts.right = stances(right, contacts.still_m_s, low, least);
    if (median_overlap(contacts.left, contacts.right) >= wanted_overlap) break;
  }
  return contacts;
}

}  // namespace promenade::motion
