#include "analysis/statistics/scaled_table.h"

#include <cassert>
#include <cmath>

namespace promenade::analysis {

ScaledTable scaled_table(const std::vector<std::vector<double>>& x) {
  assert(!x.empty() && !x[0].empty() && "a table has rows and columns");
  ScaledTable table;
  table.values.resize(static_cast<Eigen::Index>(x.size()), static_cast<Eigen::Index>(x[0].size()));
  for (std::size_t row = 0; row < x.size(); ++row) {
    table.values.row(static_cast<Eigen::Index>(row)) =
        Eigen::Map<const Eigen::RowVectorXd>(x[row].data(), table.values.cols());
  }
  std::frexp(table.values.cwiseAbs().maxCoeff(), &table.exponent);
  table.values =
      table.values.unaryExpr([&](double value) { return std::ldexp(value, -table.exponent); });
  return table;
}

}  // namespace promenade::analysis
