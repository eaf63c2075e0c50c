// How people worked with each interface: the measures of the process, compared like the results.
#include "analysis/item.h"
#include "analysis/report/cells.h"
#include "analysis/report/comparison_table.h"
#include "analysis/report/report_sections.h"

namespace promenade::analysis {

Section process_section(const Results& results) {
  Section section;
  for (int task = 0; task < size_of(results.data.tasks); ++task) {
    section.html += folded(comparison_table(
        results, task, Pooling::participants,
        "Measures of the process, with one value per participant (the mean over targets). They "
        "describe; no plan made them a result. Bold: adjusted p < .05.",
        true));
  }
  if (!section.html.code.empty()) section.title = "How people worked";
  return section;
}

}  // namespace promenade::analysis
