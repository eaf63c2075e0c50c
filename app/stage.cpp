#include "app/stage.h"

#include <cmath>

namespace promenade::app {

const Rgb& colour_of(const Palette& palette, Role role) {
  switch (role) {
    case Role::target:
      return palette.target;
    case Role::reference:
      return palette.reference;
    case Role::created:
      break;
  }
  return palette.created;
}

Stage::Stage(const motion::MotionSet& set, const motion::PoseBank& bank, bool travels,
             const StimulusList& stimuli)
    : set_(set),
      travels_(travels),
      mannequin_(make_mannequin(set)),
      small_(bank, mannequin_),
      stimuli_(stimuli, set.skeleton, mannequin_) {}

void Stage::advance(std::int64_t now_us, const Cast& cast) {
  // After a pause (a page without figures, a stopped program) the walk goes on
  // where it was.
  const std::int64_t passed_us = last_us_ < 0 ? 0 : now_us - last_us_;
  last_us_ = now_us;
  walk(passed_us > 500'000 ? 0 : 1e-6 * static_cast<double>(passed_us), cast);
  pose(cast);
}

void Stage::enter(const Cast& cast) {
  figure(Role::target).present = cast.target != nullptr || cast.stimulus != nullptr;
  figure(Role::reference).present = cast.reference != nullptr;
  figure(Role::created).present = cast.created != nullptr;
  figure(Role::created).hidden = cast.blind && cast.created != nullptr;
}

void Stage::walk(double seconds, const Cast& cast) {
  enter(cast);
  seconds *= pace_.playing ? pace_.speed : 0;
  if (seconds == 0) return;
  const motion::Cycle* pace = cast.target != nullptr ? cast.target : cast.created;
  // Small figures walk on beside a stimulus.
  if (cast.stimulus != nullptr) pace = &set_.cycles.front();
  const double before = phase_;
  const double reference_before = reference_phase_;
  if (pace != nullptr) phase_ = walked(*pace, before, seconds);
  if (cast.reference != nullptr) {
    reference_phase_ = walked(*cast.reference, reference_before, seconds);
  }
  go(figure(Role::target), cast.target, before, phase_);
  go(figure(Role::reference), cast.reference, reference_before, reference_phase_);
  go(figure(Role::created), cast.created, before, phase_);
  phase_ -= std::floor(phase_);
  reference_phase_ -= std::floor(reference_phase_);
}

void Stage::pose(const Cast& cast) {
  enter(cast);
  stimulus_share_.reset();
  if (cast.stimulus != nullptr) {
    pose(figure(Role::target), *cast.stimulus, cast.stimulus_s);
  } else {
    pose(figure(Role::target), cast.target, phase_);
  }
  pose(figure(Role::reference), cast.reference, reference_phase_);
  pose(figure(Role::created), cast.created, phase_);
}

void Stage::restart() {
  phase_ = reference_phase_ = 0;
  for (Figure& figure : figures_) figure.travel.setZero();
}

// The phase that many seconds later, not wrapped.
double Stage::walked(const motion::Cycle& cycle, double phase, double seconds) const {
  return motion::phase_at(set_, cycle, motion::seconds_at(set_, cycle, phase) + seconds);
}

void Stage::go(Figure& figure, const motion::Cycle* cycle, double before, double phase) {
  // Nothing of a hidden figure may show, not even how fast its ground would go by.
  if (cycle == nullptr || figure.hidden || !travels_) return;
  // In its own time, so that its feet stay where they stand.
  const double seconds =
      motion::seconds_at(set_, *cycle, phase) - motion::seconds_at(set_, *cycle, before);
  figure.travel += (cycle->velocity * seconds).cast<float>();
  // The grid repeats every metre.
  figure.travel -= figure.travel.array().floor().matrix();
}

void Stage::pose(Figure& figure, const motion::Cycle* cycle, double phase) {
  if (cycle == nullptr || figure.hidden) return;
  motion::pose_at(set_, *cycle, phase, pose_);
  motion::forward_kinematics(set_.skeleton, pose_, world_);
  place(figure, mannequin_);
}

// Where it is follows from the time alone.
void Stage::pose(Figure& figure, const study::Stimulus& stimulus, double seconds) {
  const StimulusFigure& shown = stimuli_.of(stimulus);
  const study::StimulusMoment moment = study::moment_of(stimulus, seconds);
  motion::forward_kinematics(stimulus.take.skeleton, shown.pose_at(moment.seconds), world_);
  place(figure, shown.mannequin());
  stimulus_share_ = moment.seconds / stimulus.seconds();
  figure.travel.setZero();
  if (!travels_) return;
  const Eigen::Vector2d way = shown.way(moment);
  figure.travel = (way.array() - way.array().floor()).matrix().cast<float>();
}

// In the pose of `world_`.
void Stage::place(Figure& figure, const Mannequin& mannequin) {
  place_parts(mannequin, world_, figure.parts);
  turn(figure.parts, start_yaw + orbit_.yaw);
  figure.shadow.splat(figure.parts, shadow_light());
  figure.height = mannequin.height;
}

// Those that are there share the stage from left to right.
Box Stage::spot(const Box& stage, Role role) const {
  int count = 0;
  int place = 0;
  for (const Role one : roles) {
    if (one == role) place = count;
    if (shows(one)) ++count;
  }
  const float width = std::floor(stage.width / static_cast<float>(std::max(count, 1)));
  return {stage.x + width * static_cast<float>(place), stage.y, width, stage.height};
}

void Stage::draw_ground(FigureRenderer& renderer, const Layout& layout, const StagePlan& plan,
                        const Palette& palette, Role role) {
  static const Shadow none;
  Figure& shown = figure(role);
  const Box box = spot(plan.figures, role);
  shown.view = make_view(orbit_, shown.hidden ? mannequin_.height : shown.height,
                         plan.figure_height, {box.middle_x(), plan.foot_y}, box);
  renderer.draw_ground(shown.view,
                       {.ring = colour_of(palette, role),
                        .dashed = role == Role::target,
                        .travel = shown.travel,
                        .yaw = start_yaw + orbit_.yaw,
                        .stroke = layout.scale},
                       shown.hidden ? none : shown.shadow);
}

void Stage::draw(FigureRenderer& renderer, const Layout& layout, const StagePlan& plan,
                 const Palette& palette) {
  for (const Role role : roles) {
    if (shows(role)) draw_ground(renderer, layout, plan, palette, role);
  }
  for (const Role role : roles) {
    Figure& shown = figure(role);
    if (!shown.present || shown.hidden) continue;
    shown.view.clip = plan.figures;
    renderer.draw_parts(shown.view, shown.parts, colour_of(palette, role));
  }
}

void Stage::draw_small(FigureRenderer& renderer, const Palette& palette) {
  small_.draw(renderer, phase_, start_yaw + orbit_.yaw, palette.track);
}

Eigen::Vector2f Stage::plate(const StagePlan& plan, Role role) const {
  return {spot(plan.figures, role).middle_x(), plan.plate_y};
}

}  // namespace promenade::app
