// Pairs of interfaces for each target by itself.
#include "analysis/item.h"
#include "analysis/report/cells.h"
#include "analysis/report/comparison_table.h"
#include "analysis/report/report_sections.h"

namespace promenade::analysis {

Section targets_section(const Results& results) {
  if (results.data.interfaces.size() < 2) return {};
  Section section;
  for (int task = 0; task < size_of(results.data.tasks); ++task) {
    section.html += folded(comparison_table(
        results, task, Pooling::none,
        "Signed-rank tests for each target by itself, D and time; the other measures stand in "
        "tables/comparisons.csv. The normal p is by the convention of Oshita et al.: without "
        "continuity correction."));
  }
  if (section.html.code.empty()) return {};
  section.title = "Target by target";
  section.html += family_note(results, Pooling::none);
  return section;
}

}  // namespace promenade::analysis
