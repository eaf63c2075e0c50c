// Power by rehearsal: simulated people do the study, through the session, the store, the reader
// of the log and the tests that real people's data pass. It tells whether a study of this
// length with these tasks finds what differs between the interfaces FOR SIMULATED PEOPLE. How
// large the differences between real people are, only real people can tell.
#pragma once

#include "analysis/power/power.h"
#include "study/simulate.h"

namespace promenade::analysis {

struct Rehearsal {
  const study::StudyBundle* bundle = nullptr;
  const study::InterfaceRegistry* registry = nullptr;
  study::Tendencies tendencies = {};
  std::vector<std::string> tasks = {},
                           measures = {};  // names; empty: all tasks; d_final and time_s
};

// One study of so many people, in memory. The same (seed, study) give the same people, of whom
// fewer participants are the first ones.
Dataset rehearse(const Rehearsal& rehearsal, int participants, std::uint64_t seed, int study);

// The same with only the first so many of its people.
Dataset first_people(const Dataset& data, int people);

// A table for each task and measure that occurs. Throws InputError for names that the study does
// not have; OutsideError when `progress` stops it.
std::vector<PowerTable> rehearsed_power(const Rehearsal& rehearsal, const PowerQuestion& question);

}  // namespace promenade::analysis
