// A session as a pure function: step(input) changes the state and returns what
// is to be logged. No clock, no I/O, no UI: time is a value in the input, so a
// whole session is a loop in a test, and a replay is the same loop.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "study/interface.h"
#include "study/plan.h"
#include "study/process_measures.h"
#include "study/stimulus_clock.h"

namespace promenade::study {

enum class Actor { participant, system, experimenter };
enum class Outcome { running, finished, declined, withdrawn, stopped };
enum class TrialOutcome { success, timeout, done, skipped, aborted };

std::string_view to_text(Actor actor);
std::string_view to_text(Outcome outcome);
std::string_view to_text(TrialOutcome outcome);
std::string_view to_text(ResumePolicy policy);         // "continue", "trial", "block"
ResumePolicy resume_policy_of(std::string_view word);  // unknown: continue_

// What can happen to a session.
struct Tick {};  // time passed, and what glides has moved on
struct Wait {};  // time passed: deadlines fall due, nothing new is shown (a replay)
struct ChooseLanguage {
  std::string language;
};
struct Continue {};   // the page's main button
struct Decline {};    // no consent
struct Pause {};      // everything stands still
struct Resume {};     // and goes on
struct Press {};      // a mouse button went down: Input::x, y in pixels
struct Done {};       // the participant ends the trial
struct Back {};       // in a rate task: to the motion before, with its answers
struct Leave {};      // the participant goes on another day; the program may end now
struct StartOver {};  // back to the state in which the trial began
struct Undo {};       // what was last done to the controls
struct Redo {};
struct Control {
  ControlInput input;
};  // its t_us is set by step from Input::t_us
// To an item of the questionnaire on this page. Nothing in it: it is taken back.
struct SetAnswer {
  std::string item;
  std::optional<double> value = {};
  std::string text = {};
  bool declined = false;
};
struct Camera {
  double yaw = 0, pitch = 0, zoom = 1;
  double right = 0, up = 0;  // how far it was moved, metres
};                           // radians; 1 as at the start
struct Playback {
  bool playing = true;
  double speed = 1;   // 1: as in life
  double phase = -1;  // 0 to 1, where a scrub put the walk; -1: it goes on
};
struct LateFrame {
  std::int64_t late_us = 0;
};
struct Stop {
  std::string reason;
};  // the window is closed, the experimenter ends it
struct Note {
  std::string text;
};                   // of the experimenter; changes nothing
struct Refused {     // a request of the experimenter's that cannot be done; changes nothing
  std::string what;  // "skip", ...; empty: it could not be read
  std::string why;   // "state", "page", "words", "unknown", "late", "panel"; "broken": not read
};
struct Release {};  // the experimenter lets the participant go on
struct Skip {
  std::string reason;
};  // the page, or the trial with its introduction and questionnaires, is left out
struct Repeat {
  bool block = false;  // the whole block, else the trial that runs or ended last
  std::string reason;
  bool with_guess = true;  // with the guess, where that has won the trial
};
// The program died and has been started again: first input after a replay of the log.
struct Interrupted {
  std::int64_t gap_us = 0;  // by the wall clock, from the last event to now
  ResumePolicy policy = ResumePolicy::continue_;
};

// Whoever left is back: first input after a replay of the log.
struct Return {
  std::int64_t gap_us = 0;  // by the wall clock, from the last event to now
};

struct Input {
  std::int64_t t_us = 0;  // since the session began; never goes back
  std::int64_t uncertainty_us = 0;
  std::int64_t frame_us = -1;  // when the frame on screen was shown; -1: none
  Actor actor = Actor::participant;
  double x = 0, y = 0;  // pointer, pixels
  std::string request;  // the id of what a watcher asked for (study/control.h); empty: nobody did
  std::variant<Tick, Wait, ChooseLanguage, Continue, Decline, Pause, Resume, Press, Done, StartOver,
               Undo, Redo, Control, SetAnswer, Camera, Playback, LateFrame, Stop, Note, Release,
               Skip, Repeat, Interrupted, Back, Leave, Return, Refused>
      action;
};

// What is logged: one for each row of the database, in order. Kinds of events:
// "page" (target: which one, value: its place in the plan, from 0), "start" (a trial
// begins from the common start), "language" (target: the one chosen), "continue",
// "continue_refused", "done_refused", "back", "leave", "decline", "pause", "resume", "press",
// "done", "start_over", "undo", "redo", "answer", "camera", "playback", "late_frame", "stop"; of
// the system also "won" (D stayed below the threshold for the dwell time), "timeout",
// "won_by_guess" (a trial that its guess had already won), "practice_again" and
// "practice_over" (value: successes; target: why), "interrupted" (value: the gap in
// seconds, target: the policy) and "return" (value: likewise); of
// the experimenter also "note", "release", "skip" and "repeat" (target: "trial", "block", or
// "guess": the trial with the guess that had won it) and "request_refused" (target: what was
// asked for), and all of these with {"request": id} in their detail when a watcher asked for it;
// and what was done to a control under the interface's own word, with
// {"applied": true or false} in its detail: by this a replay knows them. There are also
// {"first": true}, the first time that a control was touched in a trial, {"text": ...},
// what was typed, and in the detail of "start" the controls as the system set them.
struct TrialStarted {
  int trial = 0;  // index into Plan::trials
  std::int64_t t_us = 0;
  std::optional<double> d_first;
  int attempt = 1;  // from 1; more when the trial was repeated
};
// The trial is done again: what it gave so far does not count.
struct TrialSuperseded {
  int trial = 0;  // index into Plan::trials
  std::int64_t t_us = 0;
};
struct Event {
  int trial = -1;  // -1: outside trials
  std::int64_t t_us = 0, uncertainty_us = 0, frame_us = -1;
  Actor actor = Actor::system;
  std::string kind, target;
  std::optional<double> value, x, y;
  std::string detail;  // JSON; empty: none
};
struct Sample {
  int trial = 0;
  std::int64_t t_us = 0;
  std::optional<double> d;
  Eigen::VectorXd weights;
};
struct Answer {
  int trial = -1;  // -1: about no single trial
  std::int64_t t_us = 0;
  std::string instrument, version, item;
  std::optional<double> value;
  std::string text;
  bool declined = false, touched = true;
  // What it is about when it is about no single trial: an index into Plan::trials whose
  // block, task and interface are meant; -1: the whole session.
  int about = -1;
  Questionnaire::When when = Questionnaire::When::trial;
  int place = 0;  // of the item on the page, from 1
};
struct TrialEnded {
  int trial = 0;
  std::int64_t t_us = 0;
  TrialOutcome outcome = TrialOutcome::done;
  std::optional<double> d_best, d_final, d_sum, seconds_difference;
  std::optional<std::int64_t> first_below_us;
  std::int64_t paused_us = 0;  // how long it stood; not part of its limit
  int clicks = 0, changes = 0, late_frames = 0;
  ProcessMeasures process;
};
// The last page is open: this is how the session ends, whenever that page is left; or it is
// running again, because the experimenter had something repeated from there.
struct SessionDecided {
  std::int64_t t_us = 0;
  Outcome outcome = Outcome::finished;
};
struct SessionEnded {
  std::int64_t t_us = 0;
  Outcome outcome = Outcome::finished;
};
using Record = std::variant<TrialStarted, TrialSuperseded, Event, Sample, Answer, TrialEnded,
                            SessionDecided, SessionEnded>;

// What undo takes back: the controls before each gesture, where a gesture is all that
// is done to one control from one press of the mouse, or of a key, to the next.
struct History {
  struct Step {
    std::unique_ptr<InterfaceState> interface;
    bool touched = false;
  };
  std::vector<Step> undo, redo;
  std::string gesture;   // "kind target" of the one that goes on; empty: it has ended
  bool counted = false;  // it has changed what is shown
  bool dragged = false;  // it had more than one input
  std::int64_t last_us = 0;
};

// How a trial ended, for the page after it.
struct LastTrial {
  int trial = 0;  // index into Plan::trials
  TrialOutcome outcome = TrialOutcome::done;
};

// What was answered of a motion, for when its page opens again.
struct KeptAnswers {
  std::vector<ItemAnswer> answers;        // in the order of the instrument
  std::vector<std::int64_t> answered_us;  // when each was given
};

// The running trial, for the screen.
struct TrialState {
  int index = 0;    // into Plan::trials
  int attempt = 1;  // as in TrialStarted
  std::int64_t started_us = 0;
  std::unique_ptr<InterfaceState> interface;  // in rate tasks one without controls
  History history;                            // of the controls
  std::set<std::string> first_touched;        // controls, as "kind target"
  bool touched = false;     // false: the start is shown, whatever the controls say
  Eigen::VectorXd weights;  // shown now
  Eigen::VectorXd next;     // scratch
  motion::PoseBlend blend;  // of these weights
  motion::Cycle cycle;      // the same as a cycle
  std::optional<motion::Cycle> target;
  std::optional<motion::DistancePoints> target_points;  // of the target, for D
  motion::DistancePoints points;                        // of what is shown: scratch
  std::optional<double> d;                              // of what is shown
  std::optional<std::int64_t> below_since_us;           // D is below the threshold, unchanged since
  const Stimulus* stimulus = nullptr;  // is rated, and `weights` mean nothing; null: none
  StimulusClock showing;               // of it, by Session::trial_us
  TrialEnded summary;                  // filled as it goes
  ProcessMeter process;

