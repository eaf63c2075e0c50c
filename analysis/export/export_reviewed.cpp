#include "analysis/export/export_reviewed.h"

#include <algorithm>
#include <array>

#include "motion/problem.h"
#include "study/csv.h"

namespace promenade::analysis {
namespace {

constexpr std::array<const char*, 4> needed = {"session", "instrument", "item", "text"};
using Places = std::array<std::size_t, 4>;

Places places_in(const std::string& file, const std::vector<study::CsvRow>& rows) {
  Places places{};
  std::vector<Problem> problems;
  for (std::size_t i = 0; i < needed.size(); ++i) {
    const std::vector<std::string> heads =
        rows.empty() ? std::vector<std::string>{} : rows[0].cells;
    const auto found = std::find(heads.begin(), heads.end(), needed[i]);
    places[i] = static_cast<std::size_t>(found - heads.begin());
    if (found != heads.end()) continue;
    problems.push_back({file, 1, 1,
                        std::string("has no column \"") + needed[i] +
                            "\"; take the table of answers of an export without --public",
                        Severity::error});
  }
  if (!problems.empty()) throw InputError(std::move(problems));
  return places;
}

std::string cell(const study::CsvRow& row, std::size_t place) {
  return place < row.cells.size() ? row.cells[place] : "";
}

bool is_answer(study::Statement& known, const ReviewedAnswers::value_type& one) {
  known.reset();
  known.bind(1, std::get<0>(one)).bind(2, std::get<1>(one)).bind(3, std::get<2>(one));
  return known.bind(4, std::get<3>(one)).step();
}

}  // namespace

ReviewedAnswers parse_reviewed(const std::string& file, std::string_view text,
                               study::Database& database) {
  const std::vector<study::CsvRow> rows = study::parse_csv(text);
  const Places at = places_in(file, rows);
  study::Statement known(database,
                         "SELECT 1 FROM main.answer WHERE session = ? AND instrument = ? AND "
                         "item = ? AND coalesce(text, '') = ?");
  ReviewedAnswers reviewed;
  std::vector<Problem> problems;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto [one, is_new] = reviewed.emplace(cell(rows[i], at[0]), cell(rows[i], at[1]),
                                                cell(rows[i], at[2]), cell(rows[i], at[3]));
    if (!is_new || is_answer(known, *one)) continue;
    problems.push_back({file, rows[i].line, 1,
                        "is no answer of the database; session, instrument, item and text must "
                        "be the same to the letter",
                        Severity::error});
  }
  if (!problems.empty()) throw InputError(std::move(problems));
  return reviewed;
}

}  // namespace promenade::analysis
