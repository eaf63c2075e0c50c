#include "analysis/report.h"

#include <unistd.h>

#include <algorithm>

#include "analysis/figures.h"
#include "analysis/item.h"
#include "analysis/page.h"
#include "analysis/report_json.h"
#include "analysis/results.h"
#include "analysis/tables.h"
#include "motion/files.h"
#include "motion/problem.h"

namespace promenade::analysis {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot_write(const fs::path& path, const std::error_code& error) {
  throw OutsideError("cannot write " + path.string() + ": " + error.message() +
                     "; choose another place or make room");
}

// A folder beside the wanted one that goes away unless it is taken over.
class Workshop {
 public:
  explicit Workshop(const fs::path& wanted) : path_(wanted) {
    path_ += "." + std::to_string(::getpid()) + ".part";
    std::error_code error;
    fs::create_directories(path_ / "figures", error);
    if (!error) fs::create_directories(path_ / "tables", error);
    if (error) cannot_write(wanted, error);
  }
  ~Workshop() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// "out/" and "out" are the same folder, and what stands beside it is beside both.
fs::path folder_of(const fs::path& given) {
  fs::path folder = fs::absolute(given).lexically_normal();
  if (folder.filename().empty()) folder = folder.parent_path();
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) {
    throw InputError(given.string(), "is a file; --out names a folder");
  }
  return folder;
}

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
  for (const Table& table : make_tables(results)) {
    write_file(folder / "tables" / (table.name + ".csv"), to_csv(table));
  }
  write_file(folder / "report.json", report_json(results));
  write_file(folder / "report.html", report_page(results, figures));
}

// At once where nothing stands yet; file by file over an older report, the page last,
// so that it never shows what is not there.
void put_in_place(const fs::path& from, const fs::path& to) {
  std::error_code error;
  if (!fs::exists(to, error)) {
    fs::rename(from, to, error);
    if (error) cannot_write(to, error);
    return;
  }
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(from)) {
    if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), from));
  }
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    const bool page_a = a == "report.html";
    const bool page_b = b == "report.html";
    return page_a != page_b ? page_b : a < b;
  });
  for (const fs::path& file : files) {
    fs::create_directories((to / file).parent_path(), error);
    if (!error) fs::rename(from / file, to / file, error);
    if (error) cannot_write(to / file, error);
  }
}

// Nobody asked for the folder that the report is made in.
std::string named_as_wanted(std::string message, const fs::path& made_in, const fs::path& wanted) {
  const std::string name = made_in.string();
  for (std::size_t at; (at = message.find(name)) != std::string::npos;) {
    message.replace(at, name.size(), wanted.string());
  }
  return message;
}

}  // namespace

void write_report(const ReportOptions& options) {
  const fs::path folder = folder_of(options.folder);
  const Results results = compute_results(options.databases, options.selection, options.progress);
  const Workshop workshop(folder);
  try {
    write_all(results, workshop.path(), options.progress);
  } catch (const OutsideError& error) {
    throw OutsideError(named_as_wanted(error.what(), workshop.path(), folder));
  }
  put_in_place(workshop.path(), folder);
}

}  // namespace promenade::analysis