  // The time that the controls know: it stands while the trial is paused.
  std::int64_t control_us(std::int64_t t_us) const { return t_us - summary.paused_us; }
};

class Session {
 public:
  // Both outlive the session. The first page is open when it returns: the choice of a
  // language, or that of the plan.
  Session(const StudyBundle& bundle, const InterfaceRegistry& registry, Plan plan,
          bool asks_language = false);
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;
  ~Session();

  // Time limits and dwell times that passed before the input come first, stamped
  // with their own time. Records are returned in the order of their times. While it is
  // paused no deadline comes nearer, and of what participants do only Resume and Stop count;
  // what the experimenter does ends the pause, a note and a refusal apart.
  std::vector<Record> step(const Input& input);

  // Another order, while nothing but the first page has been shown.
  void change_sequence(int sequence);

  const Plan& plan() const { return plan_; }
  const Page& page() const;         // what is on screen
  int page_index() const;           // into Plan::pages; -1: that is outside the plan
  const TrialState* trial() const;  // null outside trial pages
  // In a trial: that time without its pauses, also while it is paused.
  std::int64_t trial_us(std::int64_t t_us) const;
  Outcome outcome() const { return outcome_; }
  // The same as soon as it is certain: from the last page on, while that is still open.
  Outcome decided() const { return ended() ? outcome_ : decided_; }
  bool ended() const { return outcome_ != Outcome::running; }
  // The questions of this page, a questionnaire or a rate trial; null elsewhere.
  const Instrument* questions() const;
  // Answers so far, in the order of the instrument; Continue needs all that are needed.
  const std::vector<ItemAnswer>& answers() const { return answers_; }
  // Indices of the items in the order in which they are shown.
  const std::vector<int>& item_order() const { return item_order_; }
  bool answered() const;  // all that is needed
  // Now, which is the time of the last input.
  bool can_continue() const;
  // In a rate task, where the motion before can be rated again (Back).
  bool can_go_back() const;
  // Where the study lets people go on another day (Leave).
  bool can_leave() const;
  // They left: until Return comes nothing counts, and nothing is shown but how to come back.
  bool left() const { return left_; }
  // What the experimenter can do now.
  bool can_skip() const;
  bool can_repeat() const { return last_begun_ >= 0; }
  // How long a break has to last from now on; 0 on other pages.
  std::int64_t break_left_us() const;
  bool paused() const { return paused_since_us_.has_value(); }
  const std::string& language() const { return language_; }  // chosen; empty: nobody was asked
  // The trial that this page follows, unless it was blind; nothing elsewhere.
  const std::optional<LastTrial>& just_ended() const { return just_ended_; }

