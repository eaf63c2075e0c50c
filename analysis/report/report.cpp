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

std::vector<DrawnFigure> draw_all(const Results& results, const fs::path& folder,
                                  const Progress& progress) {
  std::vector<DrawnFigure> drawn;
  const std::vector<Figure> figures = figures_of(results);
  for (const Figure& figure : figures) {
    report_progress(progress, "figures drawn:", size_of(drawn), size_of(figures));
    draw(results, figure, folder);
    drawn.push_back({figure, read_file(folder / (figure.name + ".svg"))});
  }
  report_progress(progress, "figures drawn:", size_of(drawn), size_of(figures));
  return drawn;
}

void write_all(const Results& results, const fs::path& folder, const Progress& progress) {
  const std::vector<DrawnFigure> figures = draw_all(results, folder / "figures", progress);
  const std::vector<Section> sections = sections_of(results);
  for (const Table& table : all_tables(results, sections)) {
    write_file(folder / "tables" / (table.name + ".csv"), to_csv(table));
  }
  write_file(folder / "report.json", report_json(results, sections));
  write_file(folder / "report.html", report_page(results, sections, figures));
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
