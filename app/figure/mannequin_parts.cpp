#include <cmath>

#include "app/figure/mannequin.h"

namespace promenade::app {
namespace {

using Eigen::Vector3d;
using motion::BodyJoint;

// Left, up, ahead: unit and at right angles.
struct Frame {
  Vector3d left, up, ahead;
};

constexpr double shortest = 0.001;  // metres, of a part's axis

Frame frame_of(const Vector3d& across, const Vector3d& along) {
  const Vector3d up = along.normalized();
  Vector3d ahead = across.cross(up);
  ahead = ahead.norm() > 1e-6 ? ahead.normalized() : Vector3d(Vector3d::UnitZ());
  return {up.cross(ahead), up, ahead};
}

// Collects the parts of one pose. Thicknesses are those of a person with a leg of
// 0.85 m (ours, by eye and by a tape measure).
class Builder {
 public:
  Builder(const Mannequin& mannequin, const motion::WorldPose& pose, std::vector<Part>& parts)
      : m_(mannequin), pose_(pose), parts_(parts) {}

  void build() {
    torso();
    head();
    for (const bool left : {true, false}) {
      arm(left);
      leg(left);
      foot(left);
    }
  }

 private:
  Vector3d at(BodyJoint joint) const { return pose_.positions.col(m_.body.joint[joint]); }
  const Eigen::Quaterniond& turn(BodyJoint joint) const {
    return pose_.rotations[static_cast<std::size_t>(m_.body.joint[joint])];
  }
  static BodyJoint side(bool left, BodyJoint of_left, BodyJoint of_right) {
    return left ? of_left : of_right;
  }

  // Where both ends are in one place it is a ball: an axis must have a direction.
  void add(Vector3d a, Vector3d b, double radius_a, double radius_b,
           const Vector3d& thin = Vector3d::Zero(), double flat = 1) {
    if ((b - a).norm() < shortest) {
      a.y() -= 0.5 * shortest;
      b.y() += 0.5 * shortest;
    }
    Part part;
    part.a = a.cast<float>();
    part.b = b.cast<float>();
    part.radius_a = static_cast<float>(radius_a * m_.scale);
    part.radius_b = static_cast<float>(radius_b * m_.scale);
    const Vector3d axis = (b - a).normalized();
    Vector3d across = thin - axis * axis.dot(thin);
    if (across.norm() < 1e-6) across = axis.unitOrthogonal();
    part.thin = across.normalized().cast<float>();
    part.flat = static_cast<float>(flat);
    parts_.push_back(part);
  }

  void ball(const Vector3d& centre, double radius) {
    add(centre, centre, radius, radius);
    parts_.back().tone = Tone::joint;
  }

  void torso() {
    using namespace motion;
    const double s = m_.scale;
    const Vector3d hips = 0.5 * (at(left_hip) + at(right_hip));
    const Vector3d top = at(neck);
    const Vector3d middle = at(chest);
    const Frame low = frame_of(at(left_hip) - at(right_hip), middle - hips);
    // Some captures have the joints of chest and neck in one place.
    const bool bends = (top - middle).norm() > 0.02 * s;
    const Frame high =
        frame_of(at(left_shoulder) - at(right_shoulder), bends ? top - middle : top - hips);
    const double hip_width = (at(left_hip) - at(right_hip)).norm();
    // The spine bends at the chest's joint; a curve through it hides the corner.
    const auto spine = [&](double t) -> Vector3d {
      const Vector3d control = 2 * middle - 0.5 * (hips + top);
      const Vector3d straight = hips + t * (top - hips);
      const Vector3d curve = (1 - t) * (1 - t) * hips + 2 * t * (1 - t) * control + t * t * top;
      return 0.3 * straight + 0.7 * curve;
    };
    const Vector3d half = low.left * (0.42 * hip_width);
    add(hips + half + 0.03 * s * low.up, hips - half + 0.03 * s * low.up, 0.098, 0.098);
    add(spine(0.1), spine(0.45), 0.135, 0.120, low.ahead, 0.76);
    add(spine(0.40), spine(0.70), 0.122, 0.146, high.ahead, 0.74);
    const Vector3d breast = spine(0.80) - 0.006 * s * high.ahead;
    add(breast + 0.085 * s * high.left, breast - 0.085 * s * high.left, 0.092, 0.092, high.ahead,
        1.0);
    for (const BodyJoint shoulder : {left_shoulder, right_shoulder}) {
      add(spine(0.94), at(shoulder), 0.060, 0.056);
    }
  }

  void head() {
    using namespace motion;
    const double s = m_.scale;
    const Vector3d base = at(motion::head);
    const Vector3d up = turn(motion::head) * m_.head_up;
    const Frame frame = frame_of(up.cross(turn(motion::head) * m_.head_ahead), up);
    add(at(neck), base + 0.03 * s * frame.up + 0.004 * s * frame.ahead, 0.062, 0.055);
    const auto in_head = [&](double upward, double ahead) -> Vector3d {
      return base + s * (upward * frame.up + ahead * frame.ahead);
    };
    add(in_head(0.110, -0.006), in_head(0.030, 0.044), 0.098, 0.050, frame.left, 0.80);
    add(in_head(0.116, -0.016), in_head(0.112, 0.010), 0.096, 0.094, frame.left, 0.82);
    add(in_head(0.098, 0.082), in_head(0.066, 0.094), 0.012, 0.016, frame.left, 0.7);
  }

