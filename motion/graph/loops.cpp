#include "motion/graph/loops.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "motion/graph/all_cores.h"
#include "motion/graph/map_minima.h"

namespace promenade::motion {
namespace {

MinimaQuery query_for(const LoopOptions& options, double frame_time) {
  MinimaQuery query;
  query.least_apart =
      std::max(1, static_cast<int>(std::ceil(options.shortest_s / frame_time - 1e-6)));
  query.most_apart = static_cast<int>(std::floor(options.longest_s / frame_time + 1e-6));
  query.most_rms = options.threshold_m;
  return query;
}

bool better(const Match& a, const Match& b) {
  return std::tuple(a.rms_m, a.start_a, a.start_b) < std::tuple(b.rms_m, b.start_a, b.start_b);
}

}  // namespace

std::vector<Match> find_loops(const Take& take, const LoopOptions& options) {
  MatchOptions windows;
  windows.window_s = options.window_s;
  windows.tapered = options.tapered;
  const Clouds clouds = joint_clouds(take, joint_weights(take.skeleton, take.body));
  const MapSide side = map_side(clouds, window_taper(windows, take.frame_time));
  const MinimaQuery query = query_for(options, take.frame_time);
  const std::vector<MapArea> areas = minima_areas(side, side, query);
  std::vector<MapMinima> minima(areas.size());
  for_each_piece(static_cast<int>(areas.size()), [&](int piece) {
    const auto p = static_cast<std::size_t>(piece);
    minima[p] = minima_in(side, side, areas[p], query);
  });
  std::vector<Match> loops;
  for (const MapMinima& part : minima) {
    for (const MapMinimum& at : part.found) {
      loops.push_back({0, 0, at.row, at.column, at.rms, at.move});
    }
  }
  std::sort(loops.begin(), loops.end(), better);
  return loops;
}

}  // namespace promenade::motion
