#include "motion/graph/matches.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <deque>

#include "motion/angles.h"
#include "motion/graph/all_cores.h"
#include "motion/graph/map_minima.h"
#include "motion/quantile.h"

namespace promenade::motion {
namespace {

struct Piece {
  int take_a, take_b;
  MapArea area;
};

class Finder {
 public:
  Finder(const std::vector<LabelledClouds>& takes, double frame_time, const MatchOptions& options)
      : takes_(takes), options_(options) {
    const std::vector<double> taper = window_taper(options, frame_time);
    for (const LabelledClouds& take : takes) sides_.push_back(map_side(take.clouds, taper));
    matches_.window = static_cast<int>(taper.size());
    query_.least_apart =
        std::max(1, static_cast<int>(std::ceil(options.apart_s / frame_time - 1e-6)));
    plan();
  }

  Matches find(const std::function<bool(double)>& progress) {
    std::vector<MapMinima> minima(pieces_.size());
    const bool done = for_each_piece(
        static_cast<int>(pieces_.size()),
        [&](int piece) {
          const auto p = static_cast<std::size_t>(piece);
          minima[p] = search(pieces_[p]);
        },
        progress);
    if (!done) return {};
    for (const MapMinima& part : minima) matches_.minima += part.count;
    matches_.threshold_m = options_.quantile ? quantile_of(minima) : options_.threshold_m;
    for (std::size_t p = 0; p < pieces_.size(); ++p) take_over(pieces_[p], minima[p].found);
    std::sort(matches_.found.begin(), matches_.found.end(), in_order);
    return std::move(matches_);
  }

 private:
  static bool in_order(const Match& a, const Match& b) {
    const auto key = [](const Match& m) {
      return std::array<int, 4>{m.take_a, m.take_b, m.start_a, m.start_b};
    };
    return key(a) < key(b);
  }

  void plan() {
    const int count = static_cast<int>(takes_.size());
    for (int a = 0; a < count; ++a) {
      for (int b = a; b < count; ++b) {
        for (const MapArea& area : minima_areas(side(a), side(b), query_)) {
          pieces_.push_back({a, b, area});
        }
      }
    }
  }

  const MapSide& side(int take) const { return sides_[static_cast<std::size_t>(take)]; }
  const std::string& label(int take) const { return takes_[static_cast<std::size_t>(take)].label; }

  MapMinima search(const Piece& piece) const {
    MinimaQuery query = query_;
    const std::optional<double> own = threshold_of_labels(piece);
    if (own || !options_.quantile) query.most_rms = own.value_or(options_.threshold_m);
    if (options_.quantile) query.most_rms = 1e300;
    return minima_in(side(piece.take_a), side(piece.take_b), piece.area, query);
  }

  std::optional<double> threshold_of_labels(const Piece& piece) const {
    const std::string &a = label(piece.take_a), &b = label(piece.take_b);
    for (const LabelThreshold& pair : options_.labels) {
      if ((pair.from == a && pair.to == b) || (pair.from == b && pair.to == a)) return pair.rms_m;
    }
    return std::nullopt;
  }

  double quantile_of(const std::vector<MapMinima>& minima) const {
    std::vector<double> all;
    for (const MapMinima& part : minima) {
      for (const MapMinimum& minimum : part.found) all.push_back(minimum.rms);
    }
    return all.empty() ? 0 : quantile(std::move(all), std::clamp(*options_.quantile, 0.0, 1.0));
  }

  void take_over(const Piece& piece, const std::vector<MapMinimum>& minima) {
    const double limit = threshold_of_labels(piece).value_or(matches_.threshold_m);
    for (const MapMinimum& at : minima) {
      if (at.rms > limit) continue;
      matches_.found.push_back({piece.take_a, piece.take_b, at.row, at.column, at.rms, at.move});
    }
  }

  const std::vector<LabelledClouds>& takes_;
  const MatchOptions& options_;
  std::deque<MapSide> sides_;
  std::vector<Piece> pieces_;
  MinimaQuery query_;
  Matches matches_;
};

}  // namespace

std::vector<double> window_taper(const MatchOptions& options, double frame_time) {
  const int frames = std::max(2, static_cast<int>(std::lround(options.window_s / frame_time)));
  std::vector<double> taper(static_cast<std::size_t>(frames), 1.0);
  if (options.tapered) {
    for (int p = 0; p < frames; ++p) {
      taper[static_cast<std::size_t>(p)] = 1 - std::cos(2 * pi * (p + 0.5) / frames);
    }
  }
  double sum = 0;
  for (const double weight : taper) sum += weight;
  for (double& weight : taper) weight /= sum;
  return taper;
}

Matches find_matches(const std::vector<LabelledClouds>& takes, double frame_time,
                     const MatchOptions& options, const std::function<bool(double)>& progress) {
  assert(frame_time > 0 && "frames follow each other");
  return Finder(takes, frame_time, options).find(progress);
}

}  // namespace promenade::motion