  void arm(bool left) {
    using namespace motion;
    const double s = m_.scale;
    const Vector3d shoulder = at(side(left, left_shoulder, right_shoulder));
    const Vector3d elbow = at(side(left, left_elbow, right_elbow));
    const Vector3d wrist = at(side(left, left_wrist, right_wrist));
    add(shoulder, elbow, 0.056, 0.040);
    const Vector3d bulge = elbow + 0.25 * (wrist - elbow);
    add(elbow, bulge, 0.040, 0.043);
    add(bulge, wrist, 0.043, 0.027);
    ball(shoulder, 0.062);
    ball(elbow, 0.0425);
    ball(wrist, 0.030);
    const Vector3d along = (wrist - elbow).normalized();
    const Vector3d across = at(left_shoulder) - at(right_shoulder);
    const Frame hand = frame_of(across, -along);
    const Vector3d knuckles = wrist + 0.085 * s * along;
    const Vector3d inward = hand.left * (left ? -1 : 1);
    const Vector3d tips = wrist + s * (0.155 * along + 0.022 * inward);
    add(wrist + 0.02 * s * along, knuckles, 0.030, 0.040, hand.left, 0.46);
    add(knuckles, tips, 0.037, 0.024, hand.left, 0.46);
    add(wrist + s * (0.03 * along + 0.02 * hand.ahead),
        wrist + s * (0.088 * along + 0.044 * hand.ahead + 0.012 * inward), 0.016, 0.012);
  }

  void leg(bool left) {
    using namespace motion;
    const double s = m_.scale;
    const Vector3d hip = at(side(left, left_hip, right_hip));
    const Vector3d knee = at(side(left, left_knee, right_knee));
    const Vector3d ankle = at(side(left, left_ankle, right_ankle));
    const Frame thigh = frame_of(at(left_hip) - at(right_hip), hip - knee);
    add(hip, hip + 0.35 * (knee - hip), 0.092, 0.086);
    add(hip + 0.35 * (knee - hip), knee, 0.086, 0.054);
    add(hip - 0.035 * s * thigh.ahead, hip + 0.12 * (knee - hip) - 0.035 * s * thigh.ahead, 0.088,
        0.080);
    const Frame shin = frame_of(thigh.left, knee - ankle);
    const Vector3d calf = knee + 0.30 * (ankle - knee) - 0.016 * s * shin.ahead;
    add(knee, calf, 0.050, 0.056);
    add(calf, ankle, 0.056, 0.034);
    ball(knee, 0.0555);
    ball(ankle, 0.0375);
  }

  // The sole lies on the ground when the foot stands flat, whatever the skeleton
  // calls its toe.
  void foot(bool left) {
    using namespace motion;
    const double s = m_.scale;
    const std::size_t k = left ? 0 : 1;
    const BodyJoint ankle_joint = side(left, left_ankle, right_ankle);
    const Vector3d ankle = at(ankle_joint);
    const Vector3d toe = at(side(left, left_toe, right_toe));
    const double length = (toe - ankle).norm();
    const Vector3d up = turn(ankle_joint) * m_.foot_up[k];
    Vector3d ahead = turn(ankle_joint) * m_.foot_ahead[k];
    double reach = 0.13 * s;
    if (length > 0.03 * s) {
      const double drop = std::clamp((m_.ankle_height - m_.toe_height) / length, -0.9, 0.9);
      const Frame bent = frame_of(up.cross(toe - ankle), toe - ankle);
      ahead = bent.up * std::sqrt(1 - drop * drop) - bent.ahead * drop;
      reach = std::max(0.09 * s, length * std::sqrt(1 - drop * drop));
    }
    const Frame sole = frame_of(up.cross(ahead), ahead);
    const Vector3d normal = -sole.ahead;
    const auto in_foot = [&](double forward, double over_ground) -> Vector3d {
      return ankle + forward * ahead + (over_ground - m_.ankle_height) * normal;
    };
    const double heel = -0.045 * s;
    const double ball_at = std::min(reach, 0.135 * s);
    add(ankle, in_foot(0.45 * ball_at, 0.048 * s), 0.036, 0.036);
    add(in_foot(heel, 0.034 * s), in_foot(ball_at, 0.027 * s), 0.034, 0.036, normal, 0.75);
    // The toes bend at the ball: they stay on the ground while the heel leaves it.
    const BodyJoint toe_joint = side(left, left_toe, right_toe);
    const bool bends = m_.body.joint[toe_joint] != m_.body.joint[ankle_joint];
    const Vector3d toe_ahead = bends ? turn(toe_joint) * m_.toe_ahead[k] : ahead;
    const Vector3d toe_up = bends ? turn(toe_joint) * m_.toe_up[k] : normal;
    const Vector3d ball_point = in_foot(ball_at, 0.025 * s);
    add(ball_point, ball_point + s * (0.062 * toe_ahead - 0.006 * toe_up), 0.036, 0.027, toe_up,
        0.68);
  }

  const Mannequin& m_;
  const motion::WorldPose& pose_;
  std::vector<Part>& parts_;
};

}  // namespace

void place_parts(const Mannequin& mannequin, const motion::WorldPose& pose,
                 std::vector<Part>& parts) {
  parts.clear();
  Builder(mannequin, pose, parts).build();
}

}  // namespace promenade::app
