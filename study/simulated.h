// A simulated participant: tries, looks, improves, sometimes gives up. Works
// with every interface through InterfaceType::simulate, and drives the session
// by the same inputs as a person. The window's autopilot turns its intentions
// into mouse events; `simulate` hands them to the session directly.
#pragma once

#include "study/session.h"

namespace promenade::study {

// How a person is, drawn at random for each participant.
struct Person {
  double eye_noise_m = 0.01;    // standard deviation of the D that is seen
  double imagination_m = 0.03;  // the same for a motion that is only imagined
  double patience_s = 60;       // gives up around then, in tasks that have Done
  double think_s = 1.2;         // mean time between two actions
};
Person draw_person(Rng& rng);

// What the person does next, and after how long.
struct Intention {
  std::int64_t wait_us = 0;
  decltype(Input::action) action = Tick{};
};

class SimulatedParticipant {
 public:
  SimulatedParticipant(const StudyBundle& bundle, const InterfaceRegistry& registry,
                       std::uint64_t seed);
  Intention next(const Session& session);

 private:
  const StudyBundle* bundle_;
  const InterfaceRegistry* registry_;
  Rng rng_;
  Person person_;
  std::optional<double> best_seen_;
  int trial_ = -1;
  double spent_s_ = 0;
};

}  // namespace promenade::study
