#include "study/ratings_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "motion/did_you_mean.h"
#include "motion/problem.h"
#include "study/csv.h"

namespace promenade::study {
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
    if (rows.size() == 1) report(rows[0].place(0), "there are no ratings below the header");
    std::stable_sort(problems_.begin(), problems_.end(), [](const Problem& a, const Problem& b) {
      return a.line != b.line ? a.line < b.line : a.column < b.column;
    });
    if (!problems_.empty()) throw InputError(problems_);
    return table(rows);
  }

 private:
  void report(Place place, const std::string& message) {
    problems_.push_back({file_, place.line, place.column, message, Severity::error});
  }
  // A column of another name that was probably meant.
  static std::string written_instead(const CsvRow& header, const std::string& name) {
    const std::string found = closest_name(name, header.cells);
    return found.empty() ? "" : fmt::format("; is it \"{}\"?", found);
  }
  void find_columns(const CsvRow& header) {
    static constexpr std::array<const char*, column_count> names = {"rater", "motion", "pair",
                                                                    "value"};
    for (std::size_t c = 0; c < column_count; ++c) {
      const auto found = std::find(header.cells.begin(), header.cells.end(), names[c]);
      column_[c] = static_cast<std::size_t>(found - header.cells.begin());
      if (found == header.cells.end())
        report(header.place(0), fmt::format("there is no column \"{}\"{}", names[c],
                                            written_instead(header, names[c])));
    }
  }
  const std::string& cell(const CsvRow& row, Column column) const {
    return row.cells[column_[column]];
  }
  void check(const CsvRow& row) {
    const std::size_t last = *std::max_element(column_.begin(), column_.end());
    if (row.cells.size() <= last) {
      return report(row.place(row.cells.size()),
                    fmt::format("{} cells where the header has more", row.cells.size()));
    }
    const auto number = parse_number(cell(row, value));
    if (!number || *number < -2 || *number > 2) {
      report(row.place(column_[value]),
             fmt::format("the value \"{}\" is not a number from -2 to 2", cell(row, value)));
    }
    const std::string& name = cell(row, motion_name);
    if (!motions_.empty() && std::find(motions_.begin(), motions_.end(), name) == motions_.end()) {
      report(row.place(column_[motion_name]),
             fmt::format("the set has no motion \"{}\"{}", name, did_you_mean(name, motions_)));
    }
    if (cell(row, pair).empty()) report(row.place(column_[pair]), "the pair is empty");
  }
  RatingsTable table(const std::vector<CsvRow>& rows) const {
    std::vector<NamedRating> ratings;
    bool simulated = false;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      ratings.push_back({cell(rows[i], rater), cell(rows[i], motion_name), cell(rows[i], pair),
                         *parse_number(cell(rows[i], value))});
      simulated = simulated || ratings.back().rater.rfind("simulated", 0) == 0;
    }
    RatingsTable result = make_ratings_table(ratings, motions_);
    result.simulated = simulated;
    return result;
  }

  const std::string& file_;
  const std::vector<std::string>& motions_;
  std::array<std::size_t, column_count> column_{};
  std::vector<Problem> problems_;
};

}  // namespace

RatingsTable read_ratings_csv(const std::string& file, std::string_view text,
                              const std::vector<std::string>& motions) {
  return Reader(file, motions).read(text);
}

std::string rater_name(int rater, bool simulated) {
  return simulated ? fmt::format("simulated-{:02}", rater + 1) : std::to_string(rater + 1);
}

std::string ratings_csv(const RatingsTable& table) {
  std::string text = "rater,motion,pair,value\n";
  for (const motion::Rating& rating : table.ratings) {
    text += fmt::format("{},{},{},{}\n", rater_name(rating.rater, table.simulated),
                        csv_cell(table.motions[static_cast<std::size_t>(rating.motion)]),
                        csv_cell(table.pairs[static_cast<std::size_t>(rating.pair)]), rating.value);
  }
  return text;
}

}  // namespace promenade::study
