// What is different in a report that is made again: the same databases and program give the same
// bytes, so each difference has a cause that an analyst wants to know of.
#pragma once

#include <string>
#include <vector>

namespace promenade::analysis {

// Every value that differs between two report.json, as "PATH: OLD -> NEW", in the order of
// the new one. Rows of a list are paired by what they are about (their texts), else by their
// place: "wilcoxon[d_final match participants map labels].hl: 0.01 -> 0.02". One that is there only
// once has "nothing" on the other side. Empty for equal texts. Throws InputError when `before` is
// no JSON; `file` names it.
std::vector<std::string> report_changes(const std::string& file, const std::string& before,
                                        const std::string& after);

}  // namespace promenade::analysis
