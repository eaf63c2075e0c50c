// Numbers as people read them: rounded, with a true minus sign, never in a locale.
// Files for programs hold shortest exact numbers instead.
#pragma once

#include <string>
#include <vector>

#include "analysis/dataset.h"
#include "analysis/statistics/interval.h"

namespace promenade::analysis {

std::string fixed(double value, int decimals);  // "−0.30"
std::string exact_number(double value);         // the shortest that reads back the same

// "= .042", "< .001", "= 1": as it stands behind "p".
std::string p_text(double p);

// A value of a measure in the unit that is shown: "3.2", with unit "3.2 cm".
std::string shown(const Measure& measure, double value);
std::string with_unit(const Measure& measure, double value);
std::string shown_interval(const Measure& measure, const Interval& interval);  // "0.4 to 1.5"

// "final D (cm)": for headings and axes.
std::string heading(const Measure& measure);

std::string count_of(int count, const std::string& one, const std::string& many);  // "1 person"
std::string capitalised(std::string sentence);
std::string listed(const std::vector<std::string>& names);  // "a, b, c"

}  // namespace promenade::analysis