 private:
  struct Steps;              // what each action does: session_steps.h
  int trial_before() const;  // where Back leads: an index into Plan::trials; -1: nowhere
  const StudyBundle* bundle_;
  const InterfaceRegistry* registry_;
  Plan plan_;
  std::size_t page_ = 0;
  Outcome outcome_ = Outcome::running, decided_ = Outcome::running;
  std::optional<TrialState> trial_;
  std::vector<ItemAnswer> answers_;
  std::vector<std::int64_t> answered_us_;  // when each was given
  std::vector<int> item_order_;
  std::map<int, KeptAnswers> kept_;       // of rate trials, by index into Plan::trials
  std::map<int, TrialOutcome> outcomes_;  // by trial: of its last attempt
  int practice_rounds_ = 0;               // of the block that runs, to criterion
  int last_begun_ = -1;                   // index into Plan::trials
  int back_to_ = -1;  // the trial that follows, as its guess is done again; -1: the plan's
  // End states of guesses, by index into Plan::trials.
  std::map<int, std::unique_ptr<InterfaceState>> guesses_;
  bool begun_ = false;          // the first page has been logged
  bool declined_ = false;       // the page that follows Decline is shown
  bool asks_language_ = false;  // the page before the plan is shown
  std::string language_;
  std::vector<int> attempts_;                // by index into Plan::trials: how often it was begun
  std::int64_t now_us_ = 0, opened_us_ = 0;  // of the last input; of the page
  std::optional<std::int64_t> paused_since_us_;
  bool left_ = false;
  std::optional<LastTrial> just_ended_;
};

}  // namespace promenade::study
