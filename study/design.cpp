// Orders of conditions.
#include <cassert>

#include "study/plan.h"

namespace promenade::study {

// Williams 1949: the first row 0, 1, n-1, 2, n-2, ...; the others shift it by one.
// For odd n the mirrored rows are needed too.
std::vector<std::vector<int>> williams_design(int n) {
  assert(n >= 0 && "a design has conditions");
  if (n == 1) return {{0}};
  std::vector<std::vector<int>> rows;
  for (int r = 0; r < n; ++r) {
    std::vector<int> row;
    for (int c = 0; c < n; ++c) {
      const int first = c % 2 == 1 ? (c + 1) / 2 : (n - c / 2) % n;
      row.push_back((first + r) % n);
    }
    rows.push_back(row);
  }
  if (n % 2 == 0) return rows;
  for (int r = 0; r < n; ++r) {
    const std::vector<int>& row = rows[static_cast<std::size_t>(r)];
    rows.emplace_back(row.rbegin(), row.rend());
  }
  return rows;
}

std::vector<std::vector<int>> latin_square(int n) {
  assert(n >= 0 && "a design has conditions");
  std::vector<std::vector<int>> rows;
  for (int r = 0; r < n; ++r) {
    std::vector<int> row;
    row.reserve(static_cast<std::size_t>(n));
    for (int c = 0; c < n; ++c) row.push_back((r + c) % n);
    rows.push_back(row);
  }
  return rows;
}

}  // namespace promenade::study
