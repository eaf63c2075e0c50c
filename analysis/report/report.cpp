#include "analysis/report/report.h"

#include <algorithm>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/figures.h"
#include "analysis/report/page.h"
#include "analysis/report/r_script.h"
#include "analysis/report/report_changes.h"
#include "analysis/report/report_json.h"
#include "analysis/report/tables.h"
#include "analysis/results.h"
#include "analysis/workshop.h"
#include "motion/files.h"
#include "motion/problem.h"

namespace promenade::analysis {
namespace {

namespace fs = std::filesystem;

void write_all(const Results& results, const fs::path& folder, const Progress& progress) {
  const std::vector<Figure> figures = figures_of(results);
  const std::vector<DrawnFigure> drawn = draw(figures, folder / "figures", progress);
  std::vector<Section> sections = sections_of(results);
  sections.push_back(figure_numbers(figures));
  for (const Table& table : all_tables(results, sections)) {
    write_file(folder / "tables" / (table.name + ".csv"), to_csv(table));
  }
  write_file(folder / "analysis.R", r_script());
  write_file(folder / "report.json", report_json(results, sections));
  write_file(folder / "report.html", report_page(results, sections, drawn));
}

constexpr std::size_t most_changes = 20;

// `after`: the report.json that takes the place of one in `folder`, if there is one.
ReportNotes notes_on_changes(const fs::path& folder, const fs::path& after) {
  const fs::path before = folder / "report.json";
  std::error_code ignored;
  if (!fs::is_regular_file(before, ignored)) return {};
  std::vector<std::string> changes;
  try {
    changes = report_changes(before.string(), read_file(before), read_file(after));
  } catch (const InputError& error) {
    return {error.what()};
  }
  if (changes.empty()) return {};
  ReportNotes notes = {before.string() + " was there before; " +
                       count_of(size_of(changes), "value differs:", "values differ:")};
  for (std::size_t i = 0; i < std::min(changes.size(), most_changes); ++i) {
    notes.push_back("  " + changes[i]);
  }
  if (changes.size() > most_changes) {
    notes.push_back("  and " + std::to_string(changes.size() - most_changes) + " more");
  }
  return notes;
}

}  // namespace

ReportNotes write_report(const ReportOptions& options) {
  const fs::path folder = wanted_folder(options.folder);
  std::string document;
  if (!options.prereg_file.empty()) document = read_file(options.prereg_file);
  Results results =
      compute_results(options.databases, options.selection, options.progress, options.registry);
  if (!options.prereg_file.empty()) {
    results.prereg = check_prereg(results, options.prereg_file, document);
  }
  const Workshop workshop(folder);
  try {
    fs::create_directories(workshop.path() / "figures");
    write_all(results, workshop.path(), options.progress);
  } catch (const OutsideError& error) {
    throw OutsideError(workshop.as_wanted(error.what()));
  }
  const ReportNotes notes = notes_on_changes(folder, workshop.path() / "report.json");
  workshop.put_in_place("report.html");
  return notes;
}

}  // namespace promenade::analysis
