#include "analysis/export/export_r.h"

#include <map>

#include "analysis/report/r_script.h"
#include "analysis/report/tables.h"
#include "motion/files.h"

namespace promenade::analysis {
namespace {

// People and sessions of the log have their public names already; what is left is hidden here.
Log public_log(const ExportSource& source) {
  Log log = source.log;
  std::map<std::string, std::string> names;
  study::Statement row(source.database, "SELECT old, new FROM temp.public_trial");
  while (row.step()) names[row.text(0)] = row.text(1);
  for (LoggedTrial& trial : log.trials) trial.uuid = names[trial.uuid];
  for (LoggedSession& session : log.sessions) session.station.clear();
  return log;
}

bool is_read_by_script(const Table& table) {
  return table.name == "trials" || table.name == "comparisons" || table.name == "measures";
}

}  // namespace

bool write_r_script(const ExportSource& source, const std::filesystem::path& folder,
                    const Progress& progress) {
  Results results;
  results.log = source.is_public ? public_log(source) : source.log;
  results.selection = source.selection;
  results.data = make_dataset(results.log, results.selection);
  if (results.data.trials.empty()) return false;
  results.comparisons = compare_all(results.data, progress);
  std::filesystem::create_directories(folder / "tables");
  for (const Table& table : make_tables(results)) {
    if (is_read_by_script(table)) {
      write_file(folder / "tables" / (table.name + ".csv"), to_csv(table));
    }
  }
  write_file(folder / "analysis.R", r_script());
  return true;
}

}  // namespace promenade::analysis
