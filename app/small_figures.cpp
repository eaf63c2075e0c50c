#include "app/small_figures.h"

#include <algorithm>

namespace promenade::app {
namespace {

Box common(const Box& a, const Box& b) {
  const float x = std::max(a.x, b.x);
  const float y = std::max(a.y, b.y);
  return {x, y, std::max(0.0f, std::min(a.right(), b.right()) - x),
          std::max(0.0f, std::min(a.bottom(), b.bottom()) - y)};
}

// What it stands on.
Part disc(double height) {
  Part part;
  const auto radius = static_cast<float>(0.17 * height);
  part.a = {-0.0005f, -0.004f, 0};
  part.b = {0.0005f, -0.004f, 0};
  part.radius_a = part.radius_b = radius;
  part.thin = Eigen::Vector3f::UnitY();
  part.flat = 0.02f;
  return part;
}

}  // namespace

void SmallFigures::ask(const Box& box, const Box& clip, const Eigen::VectorXd& weights,
                       const Rgb& colour) {
  if (used_ == figures_.size()) {
    figures_.emplace_back();
    figures_.back().blend = motion::make_pose_blend(bank_);
  }
  Figure& figure = figures_[used_++];
  figure.box = box;
  figure.clip = common(box, clip);
  figure.colour = colour;
  if (figure.blend.weights != weights) motion::set_weights(bank_, weights, figure.blend);
}

void SmallFigures::draw(FigureRenderer& renderer, double phase, float yaw, const Rgb& ground) {
  for (std::size_t i = 0; i < used_; ++i) {
    Figure& figure = figures_[i];
    if (figure.clip.width < 1 || figure.clip.height < 1) continue;
    const float pixels = 0.84f * figure.box.height;
    const Eigen::Vector2f foot(figure.box.middle_x(),
                               figure.box.bottom() - 0.08f * figure.box.height);
    const View view = make_view({}, mannequin_.height, pixels, foot, figure.clip);
    parts_.assign(1, disc(mannequin_.height));
    renderer.draw_parts(view, parts_, ground);
    motion::pose_at(bank_, figure.blend, phase, pose_);
    place_parts(mannequin_, motion::forward_kinematics(bank_.set.skeleton, pose_), parts_);
    turn(parts_, yaw);
    renderer.draw_parts(view, parts_, figure.colour);
  }
}

}  // namespace promenade::app
