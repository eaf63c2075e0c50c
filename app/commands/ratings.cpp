#include "app/commands/ratings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "app/commands/numbers.h"
#include "motion/models/adjective_pairs.h"
#include "motion/problem.h"
#include "study/did_you_mean.h"

namespace promenade::app {
namespace {

enum Column { rater, motion_name, pair, value, column_count };

class Reader {
 public:
  Reader(const std::string& file, const std::vector<std::string>& motions)
      : file_(file), motions_(motions) {}

  RatingsTable read(std::string_view text) {
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
  static int number_of(std::map<std::string, int>& known, const std::string& name) {
    return known.emplace(name, static_cast<int>(known.size())).first->second;
  }
  RatingsTable table(const std::vector<CsvRow>& rows) const {
    RatingsTable result;
    std::set<std::string> pairs, motions;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      pairs.insert(cell(rows[i], pair));
      motions.insert(cell(rows[i], motion_name));
    }
    result.pairs.assign(pairs.begin(), pairs.end());
    const auto printed = [](const std::string& name) {
      const int found = motion::find_adjective_pair(name);
      return found < 0 ? static_cast<int>(motion::adjective_pairs.size()) : found;
    };
    std::stable_sort(
        result.pairs.begin(), result.pairs.end(),
        [&printed](const std::string& a, const std::string& b) { return printed(a) < printed(b); });
    result.motions = motions_;
    if (motions_.empty()) result.motions.assign(motions.begin(), motions.end());
    std::map<std::string, int> raters, pair_index, motion_index;
    for (const std::string& name : result.pairs) number_of(pair_index, name);
    for (const std::string& name : result.motions) number_of(motion_index, name);
    for (std::size_t i = 1; i < rows.size(); ++i) {
      result.ratings.push_back(
          {number_of(raters, cell(rows[i], rater)), pair_index.at(cell(rows[i], pair)),
           motion_index.at(cell(rows[i], motion_name)), *parse_number(cell(rows[i], value))});
    }
    result.raters = static_cast<int>(raters.size());
    return result;
  }

  const std::string& file_;
  const std::vector<std::string>& motions_;
  std::array<std::size_t, column_count> column_{};
  std::vector<Problem> problems_;
};

}  // namespace

RatingsTable read_ratings(const std::string& file, std::string_view text,
                          const std::vector<std::string>& motions) {
  return Reader(file, motions).read(text);
}

}  // namespace promenade::app
