// Signed-rank tests as a table of the page: the same columns at every level.
#pragma once

#include <string>

#include "analysis/report/html.h"
#include "analysis/results.h"

namespace promenade::analysis {

// The tests of a task at one level. With targets, only those of D and time, which a paper
// would print; the others stand in the CSV.
// Only measures of the process, or only the others.
HtmlTable comparison_table(const Results& results, int task, Pooling pooling, std::string caption,
                           bool process = false);

// "of, zeros, ...": the columns of one test, and its cells; differences are read as `measure`.
const std::vector<std::string>& test_columns();
std::vector<std::string> test_cells(const Measure& measure, const Comparison& one);

// Could anybody have had both values? Not where a task was not for one of the interfaces.
bool is_possible(const Results& results, int measure, const Comparison& one);

// What Holm's family is, and where a normal p stands in place of an exact one and why.
Html family_note(const Results& results, Pooling pooling);

}  // namespace promenade::analysis
