// How long the frames of a trial took, counted in bins: small enough for the database, and
// fine enough to see what a participant saw.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace promenade::study {

// Times in bins of one millisecond; the last bin has everything from its start on.
class TimeHistogram {
 public:
  static constexpr std::int64_t bin_us = 1000;
  static constexpr std::size_t bins = 200;
  struct Row {
    std::int64_t least_us = 0;  // where the bin begins
    std::int64_t count = 0;
    bool operator==(const Row&) const = default;
  };

  void add(std::int64_t time_us);  // one that is not positive counts in the first bin
  std::int64_t count() const;      // of all bins
  std::vector<Row> rows() const;   // the bins that are not empty, shortest times first

 private:
  std::array<std::int64_t, bins> counts_{};
};

struct FrameHistogram {
  TimeHistogram interval;  // from one frame on screen to the next
  TimeHistogram work;      // from the first drawing of a frame until it was shown

  bool empty() const { return work.count() == 0; }
};

}  // namespace promenade::study
