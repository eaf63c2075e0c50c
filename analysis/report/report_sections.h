// The sections of a report, each in the file of its name (section.h says what one is).
#pragma once

#include "analysis/report/section.h"

namespace promenade::analysis {

// What was registered beforehand, and what was done otherwise; with `report --prereg` only.
Section prereg_section(const Results& results);
Section published_section(const Results& results);     // beside the paper that it repeats
Section comparisons_section(const Results& results);   // one value per participant
Section process_section(const Results& results);       // the same of how people worked
Section descriptives_section(const Results& results);  // each interface by itself
Section omnibus_section(const Results& results);       // all interfaces at once
Section targets_section(const Results& results);       // target by target
Section pooled_section(const Results& results);        // all trials, as papers print them
Section failures_section(const Results& results);
Section guesses_section(const Results& results);  // first guesses that were right
Section times_section(const Results& results);
Section preference_section(const Results& results);
Section ratings_section(const Results& results);  // of motions, on pairs of adjectives
Section questionnaires_section(const Results& results);
Section reach_section(const Results& results);        // what each interface can reach at all
Section exclusions_section(const Results& results);   // who was left out by hand, and why
Section sensitivity_section(const Results& results);  // with and without
Section order_section(const Results& results);
Section quality_section(const Results& results);
Section deviations_section(const Results& results);  // from the plan
Section methods_section(const Results& results);     // what a paper would say, and citations

}  // namespace promenade::analysis
