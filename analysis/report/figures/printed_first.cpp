// For a study that repeats [O] 6: the paper's figures come first, in its order.
#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "analysis/item.h"
#include "analysis/report/figures/kinds.h"

namespace promenade::analysis {
namespace {

struct PrintedFigure {
  int number;
  std::string_view kind;  // how our name begins
  bool guess;             // of the task in which one guesses, else of the one that follows
};

constexpr PrintedFigure printed[] = {{7, "d_final_by_target", true},
                                     {8, "guessed", true},
                                     {9, "time_s_by_target", false},
                                     {10, "time_s_to_reference", false},
                                     {11, "failures", false}};

constexpr int not_printed = 100;

int number_of(const Results& results, const Figure& figure) {
  if (figure.task < 0) return not_printed;
  const bool guess = item(results.data.tasks, figure.task).guess;
  for (const PrintedFigure& one : printed) {
    if (one.guess == guess && figure.name.starts_with(one.kind)) return one.number;
  }
  return not_printed;
}

}  // namespace

void put_printed_first(const Results& results, std::vector<Figure>& figures) {
  if (!results.published.study || results.published.study->tests.empty()) return;
  std::stable_sort(figures.begin(), figures.end(), [&](const Figure& a, const Figure& b) {
    return number_of(results, a) < number_of(results, b);
  });
  for (Figure& figure : figures) {
    const int number = number_of(results, figure);
    if (number != not_printed) figure.caption += fmt::format(" As Figure {} of [O].", number);
  }
}

}  // namespace promenade::analysis
