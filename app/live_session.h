// A session while it is played: the pure session, its log, and the time since it
// began. Every input goes through take().
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/window/shown_frame.h"
#include "study/control.h"
#include "study/frame_histogram.h"
#include "study/session.h"
#include "study/store.h"

namespace promenade::app {

using StudyAction = decltype(study::Input::action);

// When and where something happened, on the monotonic clock.
struct Moment {
  std::int64_t t_us = 0;
  std::int64_t uncertainty_us = 0;
  std::int64_t frame_us = -1;  // when the frame on screen was shown; -1: none
  double x = 0, y = 0;         // pointer, pixels
};

class LiveSession {
 public:
  // The session begins at `began_us` on the monotonic clock, which is
  // `header.started_utc`; nothing is stored before record_as(). The store outlives it.
  LiveSession(study::Session session, study::Store& store, study::SessionHeader header,
              std::int64_t began_us);

  // Goes on with a session that was interrupted, by the policy of its study; before anything
  // of this one is recorded. Not where another process does so already, or where the log does
  // not lead to what is stored: another version of the program wrote it. `bundle` and
  // `registry` are those of this session.
  enum class Resumed { yes, taken, differs };
  Resumed resume(const std::string& uuid, const study::StudyBundle& bundle,
                 const study::InterfaceRegistry& registry, std::int64_t now_us);

  // Only on the first page. False: the code must be new but is already used, and
  // nothing is stored yet. Takes the next free order when another session took ours;
  // a simulated participant takes the next free code as well.
  bool record_as(const std::string& participant, bool must_be_new);
  // Another order, before anything is recorded.
  void change_sequence(int sequence) { session_.change_sequence(sequence); }
  // The session cannot go on, for this reason.
  void fail(const std::string& reason) {
    if (!failure_) failure_ = reason;
  }
  bool recorded() const { return recorded_; }
  bool resumed() const { return resumed_; }
  const std::string& participant() const { return header_.participant; }
  const std::string& language() const { return header_.language; }
  study::Store& store() { return store_; }

  void take(StudyAction action, const Moment& moment,
            study::Actor actor = study::Actor::participant);
  // Does what a watcher asks for, as the experimenter. What cannot be done now is logged as
  // refused.
  void obey(const study::Request& request, const Moment& moment);
  // `why`: as study::Refused has it.
  void refuse(const study::Request& request, const std::string& why, const Moment& moment);
  // Time passed, with nothing done.
  void tick(std::int64_t t_us) { take(study::Tick{}, {.t_us = t_us}, study::Actor::system); }

  // A frame was shown: it counts for the trial that runs, or for the pages outside trials.
  void count(const ShownFrame& frame);
  // Takes the frames of each trial (its place in the plan) right before its end is stored,
  // and at the end of the session those of all other pages (-1). What it throws is treated
  // as what the store throws.
  using FrameKeeper = std::function<void(int trial, const study::FrameHistogram& frames)>;
  void keep_frames(FrameKeeper keeper) { keep_frames_ = std::move(keeper); }

  // Brings all that is new in the log to the disk, now.
  void save();
  // Brings what is new in the log to the disk, at most every 15 ms: called in every
  // frame, it leaves nothing out for longer than 50 ms.
  void flush(std::int64_t now_us);

  const study::Session& session() const { return session_; }
  std::int64_t since_began(std::int64_t t_us) const { return t_us - began_us_; }
  // Why nothing more can be stored; the session is over then.
  const std::optional<std::string>& failure() const { return failure_; }

 private:
  study::Input input_at(StudyAction action, const Moment& moment, study::Actor actor);
  void keep(std::vector<study::Record> records);
  void write(const std::vector<study::Record>& records);
  bool begin();  // false: the code is used
  Resumed go_on(const std::string& uuid, const study::StudyBundle& bundle,
                const study::InterfaceRegistry& registry, std::int64_t now_us);
  void hand_over_frames(const study::Record& record);
  template <typename Work>
  void guard(const Work& work);

  study::Session session_;
  study::Store& store_;
  study::SessionHeader header_;
  std::int64_t began_us_;
  std::int64_t last_us_ = 0;  // of the last input, since the beginning
  std::int64_t flushed_us_ = 0;
  bool recorded_ = false;
  bool resumed_ = false;
  bool unwritten_ = false;              // something waits for the next flush
  std::vector<study::Record> waiting_;  // from before record_as()
  std::optional<std::string> failure_;
  FrameKeeper keep_frames_;
  study::FrameHistogram trial_frames_, other_frames_;  // so far
};

}  // namespace promenade::app
