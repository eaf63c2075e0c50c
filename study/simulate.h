// A cohort of simulated participants, through the same session and store as people.
#pragma once

#include <functional>

#include "study/simulated.h"
#include "study/store.h"

namespace promenade::study {

// One session from welcome to thanks. Every action of the hand comes with a press of
// the mouse button just before. The same arguments give the same records.
// `Steps`: what each step of the session returned, as the store wants it.
using Steps = std::vector<std::vector<Record>>;
Steps simulate_steps(const StudyBundle& bundle, const InterfaceRegistry& registry, const Plan& plan,
                     std::uint64_t seed, const Tendencies& tendencies = {});
std::vector<Record> simulate_session(const StudyBundle& bundle, const InterfaceRegistry& registry,
                                     const Plan& plan, std::uint64_t seed);

// Plays the simulated sessions to their end that were interrupted. Returns how many.
int resume_simulated_sessions(const StudyBundle& bundle, const InterfaceRegistry& registry,
                              Store& store, std::uint64_t seed);

struct Cohort {
  int participants = 1;
  std::uint64_t seed = 1;
  int jobs = 1;  // threads; the content does not depend on them
  std::string machine = "{}";
  Tendencies tendencies = {};
  // Called after each stored session with their number; false: stop here.
  std::function<bool(int done)> progress;
};

// Adds the cohort to the store, going on with the numbers of those who are there.
// Returns how many sessions were stored.
int simulate_cohort(const StudyBundle& bundle, const InterfaceRegistry& registry, Store& store,
                    const Cohort& cohort);

}  // namespace promenade::study
