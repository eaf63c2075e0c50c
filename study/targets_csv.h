// Targets as a table: a row for each, its name and its weight of every motion. In and out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "study/study.h"

namespace promenade::study {

// Reads CSV with a header that names the column `name` and motions of the set; a motion that
// has no column, and an empty cell, weigh 0. Each row sums to 1. Throws InputError with all
// problems at once.
std::vector<Target> read_targets_csv(const std::string& file, std::string_view text,
                                     const std::vector<std::string>& motions);

// Does every column but `name` stand for one of these motions?
bool is_about_motions(std::string_view text, const std::vector<std::string>& motions);

// The same table of the targets that have weights, of every motion. Numbers come back as they
// are.
std::string targets_csv(const std::vector<Target>& targets,
                        const std::vector<std::string>& motions);

}  // namespace promenade::study
