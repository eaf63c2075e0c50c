#include "app/live_session.h"

#include <algorithm>
#include <utility>

#include "study/identity.h"
#include "study/replay.h"

namespace promenade::app {

using study::Record;

LiveSession::LiveSession(study::Session session, study::Store& store, study::SessionHeader header,
                         std::int64_t began_us)
    : session_(std::move(session)),
      store_(store),
      header_(std::move(header)),
      began_us_(began_us) {}

// A log that cannot be written ends the session: what was logged stays.
template <typename Work>
void LiveSession::guard(const Work& work) {
  if (failure_) return;
  try {
    work();
  } catch (const OutsideError& error) {
    failure_ = error.what();
  }
}

bool LiveSession::begin() {
  while (true) {
    try {
      store_.begin_session(header_, session_.plan(), waiting_);
      return true;
    } catch (const study::TakenError& error) {
      if (error.taken() == study::TakenError::What::code) {
        if (!header_.simulated) return false;
        header_.participant = store_.next_simulated_code();
        continue;
      }
      session_.change_sequence(store_.next_sequence(header_.simulated, header_.pilot));
    }
  }
}

bool LiveSession::record_as(const std::string& participant, bool must_be_new) {
  if (recorded_) return true;
  header_.participant = participant;
  if (!session_.language().empty()) header_.language = session_.language();
  header_.new_participant = must_be_new;
  bool refused = false;
  guard([&] {
    refused = !begin();
    if (refused) return;
    recorded_ = true;
  });
  if (!refused) waiting_.clear();
  return !refused;
}

LiveSession::Resumed LiveSession::resume(const std::string& uuid, const study::StudyBundle& bundle,
                                         const study::InterfaceRegistry& registry,
                                         std::int64_t now_us) {
  Resumed result = Resumed::taken;
  guard([&] { result = go_on(uuid, bundle, registry, now_us); });
  return result;
}

LiveSession::Resumed LiveSession::go_on(const std::string& uuid, const study::StudyBundle& bundle,
                                        const study::InterfaceRegistry& registry,
                                        std::int64_t now_us) {
  try {
    const study::LoggedSession log = store_.read_session(uuid);
    // Another version of the program may understand the events in another way.
    study::Audit audit;
    study::audit(bundle, registry, log, audit);
    if (!audit.differences.empty()) return Resumed::differs;
    study::Session session = study::replay(bundle, registry, log);
    store_.resume_session(log, session.plan());
    session_ = std::move(session);
    header_.participant = log.participant;
    header_.language = log.language;
    last_us_ = log.last_us;
    began_us_ = now_us - last_us_;
    recorded_ = resumed_ = true;
    waiting_.clear();
    const std::int64_t gap_us = study::gap_us(log, study::utc_now());
    if (session_.left()) {
      take(study::Return{gap_us}, {.t_us = now_us}, study::Actor::system);
    } else {
      take(study::Interrupted{gap_us, bundle.study.safety.resume}, {.t_us = now_us},
           study::Actor::system);
    }
    return Resumed::yes;
  } catch (const study::TakenError&) {
    return Resumed::taken;
  } catch (const InputError&) {
    return Resumed::differs;
  }
}

study::Input LiveSession::input_at(StudyAction action, const Moment& moment, study::Actor actor) {
  study::Input input;
  // Time never goes back, whatever order events come in.
  last_us_ = input.t_us = std::max(last_us_, since_began(moment.t_us));
  input.uncertainty_us = moment.uncertainty_us;
  input.frame_us = moment.frame_us < 0 ? -1 : since_began(moment.frame_us);
  input.x = moment.x;
  input.y = moment.y;
  input.actor = actor;
  input.action = std::move(action);
  return input;
}

void LiveSession::take(StudyAction action, const Moment& moment, study::Actor actor) {
  keep(session_.step(input_at(std::move(action), moment, actor)));
}

// What the session made of it, it says itself: what did nothing logged nothing.
void LiveSession::obey(const study::Request& request, const Moment& moment) {
  if (session_.ended()) return;
  if (request.page >= 0 && request.page != session_.page_index()) {
    return refuse(request, "page", moment);
  }
  std::optional<StudyAction> action = study::action_of(request);
  if (!action) return refuse(request, request.what == "unknown" ? "unknown" : "words", moment);
  study::Input input = input_at(std::move(*action), moment, study::Actor::experimenter);
  input.request = request.id;
  std::vector<Record> records = session_.step(input);
  const bool done = std::any_of(records.begin(), records.end(), [](const Record& record) {
    const auto* event = std::get_if<study::Event>(&record);
    return event != nullptr && event->actor == study::Actor::experimenter;
  });
  keep(std::move(records));
  if (!done) refuse(request, "state", moment);
}

void LiveSession::refuse(const study::Request& request, const std::string& why,
                         const Moment& moment) {
  study::Input input =
      input_at(study::Refused{request.what, why}, moment, study::Actor::experimenter);
  input.request = request.id;
  keep(session_.step(input));
}

void LiveSession::keep(std::vector<Record> records) {
  if (recorded_) {
    guard([&] { write(records); });
  } else {
    waiting_.insert(waiting_.end(), std::make_move_iterator(records.begin()),
                    std::make_move_iterator(records.end()));
  }
}

void LiveSession::write(const std::vector<Record>& records) {
  unwritten_ = unwritten_ || !records.empty();
  for (const Record& record : records) hand_over_frames(record);
  store_.write(records);
  if (session_.ended() && !records.empty()) store_.end_session(study::utc_now());
}

void LiveSession::count(const ShownFrame& frame) {
  study::FrameHistogram& frames = session_.trial() != nullptr ? trial_frames_ : other_frames_;
  if (frame.interval_us > 0) frames.interval.add(frame.interval_us);
  frames.work.add(frame.work_us);
}

// Before the record, so that they share its durable commit.
void LiveSession::hand_over_frames(const Record& record) {
  if (const auto* ended = std::get_if<study::TrialEnded>(&record)) {
    const study::FrameHistogram frames = std::exchange(trial_frames_, {});
    if (keep_frames_) keep_frames_(ended->trial, frames);
  } else if (std::holds_alternative<study::SessionEnded>(record)) {
    const study::FrameHistogram frames = std::exchange(other_frames_, {});
    if (keep_frames_) keep_frames_(-1, frames);
  }
}

void LiveSession::save() {
  unwritten_ = false;
  guard([&] { store_.flush(); });
}

void LiveSession::flush(std::int64_t now_us) {
  if (recorded_ && !session_.ended()) {
    guard([&] { unwritten_ = store_.alive(last_us_) || unwritten_; });
  }
  if (!unwritten_ || now_us - flushed_us_ < 15'000) return;
  flushed_us_ = now_us;
  unwritten_ = false;
  guard([&] { store_.flush(); });
}

}  // namespace promenade::app
