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
  void decide(std::int64_t t_us);
  void end(std::int64_t t_us, Outcome outcome);

  // session_answers.cpp: questionnaires
  void open_questions();
  void emit_answers();

  // session_flow.cpp: what leaves the order of the pages
  bool repeat_practice(std::int64_t t_us);  // true: the practice of the block begins again
  void pass_won_trials(
      std::int64_t t_us);  // leaves out what stands before a trial that its guess has won
  void leave_trial(std::int64_t t_us);  // to the page behind its questionnaires
  void go_to(std::size_t page, std::int64_t t_us);
  void supersede(int trial, std::int64_t t_us);
  bool guess_wins(int trial, std::int64_t t_us) const;
  int guess_index(int trial) const;                 // of the guess that it begins from; -1: none
  const InterfaceState* guess_of(int trial) const;  // null: it begins from the average
  std::size_t page_behind(std::size_t page);
  void repeat(bool block, bool with_guess);
  bool within_block() const;

  // session_back.cpp: the way back in a rate task
  void keep_answers();
  void fill_in();
  void reopen(int trial);

  // session_trial.cpp: the running trial
  void open_trial(std::int64_t t_us);
  void begin_trial(std::int64_t t_us);
  void reset_trial(TrialState& trial, std::int64_t t_us) const;
  TrialState fresh_trial(int index, std::int64_t t_us) const;
  enum class Shown {
    time,
    control,
    gesture
  };  // by time alone; by a control, the first of a gesture
  void show(TrialState& trial, std::int64_t t_us, Shown how);
  void end_trial(std::int64_t t_us, TrialOutcome outcome);
  void pass_deadlines(std::int64_t t_us);
  const Task& task() const;
  bool below_threshold(const TrialState& trial) const;

  // One for each action.
  void act(const Tick&);
  void act(const Wait&);
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
  void act(const Note& note);
  void act(const Refused& refused);
  void act(const Release&);
  void act(const Skip& skip);
  void act(const Repeat& what);
  void act(const Interrupted& gap);
  void act(const Back&);
  void act(const Leave&);
  void act(const Return& gap);

  // session_pause.cpp
  void act(const Pause&);
  void act(const Resume&);
  bool stands() const;  // paused, and the input is none that ends it
  bool rests() const;   // paused, and the input leaves it so
  void wake();          // ends the pause, if there is one

  // session_history.cpp: what undo takes back
  std::unique_ptr<InterfaceState> before_gesture(const ControlInput& next) const;
  void remember(const ControlInput& input, std::unique_ptr<InterfaceState> before, bool touched);
  void step_back(const char* kind, std::vector<History::Step>& from,
                 std::vector<History::Step>& to);
  void end_gesture();

  // An event by the input's actor, or by the system, at the running trial.
  // {"key": "text"}, and the request that was obeyed.
  std::string json_text(const char* key, const std::string& text) const;
  Event& log(const char* kind);
  Event& log_system(const char* kind, std::int64_t t_us);
};

}  // namespace promenade::study
