#include "app/small_figures.h"

#include <algorithm>

namespace promenade::app {
namespace {

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

Box common_box(const Box& a, const Box& b) {
  const float x = std::max(a.x, b.x);
  const float y = std::max(a.y, b.y);
  return {x, y, std::max(0.0f, std::min(a.right(), b.right()) - x),
          std::max(0.0f, std::min(a.bottom(), b.bottom()) - y)};
}

void draw_small_figure(FigureRenderer& renderer, const Box& box, const Box& clip, double height,
                       const std::vector<Part>& parts, const Rgb& colour, const Rgb& ground) {
  if (clip.width < 1 || clip.height < 1) return;
  const float pixels = 0.84f * box.height;
  const Eigen::Vector2f foot(box.middle_x(), box.bottom() - 0.08f * box.height);
  const View view = make_view({}, height, pixels, foot, clip);
  thread_local std::vector<Part> under(1);  // its memory is kept
  under[0] = disc(height);
  renderer.draw_parts(view, under, ground);
  renderer.draw_parts(view, parts, colour);
}

void SmallFigures::ask(const Box& box, const Box& clip, const Eigen::VectorXd& weights,
                       const Rgb& colour) {
  if (used_ == figures_.size()) {
    figures_.emplace_back();
    figures_.back().blend = motion::make_pose_blend(bank_);
  }
  Figure& figure = figures_[used_++];
  figure.box = box;
  figure.clip = common_box(box, clip);
  figure.colour = colour;
  if (figure.blend.weights != weights) motion::set_weights(bank_, weights, figure.blend);
}

void SmallFigures::draw(FigureRenderer& renderer, double phase, float yaw, const Rgb& ground) {
  for (std::size_t i = 0; i < used_; ++i) {
    Figure& figure = figures_[i];
    if (figure.clip.width < 1 || figure.clip.height < 1) continue;
    motion::pose_at(bank_, figure.blend, phase, pose_);
    place_parts(mannequin_, motion::forward_kinematics(bank_.set.skeleton, pose_), parts_);
    turn(parts_, yaw);
    draw_small_figure(renderer, figure.box, figure.clip, mannequin_.height, parts_, figure.colour,
                      ground);
  }
}

}  // namespace promenade::app
