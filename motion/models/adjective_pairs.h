// The 41 pairs of adjectives that people rated ([O] Table 1), with the clusters that the
// source found in them. The study ran in Japanese; these are its printed English words.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace promenade::motion {

struct AdjectivePair {
  enum class Cluster { none, quickness, clearness, activeness, largeness };

  std::string_view left, right;   // the poles of -2 and of 2
  Cluster set_a = Cluster::none;  // [O] Table 2, 27 pairs; none: dropped
  Cluster set_b = Cluster::none;  // [O] Table 3, 29 pairs
};

inline constexpr std::array<AdjectivePair, 41> adjective_pairs = [] {
  using Cluster = AdjectivePair::Cluster;
  return std::array<AdjectivePair, 41>{{
      {"slow", "fast", Cluster::quickness, Cluster::quickness},
      {"mild", "violent", Cluster::activeness, Cluster::largeness},
      {"hard", "soft", Cluster::none, Cluster::none},
      {"dull", "quick", Cluster::quickness, Cluster::quickness},
      {"quiet", "noisy", Cluster::activeness, Cluster::largeness},
      {"angular", "circular", Cluster::none, Cluster::none},
      {"blunt", "sharp", Cluster::quickness, Cluster::largeness},
      {"dormant", "brisk", Cluster::activeness, Cluster::largeness},
      {"edgy", "round", Cluster::none, Cluster::largeness},
      {"weak", "strong", Cluster::clearness, Cluster::none},
      {"unpleasant", "pleasant", Cluster::activeness, Cluster::activeness},
      {"inelastic", "elastic", Cluster::none, Cluster::none},
      {"dirty", "clean", Cluster::clearness, Cluster::none},
      {"sad", "happy", Cluster::activeness, Cluster::activeness},
      {"bumpy", "smooth", Cluster::none, Cluster::clearness},
      {"uncool", "cool", Cluster::clearness, Cluster::clearness},
      {"dark", "bright", Cluster::activeness, Cluster::activeness},
      {"thin", "thick", Cluster::none, Cluster::none},
      {"ugly", "cute", Cluster::clearness, Cluster::clearness},
      {"simple", "gaudy", Cluster::activeness, Cluster::activeness},
      {"coarse", "fine", Cluster::none, Cluster::none},
      {"old", "young", Cluster::clearness, Cluster::activeness},
      {"heavy", "light", Cluster::largeness, Cluster::largeness},
      {"strained", "relaxed", Cluster::none, Cluster::none},
      {"unstable", "stable", Cluster::clearness, Cluster::clearness},
      {"small", "large", Cluster::largeness, Cluster::largeness},
      {"unafraid", "afraid", Cluster::none, Cluster::none},
      {"artificial", "natural", Cluster::clearness, Cluster::activeness},
      {"closed", "open", Cluster::largeness, Cluster::activeness},
      {"adult", "childish", Cluster::none, Cluster::largeness},
      {"vague", "distinct", Cluster::clearness, Cluster::none},
      {"narrow", "broad", Cluster::largeness, Cluster::none},
      {"ugly", "beautiful", Cluster::none, Cluster::clearness},
      {"poor", "rich", Cluster::clearness, Cluster::largeness},
      {"tight", "free", Cluster::largeness, Cluster::none},
      {"dim", "sharp", Cluster::none, Cluster::activeness},
      {"drab", "clear", Cluster::clearness, Cluster::clearness},
      {"gloomy", "cheerful", Cluster::largeness, Cluster::activeness},
      {"lonely", "bustling", Cluster::none, Cluster::activeness},
      {"calm", "excited", Cluster::activeness, Cluster::largeness},
      {"narrow", "wide", Cluster::none, Cluster::largeness},
  }};
}();

// "quickness" and so on; "" for none.
std::string_view cluster_name(AdjectivePair::Cluster cluster);

// "slow-fast": what a pair is called in ratings, models and instruments.
std::string pair_name(const AdjectivePair& pair);

// The two words of such a name, of the 41 or any other; without a hyphen it is its own right one.
struct PairWords {
  std::string_view left, right;
};
PairWords words_of_pair(std::string_view name);

// The index of the pair "left-right", or -1.
int find_adjective_pair(std::string_view name);

}  // namespace promenade::motion
