// What people made in one study, as walks that others rate, blind, in the next; and what these
// others said of it: the fairest judge of a find task is neither the maker nor a model.
#pragma once

#include <string>
#include <vector>

#include "analysis/dataset.h"
#include "study/study.h"

namespace promenade::analysis {

// Of what a trial ended with, as the next study calls it: it tells nothing about who made it, with
// what, for what, but the two studies together know.
std::string outcome_name(const std::string& trial_uuid);

struct OutcomeChoice {
  std::vector<std::string> tasks, interfaces;  // by name; empty: all find tasks, all interfaces
};

struct Outcomes {
  std::vector<study::Target> targets;  // by name, which is no order at all
  std::vector<std::string> motions;    // of the set: what the weights are about
};

// Of the people that a report of these databases analyses. Throws InputError when nothing was
// made, a name is none of the study, or the stored study cannot be read.
Outcomes outcomes_of(const std::vector<std::string>& databases, const SelectionOptions& options,
                     const study::InterfaceRegistry& registry, const OutcomeChoice& choice = {});

// Adds the measure `rated_quality`, -2 to 2: the mean of what people said, in the databases
// `options.rated_by`, about what was made, on the pair of the asked word. Throws InputError when
// one of them cannot be read or is about nothing of this study.
void add_rated_quality(const SelectionOptions& options, const Log& log,
                       const study::StudyBundle* stored, Dataset& data);

}  // namespace promenade::analysis
