// A logged session, played again through the same session code: to go on with it after an
// interruption, to look at a trial again, and to prove that what is stored follows from what
// was done.
#pragma once

#include <functional>

#include "study/session_log.h"

namespace promenade::study {

// The session before its first step, as the log says it began. What is named outlives it.
Session session_of(const StudyBundle& bundle, const InterfaceRegistry& registry,
                   const LoggedSession& log);

// What leads to this row of the log: the input that was logged, or else that time passed.
Input input_of(const LoggedStep& step);

// Steps a fresh session through the log. `stepped`, if there is one, is called after each
// step with what it returned. The study is the one that the session ran on.
Session replay(const StudyBundle& bundle, const InterfaceRegistry& registry,
               const LoggedSession& log,
               const std::function<void(const Session&, const std::vector<Record>&)>& stepped = {});

// A difference between what is stored and what the replay gives.
struct Difference {
  std::string session;  // uuid
  int trial = -1;       // index into LoggedSession::trials; -1: outside trials
  std::int64_t t_us = 0;
  std::string what;  // "d", "weight 3", "d_final", "outcome", ...
  std::string stored, replayed;
};

struct Audit {
  int sessions = 0, trials = 0;
  std::int64_t events = 0, samples = 0, numbers = 0;  // compared
  double largest = 0;                                 // relative difference of two numbers
  std::vector<Difference> differences;                // at most 100 a session
};

// Everything that is stored of the session against its replay. Numbers differ from a relative
// difference of 1e-9 on, or where both are below 1e-3 from 1e-12 on.
void audit(const StudyBundle& bundle, const InterfaceRegistry& registry, const LoggedSession& log,
           Audit& audit);

}  // namespace promenade::study
