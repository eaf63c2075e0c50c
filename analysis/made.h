// What people made, judged by what the motions are: how much of the asked quality it has, and how
// creative it is ([N] 6 measured creativity and printed no measure; docs/methods.md, 6). Of find
// tasks, where nothing else says how good a result is.
#pragma once

#include "analysis/dataset.h"

namespace promenade::study {
struct StudyBundle;
}  // namespace promenade::study

namespace promenade::analysis {

// Adds these measures, where trials of find tasks have them:
// - `asked_quality`, -2 to 2: the mean ratings of the motions on the pair of the asked word,
//   blended by the final weights;
// - `novelty_m`, metres: D to the nearest example;
// - `mahalanobis`: the distance from the average, in standard deviations of the examples, on the
//   components that the map uses;
// - `diversity_m`, metres: the mean D to what the others made with the same interface for the
//   same target.
// `stored` is the study as a database holds it; null: it cannot be read, and nothing is added.
// Opens the databases of the log again; InputError when they are gone.
void add_measures_of_made(const Log& log, const study::StudyBundle* stored, Dataset& data);

}  // namespace promenade::analysis
