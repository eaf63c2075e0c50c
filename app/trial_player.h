// A logged trial as it stood at any of its times. What it shows is a function of the log and
// the time alone, however the times are asked for: the session steps through the log, what
// glides is worked out for the very time, and the walk goes on in steps of a millisecond.
#pragma once

#include "app/stage.h"
#include "study/replay.h"

namespace promenade::app {

class TrialPlayer {
 public:
  // All outlive it. `trial`: an index into the trials of the log. It stands at the beginning.
  // Throws InputError for a trial in which nothing was shown.
  TrialPlayer(const study::StudyBundle& bundle, const study::InterfaceRegistry& registry,
              const study::LoggedSession& log, int trial);

  // From the start of the trial to its end, or to the last that is known of it; with pauses.
  std::int64_t length_us() const { return length_us_; }
  // Since the start of the trial, cut to whole milliseconds. Going back is slower: the session
  // is replayed.
  void move_to(std::int64_t t_us);
  std::int64_t t_us() const { return t_us_; }
  std::int64_t session_us() const { return trial_.started_us + t_us_; }  // since it began

  // The session at that time, as the participant's last input left it; in the trial.
  const study::Session& session() const { return *session_; }
  const study::LoggedTrial& trial() const { return trial_; }
  const Eigen::VectorXd& weights() const { return blend_.weights; }  // N, shown now
  const std::optional<double>& d() const { return d_; }  // of these, metres; as Session has it
  Stage& stage() { return stage_; }

  struct Pressed {
    std::int64_t t_us = 0;  // since the start of the trial
    double x = 0, y = 0;    // pixels of the participant's window
  };
  // The participant's last press in this trial; nothing: none so far.
  const std::optional<Pressed>& pressed() const { return pressed_; }

 private:
  void restart();
  std::vector<study::Record> take_step();
  void follow(const study::Input& input);
  void pass(std::int64_t now_us);
  void set_weights();
  void measure();

  const study::StudyBundle& bundle_;
  const study::InterfaceRegistry& registry_;
  const study::LoggedSession& log_;
  int index_;
  const study::LoggedTrial& trial_;
  std::size_t next_ = 0, end_ = 0;  // steps of the log: the next one, and the first behind it
  std::int64_t length_us_ = 0, t_us_ = 0;
  std::optional<study::Session> session_;
  Stage stage_;
  std::pair<int, int> camera_attempt_;  // the trial and attempt that the camera is set for
  std::optional<Pressed> pressed_;
  Eigen::VectorXd next_weights_;  // scratch
  motion::PoseBlend blend_;       // of the weights that are shown
  motion::Cycle cycle_;           // the same as a cycle
  motion::DistancePoints points_;
  std::optional<double> d_;
};

}  // namespace promenade::app
