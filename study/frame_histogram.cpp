#include "study/frame_histogram.h"

#include <algorithm>
#include <numeric>

namespace promenade::study {

void TimeHistogram::add(std::int64_t time_us) {
  const auto bin = static_cast<std::size_t>(std::max<std::int64_t>(time_us, 0) / bin_us);
  ++counts_[std::min(bin, bins - 1)];
}

std::int64_t TimeHistogram::count() const {
  return std::accumulate(counts_.begin(), counts_.end(), std::int64_t{0});
}

std::vector<TimeHistogram::Row> TimeHistogram::rows() const {
  std::vector<Row> rows;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    if (counts_[bin] == 0) continue;
    rows.push_back({static_cast<std::int64_t>(bin) * bin_us, counts_[bin]});
  }
  return rows;
}

}  // namespace promenade::study
