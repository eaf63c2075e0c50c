// The main result: pairs of interfaces by one value per participant.
#include "analysis/item.h"
#include "analysis/report/cells.h"
#include "analysis/report/comparison_table.h"
#include "analysis/report/report_sections.h"

namespace promenade::analysis {

Section comparisons_section(const Results& results) {
  Section section;
  section.title = "Interfaces compared";
  if (results.data.interfaces.empty()) return {};
  if (results.data.interfaces.size() < 2) {
    section.html = element("p", "Only one interface was used, so there is no pair to compare.");
    return section;
  }
  for (int task = 0; task < size_of(results.data.tasks); ++task) {
    section.html += wide(comparison_table(
        results, task, Pooling::participants,
        "Signed-rank tests with one value per participant (the mean over targets): the main "
        "result. Bold: adjusted p < .05. D at the start is left out where it was the same; how "
        "people "
        "worked is compared further below."));
  }
  section.html += family_note(results, Pooling::participants);
  section.json["holm_family"] = "all pairs of interfaces for one measure at one place";
  return section;
}

}  // namespace promenade::analysis
