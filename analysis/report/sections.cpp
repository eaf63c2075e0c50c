#include "analysis/report/report_sections.h"
#include "analysis/report/section.h"

namespace promenade::analysis {

std::vector<Section> sections_of(const Results& results) {
  return {
      comparisons_section(results),   //
      descriptives_section(results),  //
      omnibus_section(results),       //
      failures_section(results),      //
      guesses_section(results),       //
      times_section(results),         //
      preference_section(results),    //
      targets_section(results),       //
      pooled_section(results),        //
      methods_section(results),       //
  };
}

std::vector<Table> all_tables(const Results& results, const std::vector<Section>& sections) {
  std::vector<Table> tables = make_tables(results);
  for (const Section& section : sections) {
    tables.insert(tables.end(), section.tables.begin(), section.tables.end());
  }
  return tables;
}

}  // namespace promenade::analysis
