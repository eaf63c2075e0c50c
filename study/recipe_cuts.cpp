#include "study/recipe_cuts.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "motion/files.h"
#include "study/csv.h"

namespace promenade::study {
namespace {

// Which columns of the file say what.
struct Columns {
  std::size_t style = 0, from = 0, to = 0;
};

std::optional<int> frame_of(const CsvRow& row, std::size_t column) {
  if (column >= row.cells.size()) return std::nullopt;
  const std::string& cell = row.cells[column];
  int frame = 0;
  const auto [stop, error] = std::from_chars(cell.data(), cell.data() + cell.size(), frame);
  if (error != std::errc() || stop != cell.data() + cell.size() || frame < 0) return std::nullopt;
  return frame;
}

std::size_t find_column(const TomlTable& cuts, std::string_view key, const CsvRow& head,
                        const std::string& file, bool& ok) {
  const std::string name = cuts.required_text(key);
  const auto found = std::find(head.cells.begin(), head.cells.end(), name);
  if (found == head.cells.end()) {
    if (!name.empty() && !head.cells.empty())
      cuts.error(key, file + " has no column \"" + name + "\"");
    ok = false;
  }
  return static_cast<std::size_t>(found - head.cells.begin());
}

// A problem at the cells that are wrong.
void apply_row(const CsvRow& row, const Columns& columns, const std::string& file,
               motion::TakeSource& take, std::vector<Problem>& problems) {
  const auto from = frame_of(row, columns.from), to = frame_of(row, columns.to);
  const bool ok = from && to && *from < *to;
  if (!ok) {
    const Place place = row.place(from ? columns.to : columns.from);
    problems.push_back({file, place.line, place.column,
                        "does not say from which to which frame " + take.label + " is good",
                        Severity::error});
    return;
  }
  if (!take.from) take.from = from;
  if (!take.to) take.to = to;
}

}  // namespace

void apply_cuts(const TomlTable& cuts, const std::filesystem::path& folder,
                std::vector<motion::TakeSource>& takes) {
  const std::string name = cuts.required_text("file");
  const std::string file = (folder / name).lexically_normal().string();
  std::vector<CsvRow> rows;
  try {
    if (!name.empty()) rows = parse_csv(read_file(file));
  } catch (const InputError&) {
    cuts.error("file", "there is no file " + file);
  }
  const CsvRow head = rows.empty() ? CsvRow{} : rows.front();
  bool ok = true;
  Columns columns;
  columns.style = find_column(cuts, "style", head, file, ok);
  columns.from = find_column(cuts, "from", head, file, ok);
  columns.to = find_column(cuts, "to", head, file, ok);
  if (!ok || rows.empty()) return;
  std::vector<Problem> problems;
  for (motion::TakeSource& take : takes) {
    const auto row = std::find_if(rows.begin() + 1, rows.end(), [&](const CsvRow& one) {
      return columns.style < one.cells.size() && one.cells[columns.style] == take.style;
    });
    if (row != rows.end()) {
      apply_row(*row, columns, file, take, problems);
    } else {
      problems.push_back(
          {file, 0, 0, "has no row for the style \"" + take.style + "\"", Severity::error});
    }
  }
  cuts.reader().add(problems);
}

}  // namespace promenade::study
