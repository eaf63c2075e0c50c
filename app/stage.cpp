#include "app/stage.h"

#include <cmath>

namespace promenade::app {
namespace {

constexpr float figure_pixels = 400;  // at 1280 x 720
constexpr float foot_height = 540;    // from the top of the picture

void turn(std::vector<Part>& parts, float yaw) {
  const Eigen::Matrix3f rotation =
      Eigen::AngleAxisf(yaw, Eigen::Vector3f::UnitY()).toRotationMatrix();
  for (Part& part : parts) {
    part.a = rotation * part.a;
    part.b = rotation * part.b;
    part.thin = rotation * part.thin;
  }
}

}  // namespace

Stage::Stage(const motion::MotionSet& set) : set_(set), mannequin_(make_mannequin(set)) {}

void Stage::advance(std::int64_t now_us, const motion::Cycle* target,
                    const motion::Cycle* created) {
  // After a pause (a page without figures, a stopped program) the walk goes on
  // where it was.
  const std::int64_t passed_us = last_us_ < 0 ? 0 : now_us - last_us_;
  const double seconds = passed_us > 500'000 ? 0 : 1e-6 * static_cast<double>(passed_us);
  last_us_ = now_us;
  const motion::Cycle* pace = created != nullptr ? created : target;
  if (pace != nullptr) {
    phase_ = motion::phase_at(set_, *pace, motion::seconds_at(set_, *pace, phase_) + seconds);
    phase_ -= std::floor(phase_);
  }
  pose(figures_[0], target, seconds);
  pose(figures_[1], created, seconds);
}

void Stage::pose(Figure& figure, const motion::Cycle* cycle, double seconds) {
  figure.present = cycle != nullptr;
  if (cycle == nullptr) return;
  const motion::Pose at = motion::pose_at(set_, *cycle, phase_);
  place_parts(mannequin_, motion::forward_kinematics(set_.skeleton, at), figure.parts);
  turn(figure.parts, start_yaw + orbit_.yaw);
  figure.shadow.splat(figure.parts, shadow_light());
  figure.travel += (cycle->velocity * seconds).cast<float>();
  // The grid repeats every metre.
  figure.travel -= figure.travel.array().floor().matrix();
}

Box Stage::spot(const Layout& layout, Role role) const {
  const Box stage = layout.stage();
  if (!shows(Role::target)) return stage;
  const float half = std::floor(0.5f * stage.width);
  if (role == Role::target) return {stage.x, stage.y, half, stage.height};
  return {stage.x + half, stage.y, stage.width - half, stage.height};
}

void Stage::draw(FigureRenderer& renderer, const Layout& layout, const Palette& palette) {
  for (const Role role : {Role::target, Role::created}) {
    Figure& figure = figures_[role == Role::target ? 0 : 1];
    if (!figure.present) continue;
    const Box box = spot(layout, role);
    const Eigen::Vector2f foot(box.middle_x(), layout.top + layout.size(foot_height));
    figure.view = make_view(orbit_, mannequin_.height, layout.size(figure_pixels), foot, box);
    const bool target = role == Role::target;
    renderer.draw_ground(figure.view,
                         {.ring = target ? palette.target : palette.created,
                          .dashed = target,
                          .travel = figure.travel,
                          .yaw = start_yaw + orbit_.yaw,
                          .stroke = layout.scale},
                         figure.shadow);
  }
  for (const Role role : {Role::target, Role::created}) {
    Figure& figure = figures_[role == Role::target ? 0 : 1];
    if (!figure.present) continue;
    figure.view.clip = layout.stage();
    renderer.draw_parts(figure.view, figure.parts,
                        role == Role::target ? palette.target : palette.created);
  }
}

Eigen::Vector2f Stage::plate(const Layout& layout, Role role) const {
  const Box box = spot(layout, role);
  return {box.middle_x(), layout.top + layout.size(foot_height + 84)};
}

}  // namespace promenade::app
