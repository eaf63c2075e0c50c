// All trials as if each were a person of its own, as the papers print it.
#include "analysis/item.h"
#include "analysis/report/cells.h"
#include "analysis/report/comparison_table.h"
#include "analysis/report/report_sections.h"

namespace promenade::analysis {

Section pooled_section(const Results& results) {
  if (results.data.interfaces.size() < 2) return {};
  Section section;
  for (int task = 0; task < size_of(results.data.tasks); ++task) {
    section.html += folded(comparison_table(
        results, task, Pooling::trials,
        "As papers in this field print it: each participant and target counts as one pair. Pairs "
        "of the same person are not independent, so these p are too small; shown for comparison "
        "only."));
  }
  if (section.html.code.empty()) return {};
  section.title = "All trials pooled";
  section.html += family_note(results, Pooling::trials);
  return section;
}

}  // namespace promenade::analysis
