#include "analysis/report/report.h"

#include "analysis/item.h"
#include "analysis/report/figures.h"
#include "analysis/report/page.h"
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
  write_file(folder / "report.json", report_json(results, sections));
  write_file(folder / "report.html", report_page(results, sections, drawn));
}

}  // namespace

void write_report(const ReportOptions& options) {
  const fs::path folder = wanted_folder(options.folder);
  const Results results =
      compute_results(options.databases, options.selection, options.progress, options.registry);
  const Workshop workshop(folder);
  try {
    fs::create_directories(workshop.path() / "figures");
    write_all(results, workshop.path(), options.progress);
  } catch (const OutsideError& error) {
    throw OutsideError(workshop.as_wanted(error.what()));
  }
  workshop.put_in_place("report.html");
}

}  // namespace promenade::analysis
