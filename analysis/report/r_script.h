// analysis.R, which lies beside the tables: it repeats every signed-rank test in R, and fits the
// mixed models. Its text is analysis/report/analysis.R.
#pragma once

#include <string_view>

namespace promenade::analysis {

std::string_view r_script();

}  // namespace promenade::analysis
