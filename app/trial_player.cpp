#include "app/trial_player.h"

#include <algorithm>

#include "app/trial_cast.h"

namespace promenade::app {
namespace {

constexpr std::int64_t grain_us = 1000;

std::int64_t whole_grains(std::int64_t t_us) { return t_us / grain_us * grain_us; }

// What ended the trial is no longer part of it: the page after it would be shown.
std::size_t end_of(const study::LoggedSession& log, int trial) {
  std::size_t last = 0;
  for (std::size_t i = 0; i < log.steps.size(); ++i) {
    if (log.steps[i].trial == trial) last = i;
  }
  const bool ended = !log.trials[static_cast<std::size_t>(trial)].outcome.empty();
  return ended ? last : last + 1;
}

std::int64_t length_of(const study::LoggedSession& log, int trial, std::size_t end) {
  const study::LoggedTrial& one = log.trials[static_cast<std::size_t>(trial)];
  const std::int64_t last_us = !one.outcome.empty() ? one.ended.t_us
                               : end > 0            ? log.steps[end - 1].t_us()
                                                    : 0;
  return whole_grains(std::max<std::int64_t>(0, last_us - one.started_us) + grain_us - 1);
}

}  // namespace

TrialPlayer::TrialPlayer(const study::StudyBundle& bundle, const study::InterfaceRegistry& registry,
                         const study::LoggedSession& log, int trial)
    : bundle_(bundle),
      registry_(registry),
      log_(log),
      index_(trial),
      trial_(log.trials[static_cast<std::size_t>(trial)]),
      end_(end_of(log, trial)),
      length_us_(length_of(log, trial, end_)),
      stage_(bundle.space.set, bundle.bank, bundle.study.display.travels, bundle.study.stimuli),
      blend_(motion::make_pose_blend(bundle.bank)) {
  restart();
}

void TrialPlayer::restart() {
  session_ = study::session_of(bundle_, registry_, log_);
  stage_.restart();
  next_ = 0;
  t_us_ = 0;
  camera_attempt_ = {-1, 0};
  // Trials are logged as they begin.
  for (int begun = -1; begun < index_ && next_ < end_;) {
    for (const study::Record& record : take_step()) {
      if (std::holds_alternative<study::TrialStarted>(record)) ++begun;
    }
  }
  pressed_.reset();
  if (session_->trial() == nullptr) {
    throw InputError("trial " + trial_.uuid,
                     "was over as it began, because its guess had won; there is nothing to play");
  }
  pass(trial_.started_us);
  measure();
}

std::vector<study::Record> TrialPlayer::take_step() {
  const study::Input input = study::input_of(log_.steps[next_++]);
  std::vector<study::Record> records = session_->step(input);
  follow(input);
  return records;
}

// What the screen did with it: as the trial's page does (app/screens/trial.cpp).
void TrialPlayer::follow(const study::Input& input) {
  const study::TrialState* trial = session_->trial();
  if (trial != nullptr && std::pair(trial->index, trial->attempt) != camera_attempt_) {
    camera_attempt_ = {trial->index, trial->attempt};
    stage_.orbit() = {};
    stage_.pace() = {};
  }
  if (const auto* camera = std::get_if<study::Camera>(&input.action)) {
    const auto narrow = [](double value) { return static_cast<float>(value); };
    stage_.orbit() = {narrow(camera->yaw), narrow(camera->pitch), narrow(camera->zoom),
                      narrow(camera->right), narrow(camera->up)};
  } else if (const auto* playback = std::get_if<study::Playback>(&input.action)) {
    stage_.pace() = {playback->playing, playback->speed};
    if (playback->phase >= 0) stage_.scrub(playback->phase);
  } else if (std::holds_alternative<study::Press>(input.action) && trial != nullptr) {
    pressed_ = {input.t_us - trial_.started_us, input.x, input.y};
  }
}

void TrialPlayer::move_to(std::int64_t t_us) {
  const std::int64_t wanted_us = whole_grains(std::clamp<std::int64_t>(t_us, 0, length_us_));
  if (wanted_us < t_us_) restart();
  while (t_us_ < wanted_us) {
    t_us_ += grain_us;
    pass(session_us());
    if (session_->paused()) continue;
    stage_.walk(1e-6 * grain_us, trial_cast(bundle_, *session_, blend_.timing, session_us()));
  }
  measure();
}

// Everything until then happens.
void TrialPlayer::pass(std::int64_t now_us) {
  while (next_ < end_ && log_.steps[next_].t_us() <= now_us) {
    take_step();
    if (session_->trial() != nullptr) continue;
    throw InputError("trial " + trial_.uuid,
                     "does not go as its log says; `promenade replay DB --audit` says where");
  }
  set_weights();
}

void TrialPlayer::set_weights() {
  const study::TrialState& trial = *session_->trial();
  next_weights_ = trial.weights;
  if (trial.touched && !session_->paused()) {
    trial.interface->weights(trial.control_us(session_us()), next_weights_);
  }
  if (next_weights_ != blend_.weights) motion::set_weights(bundle_.bank, next_weights_, blend_);
}

// The figures and D as they now are.
void TrialPlayer::measure() {
  const study::TrialState& trial = *session_->trial();
  const study::PlannedTrial& planned =
      session_->plan().trials[static_cast<std::size_t>(trial.index)];
  motion::blended_cycle(bundle_.bank, blend_, cycle_);
  d_.reset();
  if (trial.target_points) {
    motion::distance_points(bundle_.bank, blend_, points_,
                            study::task_of(bundle_.study, planned).distance);
    d_ = motion::distance(*trial.target_points, points_).mean_m;
  }
  stage_.pose(trial_cast(bundle_, *session_, cycle_, session_us()));
}

}  // namespace promenade::app
