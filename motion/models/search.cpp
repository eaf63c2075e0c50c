#include "motion/models/search.h"

#include <algorithm>
#include <cassert>
#include <vector>

namespace promenade::motion {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Counts, and holds every point to the box, in units of its sides.
class Counted {
 public:
  Counted(const Objective& objective, const Box& box, int limit)
      : objective_(objective), box_(box), limit_(limit) {}

  double operator()(VectorXd& unit) {
    ++count_;
    unit = unit.cwiseMax(0).cwiseMin(1);
    return objective_(real(unit));
  }
  VectorXd real(const VectorXd& unit) const {
    return box_.low + unit.cwiseProduct(box_.high - box_.low);
  }
  VectorXd unit(const VectorXd& real) const {
    const VectorXd side = box_.high - box_.low;
    const VectorXd share = (real - box_.low).array() / side.array();
    return (side.array() > 0).select(share, 0).cwiseMax(0).cwiseMin(1);
  }
  bool spent() const { return count_ >= limit_; }
  int count() const { return count_; }

 private:
  const Objective& objective_;
  const Box& box_;
  int limit_;
  int count_ = 0;
};

struct Vertex {
  VectorXd at;
  double value = 0;
};

// Nelder-Mead with the coefficients of Gao and Han 2012, which keep the simplex from
// collapsing in more than a few dimensions.
class Simplex {
 public:
  Simplex(Counted& objective, const Vertex& start, double step) : objective_(objective) {
    vertices_.push_back(start);
    for (Index d = 0; d < start.at.size(); ++d) {
      VectorXd at = start.at;
      at(d) += at(d) + step <= 1 ? step : -step;
      vertices_.push_back(tried(at));
    }
    sort();
  }

  Vertex run(double smallest) {
    while (!objective_.spent() && spread() > smallest) step();
    return vertices_.front();
  }

 private:
  Vertex tried(VectorXd at) {
    const double value = objective_(at);
    return {std::move(at), value};
  }
  void sort() {
    std::stable_sort(vertices_.begin(), vertices_.end(),
                     [](const Vertex& a, const Vertex& b) { return a.value < b.value; });
  }
  double spread() const {
    double largest = 0;
    for (const Vertex& v : vertices_) {
      largest = std::max(largest, (v.at - vertices_.front().at).cwiseAbs().maxCoeff());
    }
    return largest;
  }
  VectorXd centre() const {
    VectorXd sum = VectorXd::Zero(vertices_.front().at.size());
    for (std::size_t i = 0; i + 1 < vertices_.size(); ++i) sum += vertices_[i].at;
    return sum / static_cast<double>(vertices_.size() - 1);
  }
  void step() {
    const auto n = static_cast<double>(std::max<std::size_t>(2, vertices_.size() - 1));
    const VectorXd middle = centre();
    const VectorXd away = middle - vertices_.back().at;
    Vertex next = tried(middle + away);
    if (next.value < vertices_.front().value) {
      const Vertex farther = tried(middle + (1 + 2 / n) * away);
      if (farther.value < next.value) next = farther;
    } else if (next.value >= vertices_[vertices_.size() - 2].value) {
      const double inwards = next.value < vertices_.back().value ? 1 : -1;
      next = tried(middle + inwards * (0.75 - 0.5 / n) * away);
      if (next.value >= vertices_.back().value) return shrink(1 - 1 / n);
    }
    vertices_.back() = next;
    sort();
  }
  void shrink(double share) {
    for (std::size_t i = 1; i < vertices_.size(); ++i) {
      const VectorXd& best = vertices_.front().at;
      vertices_[i] = tried(best + share * (vertices_[i].at - best));
    }
    sort();
  }

  Counted& objective_;
  std::vector<Vertex> vertices_;
};

// One coordinate at a time, both ways; a step is halved when none helps.
Vertex walk_coordinates(Counted& objective, Vertex best, double step, double smallest) {
  while (step > smallest && !objective.spent()) {
    bool better = false;
    for (Index d = 0; d < best.at.size(); ++d) {
      for (const double way : {step, -step}) {
        VectorXd at = best.at;
        at(d) += way;
        const double value = objective(at);
        if (value >= best.value) continue;
        best = {at, value};
        better = true;
        break;
      }
    }
    if (!better) step *= 0.5;
  }
  return best;
}

}  // namespace

SearchResult minimise(const Objective& objective, const Box& box, const VectorXd& start,
                      const SearchOptions& options) {
  assert(box.low.size() == box.high.size() && start.size() == box.low.size() && "one box");
  Counted counted(objective, box, options.evaluations);
  VectorXd unit = counted.unit(start);
  const double value = counted(unit);
  Vertex best{unit, value};
  if (box.size() == 0) return {start, value, 1};
  double step = options.first_step;
  for (int round = 0; round < 4 && !counted.spent(); ++round, step *= 0.3) {
    const double before = best.value;
    if (box.size() <= 12) best = Simplex(counted, best, step).run(options.smallest_step);
    best = walk_coordinates(counted, best, step, options.smallest_step);
    if (before - best.value < 1e-3 * before) break;
  }
  return {counted.real(best.at), best.value, counted.count()};
}

}  // namespace promenade::motion
