#include "analysis/report/prereg_section.h"
#include "analysis/report/section.h"

namespace promenade::analysis {

std::vector<Section> sections_of(const Results& results) {
  std::vector<Section> sections;
  if (results.prereg) sections.push_back(prereg_section(results));
  return sections;
}

std::vector<Table> all_tables(const Results& results, const std::vector<Section>& sections) {
  std::vector<Table> tables = make_tables(results);
  for (const Section& section : sections) {
    tables.insert(tables.end(), section.tables.begin(), section.tables.end());
  }
  return tables;
}

}  // namespace promenade::analysis
