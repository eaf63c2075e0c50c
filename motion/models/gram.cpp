#include "motion/models/gram.h"

#include <algorithm>

namespace promenade::motion {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index padding = 16;     // columns: a multiple of every tile's height
constexpr Index block_rows = 64;  // of 64 columns: what the first cache holds

// Adds the products of `rows` rows to the lower triangle of `gram`. Row r of the block is at
// part + r stride; the gram has stride x stride entries. Tiles of four columns stay in
// registers; the compiler is not trusted to see that by itself.
template <int bytes>
[[gnu::always_inline]] inline void add_products(Index stride, Index rows, const double* part,
                                                double* gram) {
  using Numbers = typename Packed<bytes>::Numbers;
  constexpr Index lanes = bytes / 8;
  constexpr Index tile = 2 * lanes;
  for (Index j = 0; j < stride; j += 4) {
    for (Index i = j / tile * tile; i < stride; i += tile) {
      Numbers sum[4][2] = {};
      for (const double* row = part; row < part + rows * stride; row += stride) {
        const auto low = *reinterpret_cast<const Numbers*>(row + i);
        const auto high = *reinterpret_cast<const Numbers*>(row + i + lanes);
        for (Index c = 0; c < 4; ++c) {
          sum[c][0] += row[j + c] * low;
          sum[c][1] += row[j + c] * high;
        }
      }
      for (Index c = 0; c < 4; ++c) {
        double* const entry = gram + (j + c) * stride + i;
        *reinterpret_cast<Numbers*>(entry) += sum[c][0];
        *reinterpret_cast<Numbers*>(entry + lanes) += sum[c][1];
      }
    }
  }
}

void add_products_narrow(Index stride, Index rows, const double* part, double* gram) {
  add_products<narrow_bytes>(stride, rows, part, gram);
}

PROMENADE_WIDE void add_products_wide(Index stride, Index rows, const double* part, double* gram) {
  add_products<wide_bytes>(stride, rows, part, gram);
}

}  // namespace

MatrixXd centred_gram(const Eigen::Ref<const MatrixXd>& x, bool wide) {
  const auto add = wide ? add_products_wide : add_products_narrow;
  const Index n = x.cols();
  const Index stride = (n + padding - 1) / padding * padding;
  MatrixXd gram = MatrixXd::Zero(stride, stride);
  MatrixXd block = MatrixXd::Zero(stride, block_rows);
  for (Index r = 0; r < x.rows(); r += block_rows) {
    const Index count = std::min(block_rows, x.rows() - r);
    auto part = block.topLeftCorner(n, count);
    part = x.middleRows(r, count).transpose();
    part.rowwise() -= part.colwise().mean().eval();
    add(stride, count, block.data(), gram.data());
  }
  return gram.topLeftCorner(n, n).triangularView<Eigen::Lower>();
}

}  // namespace promenade::motion
