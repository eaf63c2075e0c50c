#include "study/path_csv.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/did_you_mean.h"
#include "motion/problem.h"
#include "study/csv.h"

namespace promenade::study {
namespace {

constexpr double farthest_m = 10'000;
constexpr double longest_m = 1000;  // of the whole path
constexpr std::array columns = {"x", "z", "label"};

class PathReader {
 public:
  explicit PathReader(const std::string& file) : file_(file) {}

  PathTable read(std::string_view text) {
    const std::vector<CsvRow> rows = parse_csv(text);
    if (rows.empty()) throw InputError(file_, "is empty; a header with \"x\" and \"z\" is wanted");
    find_columns(rows[0]);
    if (!problems_.empty()) throw InputError(problems_);
    PathTable table;
    table.points.resize(2, static_cast<Eigen::Index>(rows.size()) - 1);
    for (std::size_t r = 1; r < rows.size(); ++r) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        table.points(static_cast<Eigen::Index>(axis), static_cast<Eigen::Index>(r) - 1) =
            metres(rows[r], axis);
      }
      const std::size_t label = cell_[2];
      table.labels.push_back(label < rows[r].cells.size() ? rows[r].cells[label] : "");
      table.places.push_back(rows[r].place(label));
      const std::size_t columns_there = rows[0].cells.size();
      if (rows[r].cells.size() > columns_there) {
        report(rows[r].place(columns_there),
               "there are more cells than columns; decimals have a dot");
      }
    }
    check_length(table.points, rows);
    if (!problems_.empty()) throw InputError(problems_);
    return table;
  }

 private:
  static constexpr std::size_t nowhere = std::string::npos;

  void report(const Place& place, const std::string& message) {
    problems_.push_back({file_, place.line, place.column, message, Severity::error});
  }

  void find_columns(const CsvRow& header) {
    const std::vector<std::string> known(columns.begin(), columns.end());
    for (std::size_t c = 0; c < header.cells.size(); ++c) {
      const auto found = std::find(known.begin(), known.end(), header.cells[c]);
      if (found == known.end()) {
        report(header.place(c), "there is no column \"" + header.cells[c] + "\" in a path" +
                                    did_you_mean(header.cells[c], known) +
                                    "; there are x, z (metres) and label");
        continue;
      }
      std::size_t& cell = cell_[static_cast<std::size_t>(found - known.begin())];
      if (cell != nowhere) report(header.place(c), "there is another column \"" + *found + "\"");
      cell = c;
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (cell_[axis] == nowhere)
        report(header.place(0), "there is no column \"" + known[axis] + "\"");
    }
  }

  void check_length(const Eigen::Matrix2Xd& points, const std::vector<CsvRow>& rows) {
    double length = 0;
    for (Eigen::Index p = 1; p < points.cols(); ++p) {
      length += (points.col(p) - points.col(p - 1)).norm();
      if (length <= longest_m) continue;
      return report(rows[static_cast<std::size_t>(p) + 1].place(0),
                    "the path is longer than a kilometre here");
    }
  }

  double metres(const CsvRow& row, std::size_t axis) {
    const std::size_t cell = cell_[axis];
    const std::string text = cell < row.cells.size() ? row.cells[cell] : "";
    const auto value = parse_number(text);
    if (value && std::abs(*value) <= farthest_m) return *value;
    report(row.place(cell), "'" + text + "' is no place in metres, from -10000 to 10000");
    return 0;
  }

  const std::string& file_;
  std::array<std::size_t, columns.size()> cell_ = {nowhere, nowhere, nowhere};
  std::vector<Problem> problems_;
};

}  // namespace

PathTable parse_path(std::string_view text, const std::string& file) {
  return PathReader(file).read(text);
}

}  // namespace promenade::study
