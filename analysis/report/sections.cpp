#include "analysis/report/prereg_section.h"
#include "analysis/report/report_sections.h"
#include "analysis/report/section.h"

namespace promenade::analysis {

std::vector<Section> sections_of(const Results& results) {
  std::vector<Section> sections = {
      comparisons_section(results),     //
      descriptives_section(results),    //
      omnibus_section(results),         //
      failures_section(results),        //
      guesses_section(results),         //
      times_section(results),           //
      preference_section(results),      //
      questionnaires_section(results),  //
      targets_section(results),         //
      process_section(results),         //
      reach_section(results),           //
      pooled_section(results),          //
      sensitivity_section(results),     //
      order_section(results),           //
      quality_section(results),         //
      deviations_section(results),      //
  };
  if (results.prereg) sections.push_back(prereg_section(results));
  sections.push_back(methods_section(results));
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
