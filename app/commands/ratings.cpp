#include "app/commands/ratings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/commands/numbers.h"
#include "motion/problem.h"
#include "study/did_you_mean.h"

namespace promenade::app {
namespace {

enum Column { rater, motion_name, pair, value, column_count };

class Reader {
 public:
  Reader(const std::string& file, const std::vector<std::string>& motions)
      : file_(file), motions_(motions) {}

  study::RatingsTable read(std::string_view text) {
    const std::vector<CsvRow> rows = parse_csv(text);
    if (rows.empty())
      throw InputError(file_, "is empty; a header rater,motion,pair,value is wanted");
    find_columns(rows[0]);
    if (!problems_.empty()) throw InputError(problems_);
    for (std::size_t i = 1; i < rows.size(); ++i) check(rows[i]);
    if (rows.size() == 1) report(rows[0], 0, "there are no ratings below the header");
    if (!problems_.empty()) throw InputError(problems_);
    return table(rows);
  }

 private:
  void report(const CsvRow& row, std::size_t column, const std::string& message) {
    problems_.push_back({file_, row.line, static_cast<int>(column), message, Severity::error});
  }
  void find_columns(const CsvRow& header) {
    static constexpr std::array<const char*, column_count> names = {"rater", "motion", "pair",
                                                                    "value"};
    for (std::size_t c = 0; c < column_count; ++c) {
      const auto found = std::find(header.cells.begin(), header.cells.end(), names[c]);
      column_[c] = static_cast<std::size_t>(found - header.cells.begin());
      if (found == header.cells.end())
        report(header, 0, fmt::format("there is no column \"{}\"", names[c]));
    }
  }
  const std::string& cell(const CsvRow& row, Column column) const {
    return row.cells[column_[column]];
  }
  void check(const CsvRow& row) {
    const std::size_t last = *std::max_element(column_.begin(), column_.end());
    if (row.cells.size() <= last)
      return report(row, 0, fmt::format("{} cells where the header has more", row.cells.size()));
    const auto number = parse_number(cell(row, value));
    if (!number || *number < -2 || *number > 2)
      report(row, 0,
             fmt::format("the value \"{}\" is not a number from -2 to 2", cell(row, value)));
    const std::string& name = cell(row, motion_name);
    if (!motions_.empty() && std::find(motions_.begin(), motions_.end(), name) == motions_.end()) {
      report(
          row, 0,
          fmt::format("the set has no motion \"{}\"{}", name, study::did_you_mean(name, motions_)));
    }
    if (cell(row, pair).empty()) report(row, 0, "the pair is empty");
  }
  study::RatingsTable table(const std::vector<CsvRow>& rows) const {
    std::vector<study::NamedRating> ratings;
    bool simulated = false;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      ratings.push_back({cell(rows[i], rater), cell(rows[i], motion_name), cell(rows[i], pair),
                         *parse_number(cell(rows[i], value))});
      simulated = simulated || ratings.back().rater.rfind("simulated", 0) == 0;
    }
    study::RatingsTable result = study::make_ratings_table(ratings, motions_);
    result.simulated = simulated;
    return result;
  }

  const std::string& file_;
  const std::vector<std::string>& motions_;
  std::array<std::size_t, column_count> column_{};
  std::vector<Problem> problems_;
};

}  // namespace

study::RatingsTable read_ratings(const std::string& file, std::string_view text,
                                 const std::vector<std::string>& motions) {
  return Reader(file, motions).read(text);
}

}  // namespace promenade::app
