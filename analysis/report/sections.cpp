#include "analysis/report/report_sections.h"
#include "analysis/report/section.h"

namespace promenade::analysis {

std::vector<Section> sections_of(const Results& results) {
  std::vector<Section> sections;
  for (const auto& section : {
           prereg_section,
           published_section,
           // What came out.
           comparisons_section,
           omnibus_section,
           failures_section,
           guesses_section,
           times_section,
           preference_section,
           ratings_section,
           questionnaires_section,
           // May it be believed?
           exclusions_section,
           sensitivity_section,
           order_section,
           quality_section,
           deviations_section,
           // Details.
           descriptives_section,
           targets_section,
           pooled_section,
           process_section,
           reach_section,
           methods_section,
       }) {
    sections.push_back(section(results));
  }
  return sections;
}

std::string anchor_of(const std::string& title) {
  std::string anchor;
  for (const char c : title) {
    const bool upper = c >= 'A' && c <= 'Z';
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    anchor += upper ? static_cast<char>(c - 'A' + 'a') : plain ? c : '-';
  }
  return anchor;
}

std::vector<Table> all_tables(const Results& results, const std::vector<Section>& sections) {
  std::vector<Table> tables = make_tables(results);
  for (const Section& section : sections) {
    tables.insert(tables.end(), section.tables.begin(), section.tables.end());
  }
  return tables;
}

}  // namespace promenade::analysis
