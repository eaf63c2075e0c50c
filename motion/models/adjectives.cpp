#include "motion/models/adjectives.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <limits>
#include <tuple>

namespace promenade::motion {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// One value for each rater, pair and motion. Sorted, so that sums do not depend on the
// order of the ratings.
std::vector<Rating> merged(std::vector<Rating> ratings) {
  const auto key = [](const Rating& r) { return std::tie(r.pair, r.motion, r.rater); };
  std::sort(ratings.begin(), ratings.end(), [&key](const Rating& a, const Rating& b) {
    return std::tuple_cat(key(a), std::tie(a.value)) < std::tuple_cat(key(b), std::tie(b.value));
  });
  std::vector<Rating> result;
  for (std::size_t i = 0; i < ratings.size();) {
    Rating one = ratings[i];
    std::size_t end = i + 1;
    for (; end < ratings.size() && key(ratings[end]) == key(one); ++end) {
      one.value += ratings[end].value;
    }
    one.value /= static_cast<double>(end - i);
    result.push_back(one);
    i = end;
  }
  return result;
}

void average(const std::vector<Rating>& ratings, int pairs, int motions, Quantification& result) {
  MatrixXd count = MatrixXd::Zero(pairs, motions);
  result.mean = MatrixXd::Zero(pairs, motions);
  for (const Rating& r : ratings) {
    assert(r.pair >= 0 && r.pair < pairs && r.motion >= 0 && r.motion < motions && "in the table");
    count(r.pair, r.motion) += 1;
    result.mean(r.pair, r.motion) += r.value;
  }
  result.mean = result.mean.cwiseQuotient(count);  // 0/0: NaN where nobody rated
  MatrixXd squares = MatrixXd::Zero(pairs, motions);
  for (const Rating& r : ratings) {
    const double off = r.value - result.mean(r.pair, r.motion);
    squares(r.pair, r.motion) += off * off;
  }
  result.deviation =
      (count.array() > 1).select((squares.array() / (count.array() - 1).max(1)).sqrt(), unknown);
}

// Mean of the entries that are known; NaN when none is.
double mean_known(const VectorXd& values) {
  double sum = 0;
  int count = 0;
  for (const double v : values) {
    if (std::isnan(v)) continue;
    sum += v;
    ++count;
  }
  return count > 0 ? sum / count : unknown;
}

// Each row against the sum of the others in its cluster, all as they came in, so that
// the order of rows does not matter.
std::vector<bool> backward_rows(const MatrixXd& rows, const std::vector<int>& cluster) {
  std::vector<bool> backward(cluster.size(), false);
  for (std::size_t i = 0; i < cluster.size(); ++i) {
    VectorXd others = VectorXd::Zero(rows.cols());
    for (std::size_t j = 0; j < cluster.size(); ++j) {
      if (j != i && cluster[j] == cluster[i]) others += rows.row(static_cast<Index>(j)).transpose();
    }
    const VectorXd own = rows.row(static_cast<Index>(i)).transpose();
    backward[i] = correlation(own, others) < 0;
  }
  return backward;
}

void find_clusters(const MatrixXd& shape, int clusters, bool flip, Quantification& result) {
  const Index rows = result.scaled.rows();
  result.primary.resize(0, result.scaled.cols());
  if (rows == 0) return;
  const int count = std::min(clusters, static_cast<int>(rows));
  result.tree = ward(shape.transpose());
  result.cluster = cut(result.tree, count);
  result.flipped.assign(static_cast<std::size_t>(rows), false);
  if (flip) result.flipped = backward_rows(result.scaled, result.cluster);
  result.primary = MatrixXd::Zero(count, result.scaled.cols());
  VectorXd members = VectorXd::Zero(count);
  for (Index q = 0; q < rows; ++q) {
    const auto i = static_cast<std::size_t>(q);
    const auto row = result.scaled.row(q).array();
    members(result.cluster[i]) += 1;
    if (result.flipped[i]) {
      result.primary.row(result.cluster[i]).array() += 1 - row;
    } else {
      result.primary.row(result.cluster[i]).array() += row;
    }
  }
  result.primary.array().colwise() /= members.array();
}

std::string number(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace

PairFate fate_of(double extreme, double disagreement, const QuantificationOptions& options) {
  if (std::isnan(extreme) || std::isnan(disagreement)) return PairFate::unrated;
  if (extreme < options.least_extreme) return PairFate::never_extreme;
  return disagreement > options.most_deviation ? PairFate::disagreed : PairFate::kept;
}

double correlation(const VectorXd& a, const VectorXd& b) {
  const VectorXd x = a.array() - a.mean();
  const VectorXd y = b.array() - b.mean();
  const double size = x.norm() * y.norm();
  return size > 0 ? x.dot(y) / size : 0;
}

Quantification quantify(const std::vector<Rating>& ratings, int pairs, int motions,
                        const QuantificationOptions& options) {
  Quantification result;
  average(merged(ratings), pairs, motions, result);
  result.extreme.resize(pairs);
  result.disagreement.resize(pairs);
  for (int j = 0; j < pairs; ++j) {
    const bool whole = motions > 0 && !result.mean.row(j).array().isNaN().any();
    result.extreme(j) = whole ? result.mean.row(j).cwiseAbs().maxCoeff() : unknown;
    result.disagreement(j) = mean_known(result.deviation.row(j));
    result.fate.push_back(fate_of(result.extreme(j), result.disagreement(j), options));
    if (result.fate.back() == PairFate::kept) result.kept.push_back(j);
  }
  result.scaled = (result.mean(result.kept, Eigen::all).array() + 2) / 4;
  find_clusters(result.scaled, options.clusters, options.flip, result);
  return result;
}

Quantification cluster_rows(const MatrixXd& scaled, int clusters, bool flip) {
  Quantification result;
  result.scaled = scaled;
  for (int j = 0; j < scaled.rows(); ++j) result.kept.push_back(j);
  result.fate.assign(result.kept.size(), PairFate::kept);
  find_clusters(standardised(scaled), clusters, flip, result);
  return result;
}

MatrixXd standardised(const MatrixXd& rows) {
  MatrixXd result = rows.colwise() - rows.rowwise().mean();
  for (Index r = 0; r < result.rows(); ++r) {
    const double size = result.row(r).norm() / std::sqrt(static_cast<double>(rows.cols() - 1));
    // Less than rounding of the values themselves is no variation.
    const bool varies = size > 1e-12 * rows.row(r).cwiseAbs().maxCoeff();
    if (varies) {
      result.row(r) /= size;
    } else {
      result.row(r).setZero();
    }
  }
  return result;
}

MatrixXd scaled_to_range(const MatrixXd& rows) {
  MatrixXd result(rows.rows(), rows.cols());
  for (Index r = 0; r < rows.rows(); ++r) {
    const double low = rows.row(r).minCoeff();
    const double span = rows.row(r).maxCoeff() - low;
    if (span > 0) {
      result.row(r) = (rows.row(r).array() - low) / span;
    } else {
      result.row(r).setConstant(0.5);
    }
  }
  return result;
}

std::string to_text(PairFate fate, const QuantificationOptions& options) {
  switch (fate) {
    case PairFate::kept:
      return "kept";
    case PairFate::never_extreme:
      return "mu* is below " + number(options.least_extreme) +
             ": no motion is far from neutral on this pair";
    case PairFate::disagreed:
      return "sigma is above " + number(options.most_deviation) + ": the raters disagree";
    case PairFate::unrated:
      return "a motion has no rating of this pair, or none has two";
  }
  return {};
}

}  // namespace promenade::motion
