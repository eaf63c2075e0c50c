// The kinds of figures, each in a file of its own. Each function makes the figure of one task, or
// nothing where the data have nothing to show.
#pragma once

#include <optional>
#include <string>

#include "analysis/d_over_time.h"
#include "analysis/report/figures.h"

namespace promenade::analysis {

// A dot per participant and interface, joined; medians with 95 % intervals. Of more than 40
// people a raincloud: dots that are not joined, beside half violins (each_participant.cpp).
std::optional<Figure> each_participant(const Results& results, int task,
                                       const std::string& measure);

// Every pair of interfaces: Hodges-Lehmann estimate with 95 % interval (forest.cpp).
std::optional<Figure> forest(const Results& results, int task, const std::string& measure);

// In the manner of [O] 7 and 9: the mean per target and interface with SD (by_target.cpp).
std::optional<Figure> means_by_target(const Results& results, int task, const std::string& measure);
// [O] 10: the mean difference to the reference with its 90 % interval (by_target.cpp).
std::optional<Figure> differences_to_reference(const Results& results, int task,
                                               const std::string& measure);
// [O] 8, of tasks in which one guesses, and 11: shares with 95 % intervals of Wilson
// (by_target.cpp).
std::optional<Figure> success_by_target(const Results& results, int task);
std::optional<Figure> failures_by_target(const Results& results, int task);

// The share of trials not yet done, by Kaplan and Meier (survival.cpp).
std::optional<Figure> survival_curves(const Results& results, int task);

// The median D of all trials while they went on (d_over_time.cpp).
std::optional<Figure> d_over_time(const Results& results, int task, const Curves& curves);

// Where on the map people spent their time, a panel for each interface (map_heat.cpp).
std::optional<Figure> map_heat(const Results& results, int task);

// How alike the motions of the set are, of the whole study (dendrogram.cpp).
std::optional<Figure> dendrogram(const Results& results);
// How alike the pairs of adjectives are in what people said, and their clusters (dendrogram.cpp).
std::optional<Figure> dendrogram_of_pairs(const Results& results);

// Of a study that repeats [O] 6, its Figures 7 to 11 come first and say so (printed_first.cpp).
void put_printed_first(const Results& results, std::vector<Figure>& figures);

// Names of files and words that the kinds share (kinds.cpp).
std::string figure_name(const Results& results, int task, const std::string& what);
std::string in_task(const Results& results, int task);  // " in task NAME", if there are several
std::vector<int> interfaces_in(const Results& results, int task);
std::vector<std::string> names_of(const Results& results, const std::vector<int>& interfaces);

}  // namespace promenade::analysis
