#include "study/targets_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "motion/did_you_mean.h"
#include "study/csv.h"

namespace promenade::study {
namespace {

constexpr double sum_tolerance = 1e-6;
constexpr double largest_weight = 100;

class Reader {
 public:
  Reader(const std::string& file, const std::vector<std::string>& motions)
      : file_(file), motions_(motions) {}

  std::vector<Target> read(std::string_view text) {
    const std::vector<CsvRow> rows = parse_csv(text);
    if (rows.empty()) {
      throw InputError(file_,
                       "is empty; a header with \"name\" and the names of "
                       "motions is wanted");
    }
    find_columns(rows[0]);
    if (!problems_.empty()) throw InputError(problems_);
    std::vector<Target> targets;
    for (std::size_t i = 1; i < rows.size(); ++i) targets.push_back(target_of(rows[i]));
    if (rows.size() == 1) report(rows[0].place(0), "there are no targets below the header");
    if (!problems_.empty()) throw InputError(problems_);
    return targets;
  }

 private:
  void report(Place place, const std::string& message) {
    problems_.push_back({file_, place.line, place.column, message, Severity::error});
  }

  // -1: the name.
  void find_columns(const CsvRow& header) {
    std::vector<std::string> known = motions_;
    known.insert(known.begin(), "name");
    for (std::size_t c = 0; c < header.cells.size(); ++c) {
      const std::string& cell = header.cells[c];
      const auto found = std::find(known.begin(), known.end(), cell);
      const int column = static_cast<int>(found - known.begin()) - 1;
      if (found == known.end()) {
        report(header.place(c),
               fmt::format("the set has no motion \"{}\"{}", cell, did_you_mean(cell, known)));
      } else if (std::find(columns_.begin(), columns_.end(), column) != columns_.end()) {
        report(header.place(c), fmt::format("there is another column \"{}\" before", cell));
      }
      columns_.push_back(column);
    }
    const bool named = std::find(columns_.begin(), columns_.end(), -1) != columns_.end();
    if (!named) report(header.place(0), "there is no column \"name\"");
  }

  double weight_in(const CsvRow& row, std::size_t c) {
    if (row.cells[c].empty()) return 0;
    const auto number = parse_number(row.cells[c]);
    if (number && std::abs(*number) <= largest_weight) return *number;
    report(row.place(c), fmt::format("the weight \"{}\" is not a number from {} to {}",
                                     row.cells[c], -largest_weight, largest_weight));
    return 0;
  }

  Target target_of(const CsvRow& row) {
    Target target;
    target.weights = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(motions_.size()));
    const std::size_t before = problems_.size();
    if (row.cells.size() > columns_.size()) {
      report(row.place(columns_.size()),
             fmt::format("{} cells where the header has {}", row.cells.size(), columns_.size()));
    }
    for (std::size_t c = 0; c < std::min(row.cells.size(), columns_.size()); ++c) {
      if (columns_[c] < 0) {
        target.name = row.cells[c];
      } else {
        (*target.weights)(columns_[c]) = weight_in(row, c);
      }
    }
    if (target.name.empty()) report(row.place(0), "the target has no name");
    const double sum = target.weights->sum();
    if (problems_.size() == before && std::abs(sum - 1) > sum_tolerance) {
      report(row.place(0), fmt::format("the weights sum to {}, but must sum to 1", sum));
    }
    return target;
  }

  const std::string& file_;
  const std::vector<std::string>& motions_;
  std::vector<int> columns_;  // of each cell: index of the motion, or -1
  std::vector<Problem> problems_;
};

}  // namespace

std::vector<Target> read_targets_csv(const std::string& file, std::string_view text,
                                     const std::vector<std::string>& motions) {
  return Reader(file, motions).read(text);
}

bool is_about_motions(std::string_view text, const std::vector<std::string>& motions) {
  const std::vector<CsvRow> rows = parse_csv(text);
  if (rows.empty()) return false;
  return std::all_of(rows[0].cells.begin(), rows[0].cells.end(), [&](const std::string& cell) {
    return cell == "name" || std::find(motions.begin(), motions.end(), cell) != motions.end();
  });
}

std::string targets_csv(const std::vector<Target>& targets,
                        const std::vector<std::string>& motions) {
  std::string text = "name";
  for (const std::string& motion : motions) text += "," + csv_cell(motion);
  text += "\n";
  for (const Target& target : targets) {
    if (!target.weights) continue;
    text += csv_cell(target.name);
    for (const double weight : *target.weights) text += fmt::format(",{}", weight);
    text += "\n";
  }
  return text;
}

}  // namespace promenade::study
