// Our own small random numbers: the standard distributions differ between libraries, and an
// order must be reproducible on any machine. One stream for each (seed, participant, purpose).
#pragma once

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace promenade::motion {

class Rng {
 public:
  // purpose: "order", "simulate", ...: streams of different purposes never meet. Where there are
  // no participants, any number tells streams apart.
  Rng(std::uint64_t seed, std::uint64_t participant, std::string_view purpose);

  std::uint64_t next();                      // 64 random bits (splitmix64)
  double uniform();                          // [0, 1), 53 bits
  std::uint64_t below(std::uint64_t bound);  // [0, bound), without bias; bound > 0
  double normal();                           // mean 0, standard deviation 1 (Box-Muller)

  template <typename T>
  void shuffle(std::vector<T>& values) {  // Fisher-Yates
    for (std::size_t i = values.size(); i > 1; --i) {
      std::swap(values[i - 1], values[below(i)]);
    }
  }

 private:
  std::uint64_t state_;
};

}  // namespace promenade::motion
