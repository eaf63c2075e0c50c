#include "motion/rng.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace promenade::motion {
namespace {

std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

std::uint64_t hash(std::string_view text) {  // FNV-1a
  std::uint64_t h = 0xcbf29ce484222325ULL;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return h;
}

}  // namespace

Rng::Rng(std::uint64_t seed, std::uint64_t participant, std::string_view purpose)
    : state_(mix(mix(mix(seed) + participant) + hash(purpose))) {}

std::uint64_t Rng::next() { return mix(state_ += 0x9e3779b97f4a7c15ULL); }

double Rng::uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

std::uint64_t Rng::below(std::uint64_t bound) {
  assert(bound > 0 && "there is no number below 0");
  const std::uint64_t reject_below = (0 - bound) % bound;
  std::uint64_t bits = next();
  while (bits < reject_below) bits = next();
  return bits % bound;
}

double Rng::normal() {
  const double radius = std::sqrt(-2 * std::log(1 - uniform()));
  return radius * std::cos(2 * std::numbers::pi * uniform());
}

}  // namespace promenade::motion
