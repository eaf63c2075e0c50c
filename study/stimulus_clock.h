// Where a stimulus stands: a function of the times at which it began, was paused, slowed down and
// scrubbed, and of nothing else, so that a replay shows what was shown.
#pragma once

#include <cstdint>

namespace promenade::study {

struct StimulusClock {
  bool playing = true;
  double speed = 1;           // 1: as in life
  double from_s = 0;          // of the motion: where it stood
  std::int64_t since_us = 0;  // at this time, which stands while the trial is paused

  // Since its beginning, seconds of life, with all repetitions: it plays again and again.
  double seconds(std::int64_t t_us) const {
    return playing ? from_s + speed * 1e-6 * static_cast<double>(t_us - since_us) : from_s;
  }
};

}  // namespace promenade::study
