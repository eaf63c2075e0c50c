// Who was left out by hand, why, by which rule, and when that was decided.
#include "analysis/report/cells.h"
#include "analysis/report/report_sections.h"

namespace promenade::analysis {
namespace {

HtmlTable exclusion_table(const Selection& selection) {
  HtmlTable table;
  table.caption = "Participants excluded by the analyst.";
  table.columns = {"code", "reason", "rule", "decided on"};
  for (const Exclusion& one : selection.exclusions) {
    const auto given = [](const std::string& text) { return text.empty() ? "not given" : text; };
    table.rows.push_back({one.code, given(one.reason), given(one.rule), given(one.date)});
  }
  return table;
}

}  // namespace

Section exclusions_section(const Results& results) {
  if (results.selection.exclusions.empty()) return {};
  Section section;
  section.title = "Excluded participants";
  section.html = wide_words(exclusion_table(results.selection));
  return section;
}

}  // namespace promenade::analysis
