// A section of a report: a subject, said on the page, in tables/*.csv, and in report.json. Each
// section is one function from the results to this, in a file of its own; sections.cpp lists
// them in the order in which they are read. A new subject is a new file and a line there.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/report/html.h"
#include "analysis/report/tables.h"
#include "analysis/results.h"

namespace promenade::analysis {

struct Section {
  std::string title;  // its heading; empty: it shows nothing on the page
  Html html;          // what stands below the heading
  std::vector<Table> tables;
  // Added to report.json: an object whose keys no other section has.
  nlohmann::json json = nlohmann::json::object();
};

// Of a heading, for links within the page: "Data quality" is "data-quality".
std::string anchor_of(const std::string& title);

// All that have something to say, in the order of the page.
std::vector<Section> sections_of(const Results& results);

// What becomes tables/*.csv: make_tables(), then those of the sections.
std::vector<Table> all_tables(const Results& results, const std::vector<Section>& sections);

}  // namespace promenade::analysis
