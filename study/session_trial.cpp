// The running trial: what is shown, what is logged, and when it is over.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "study/session_steps.h"

namespace promenade::study {
namespace {

using Json = nlohmann::ordered_json;

void measure(const motion::PoseBank& bank, motion::DistanceTimes times, TrialState& trial) {
  motion::set_weights(bank, trial.weights, trial.blend);
  motion::blended_cycle(bank, trial.blend, trial.cycle);
  if (!trial.target_points) return;
  motion::distance_points(bank, trial.blend, trial.points, times);
  const motion::Distance d = motion::distance(*trial.target_points, trial.points);
  TrialEnded& summary = trial.summary;
  trial.d = d.mean_m;
  summary.d_best = std::min(summary.d_best.value_or(d.mean_m), d.mean_m);
  summary.d_final = d.mean_m;
  summary.d_sum = d.sum_m;
  summary.seconds_difference = trial.cycle.seconds - trial.target->seconds;
}

std::optional<double> logged(double value) {
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

// What a replay and a reader of the log need to know of an input beside its columns.
std::string control_json(const ControlInput& input, Applied applied, bool first) {
  Json json = {{"applied", applied != Applied::refused}};
  if (first) json["first"] = true;
  if (!input.text.empty()) json["text"] = input.text;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string controls_json(const InterfaceState& interface) {
  const std::vector<ControlInput> settings = interface.settings();
  if (settings.empty()) return "";
  Json controls = Json::array();
  for (const ControlInput& setting : settings) {
    Json one = {{"kind", setting.kind}, {"target", setting.target}};
    if (!std::isnan(setting.value)) one["value"] = setting.value;
    if (!std::isnan(setting.x)) one["x"] = setting.x;
    if (!std::isnan(setting.y)) one["y"] = setting.y;
    controls.push_back(std::move(one));
  }
  return Json{{"controls", controls}}.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

const Task& Session::Steps::task() const {
  return task_of(session.bundle_->study,
                 session.plan_.trials[static_cast<std::size_t>(session.trial_->index)]);
}

// Only what a person did can win.
bool Session::Steps::below_threshold() const {
  const TrialState& trial = *session.trial_;
  const std::optional<double>& threshold = task().threshold_m;
  return trial.touched && trial.d && threshold && *trial.d < *threshold;
}

void Session::Steps::reset_trial(TrialState& trial) const {
  const StudyBundle& bundle = *session.bundle_;
  const PlannedTrial& planned = session.plan_.trials[static_cast<std::size_t>(trial.index)];
  const InterfaceUse& use = bundle.study.interfaces[static_cast<std::size_t>(planned.interface)];
  const InterfaceType* type = session.registry_->find(use.type);
  const auto number = static_cast<std::uint64_t>(trial.index);
  trial.weights = start_weights(bundle.space);
  trial.interface = type->start({bundle.space, use.parameters, trial.weights,
                                 Rng(session.plan_.seed, number, "interface").next(), use.model});
  trial.touched = false;
  trial.below_since_us.reset();
}

void Session::Steps::open_trial(std::int64_t t_us) {
  const StudyBundle& bundle = *session.bundle_;
  TrialState trial;
  trial.index = session.page().trial;
  trial.started_us = t_us;
  const PlannedTrial& planned = session.plan_.trials[static_cast<std::size_t>(trial.index)];
  const Target& target = target_of(bundle.study, planned);
  const motion::DistanceTimes times = task_of(bundle.study, planned).distance;
  if (target.weights) {
    trial.target = motion::blend(bundle.space, *target.weights);
    trial.target_points = motion::distance_points(bundle.space.set, *trial.target, times);
  }
  trial.blend = motion::make_pose_blend(bundle.bank);
  reset_trial(trial);
  measure(bundle.bank, times, trial);
  trial.summary.trial = trial.index;
  records.emplace_back(TrialStarted{trial.index, t_us, trial.d});
  session.trial_ = std::move(trial);
  log_system("start", t_us).detail = controls_json(*session.trial_->interface);
  records.emplace_back(
      Sample{session.trial_->index, t_us, session.trial_->d, session.trial_->weights});
}

// Shows the weights that the trial has now. A change by time alone (an interface that
// glides) leaves the dwell time running while D stays below.
void Session::Steps::show(TrialState& trial, std::int64_t t_us, bool by_control) {
  measure(session.bundle_->bank, task().distance, trial);
  records.emplace_back(Sample{trial.index, t_us, trial.d, trial.weights});
  const bool below = below_threshold();
  if (!below) {
    trial.below_since_us.reset();
  } else if (by_control || !trial.below_since_us) {
    trial.below_since_us = t_us;
  }
  if (below && !trial.summary.first_below_us) trial.summary.first_below_us = t_us;
}

void Session::Steps::end_trial(std::int64_t t_us, TrialOutcome outcome) {
  TrialEnded ended = session.trial_->summary;
  ended.t_us = t_us;
  ended.outcome = outcome;
  if (!task().blind) session.just_ended_ = {session.trial_->index, outcome};
  session.trial_.reset();
  records.emplace_back(ended);
}

void Session::Steps::pass_deadlines(std::int64_t t_us) {
  while (session.trial_) {
    const TrialState& trial = *session.trial_;
    constexpr std::int64_t never = INT64_MAX;
    // Whoever works blind learns nothing from the end of the trial before Done.
    const bool ends_itself = trial.below_since_us && !task().blind;
    const std::int64_t won = ends_itself ? *trial.below_since_us + task().dwell_us : never;
    const std::optional<double>& limit = task().limit_s;
    const std::int64_t over =
        limit ? trial.started_us + trial.summary.paused_us + static_cast<std::int64_t>(*limit * 1e6)
              : never;
    if (std::min(won, over) > t_us) return;
    end_trial(std::min(won, over), won <= over ? TrialOutcome::success : TrialOutcome::timeout);
    next_page(std::min(won, over));
  }
}

void Session::Steps::act(const Tick&) {
  if (!session.trial_ || !session.trial_->touched) return;
  TrialState& trial = *session.trial_;
  trial.interface->weights(trial.control_us(input.t_us), trial.next);
  if (trial.next == trial.weights) return;
  trial.weights.swap(trial.next);
  show(trial, input.t_us, false);
}

void Session::Steps::act(const Press&) {
  Event& event = log("press");
  event.x = input.x;
  event.y = input.y;
  end_gesture();
  if (session.trial_ && input.actor == Actor::participant) ++session.trial_->summary.clicks;
}

void Session::Steps::act(const Done&) {
  if (!session.trial_) return;
  log("done");
  end_trial(input.t_us, below_threshold() ? TrialOutcome::success : TrialOutcome::done);
  next_page(input.t_us);
}

void Session::Steps::act(const StartOver&) {
  if (!session.trial_) return;
  log("start_over");
  TrialState& trial = *session.trial_;
  end_gesture();
  remember({.kind = "start_over", .target = ""}, std::move(trial.interface), trial.touched);
  reset_trial(trial);
  show(trial, input.t_us, true);
}

void Session::Steps::act(const Control& control) {
  if (!session.trial_) return;
  TrialState& trial = *session.trial_;
  ControlInput change = control.input;
  change.t_us = trial.control_us(input.t_us);
  std::unique_ptr<InterfaceState> before = before_gesture(change);
  const Applied applied = trial.interface->apply(change);
  Event& event = log(change.kind.c_str());
  event.target = change.target;
  event.value = logged(change.value);
  event.x = logged(change.x);
  event.y = logged(change.y);
  const bool first = applied == Applied::done && input.actor == Actor::participant &&
                     trial.first_touched.insert(change.kind + " " + change.target).second;
  event.detail = control_json(change, applied, first);
  if (applied != Applied::done) return;
  remember(change, std::move(before), trial.touched);
  trial.interface->weights(change.t_us, trial.next);
  // The first touch counts even where it shows the start: from now on it can win.
  const bool changes = trial.next != trial.weights;
  const bool shows = !trial.touched || changes;
  trial.touched = true;
  // A drag is one change, however many frames it took.
  if (changes && input.actor == Actor::participant && !trial.history.counted) {
    trial.history.counted = true;
    ++trial.summary.changes;
  }
  if (!shows) return;
  trial.weights.swap(trial.next);
  show(trial, input.t_us, true);
}

void Session::Steps::act(const Camera& camera) {
  log("camera").detail =
      fmt::format(R"({{"yaw":{},"pitch":{},"zoom":{},"right":{},"up":{}}})", camera.yaw,
                  camera.pitch, camera.zoom, camera.right, camera.up);
}

void Session::Steps::act(const Playback& playback) {
  Event& event = log("playback");
  event.target = playback.playing ? "play" : "pause";
  event.value = playback.speed;
  if (playback.phase >= 0) event.detail = fmt::format(R"({{"phase":{}}})", playback.phase);
}

void Session::Steps::act(const LateFrame& late) {
  Event& event = log("late_frame");
  event.actor = Actor::system;
  event.value = static_cast<double>(late.late_us);
  if (session.trial_) ++session.trial_->summary.late_frames;
}

}  // namespace promenade::study
