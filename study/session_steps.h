// What each action does to a session. Inside study/ only.
#pragma once

#include "study/session.h"

namespace promenade::study {

struct Session::Steps {
  Session& session;
  const Input& input;
  std::vector<Record> records = {};

  // session.cpp: pages
  void begin();
  void open_page(std::int64_t t_us);
  void next_page(std::int64_t t_us);
  void end(std::int64_t t_us, Outcome outcome);
  void emit_answers();

  // session_trial.cpp: the running trial
  void open_trial(std::int64_t t_us);
  void reset_trial(TrialState& trial) const;
  void show(TrialState& trial, std::int64_t t_us, bool by_control);
  void end_trial(std::int64_t t_us, TrialOutcome outcome);
  void pass_deadlines(std::int64_t t_us);
  const Task& task() const;
  bool below_threshold() const;

  // One for each action.
  void act(const Tick&);
  void act(const ChooseLanguage& choice);
  void act(const Continue&);
  void act(const Decline&);
  void act(const Press&);
  void act(const Done&);
  void act(const StartOver&);
  void act(const Undo&);
  void act(const Redo&);
  void act(const Control& control);
  void act(const SetAnswer& answer);
  void act(const Camera& camera);
  void act(const Playback& playback);
  void act(const LateFrame& late);
  void act(const Stop& stop);

  // session_pause.cpp
  void act(const Pause&);
  void act(const Resume&);
  bool stands() const;  // paused, and the input is none that ends it
  void wake();          // ends the pause, if there is one

  // session_history.cpp: what undo takes back
  std::unique_ptr<InterfaceState> before_gesture(const ControlInput& next) const;
  void remember(const ControlInput& input, std::unique_ptr<InterfaceState> before, bool touched);
  void step_back(const char* kind, std::vector<History::Step>& from,
                 std::vector<History::Step>& to);
  void end_gesture();

  // An event by the input's actor, or by the system, at the running trial.
  Event& log(const char* kind);
  Event& log_system(const char* kind, std::int64_t t_us);
};

}  // namespace promenade::study
