#include "app/live_session.h"

#include <algorithm>

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
      store_.begin_session(header_, session_.plan());
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
    recorded_ = unwritten_ = true;
    write(waiting_);
  });
  if (!refused) waiting_.clear();
  return !refused;
}

bool LiveSession::resume(const std::string& uuid, const study::StudyBundle& bundle,
                         const study::InterfaceRegistry& registry, std::int64_t now_us) {
  bool taken = false;
  guard([&] {
    const study::LoggedSession log = store_.read_session(uuid);
    study::Session session = study::replay(bundle, registry, log);
    try {
      store_.resume_session(log, session.plan());
    } catch (const study::TakenError&) {
      taken = true;
      return;
    }
    session_ = std::move(session);
    header_.participant = log.participant;
    header_.language = log.language;
    last_us_ = log.last_us;
    began_us_ = now_us - last_us_;
    recorded_ = resumed_ = true;
    waiting_.clear();
    const std::int64_t gap_us = study::gap_us(log, study::utc_now());
    take(study::Interrupted{gap_us, bundle.study.safety.resume}, {.t_us = now_us},
         study::Actor::system);
  });
  return !taken;
}

void LiveSession::take(StudyAction action, const Moment& moment, study::Actor actor) {
  study::Input input;
  // Time never goes back, whatever order events come in.
  last_us_ = input.t_us = std::max(last_us_, since_began(moment.t_us));
  input.uncertainty_us = moment.uncertainty_us;
  input.frame_us = moment.frame_us < 0 ? -1 : since_began(moment.frame_us);
  input.x = moment.x;
  input.y = moment.y;
  input.actor = actor;
  input.action = std::move(action);
  std::vector<Record> records = session_.step(input);
  if (recorded_) {
    guard([&] { write(records); });
  } else {
    waiting_.insert(waiting_.end(), std::make_move_iterator(records.begin()),
                    std::make_move_iterator(records.end()));
  }
}

void LiveSession::write(const std::vector<Record>& records) {
  unwritten_ = unwritten_ || !records.empty();
  store_.write(records);
  if (session_.ended() && !records.empty()) store_.end_session(study::utc_now());
}

void LiveSession::flush(std::int64_t now_us) {
  if (!unwritten_ || now_us - flushed_us_ < 15'000) return;
  flushed_us_ = now_us;
  unwritten_ = false;
  guard([&] { store_.flush(); });
}

}  // namespace promenade::app
