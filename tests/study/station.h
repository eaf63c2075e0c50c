// A database as a station has it after some sessions of the toy study.
#pragma once

#include "play.h"
#include "study/identity.h"
#include "study/store.h"

namespace promenade::study::toy {

inline SessionHeader header(const std::string& code, const std::string& station = "1") {
  SessionHeader header;
  header.participant = code;
  header.station = station;
  header.machine = R"({"host":"attic"})";
  header.started_utc = "2026-11-22T16:00:00Z";
  return header;
}

inline void log_session(Store& store, const StudyBundle& bundle, const SessionHeader& header,
                        int sequence) {
  Player player(bundle, sequence);
  player.whole_session();
  store.begin_session(header, player.session.plan());
  store.write(player.records);
  store.end_session("2026-11-22T17:00:00Z");
}

// One finished session for each code, their orders from `first` on.
inline void make_station(const std::string& file, const std::vector<std::string>& codes,
                         int first = 0, const std::string& text = study_text(),
                         bool simulated = false) {
  const StudyBundle bundle = toy::bundle(text);
  Store store(file, bundle);
  for (const std::string& code : codes) {
    SessionHeader head = header(code);
    head.simulated = simulated;
    log_session(store, bundle, head, first++);
  }
}

}  // namespace promenade::study::toy
