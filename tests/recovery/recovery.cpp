#include "recovery.h"

#include <algorithm>
#include <cmath>

#include "motion/models/adjective_pairs.h"
#include "motion/models/rand_index.h"
#include "study/adjective_model.h"
#include "study/rng.h"
#include "study/simulated_raters.h"

namespace promenade::recovery {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using study::Rng;

constexpr int pairs = static_cast<int>(motion::adjective_pairs.size());

std::vector<std::string> pair_names() {
  std::vector<std::string> names;
  for (const motion::AdjectivePair& pair : motion::adjective_pairs) {
    names.push_back(std::string(pair.left) + "-" + std::string(pair.right));
  }
  return names;
}

study::RatingsTable empty_table(int raters, int motions) {
  study::RatingsTable table;
  table.pairs = pair_names();
  for (int m = 0; m < motions; ++m) table.motions.push_back("m" + std::to_string(m));
  for (int r = 0; r < raters; ++r) table.rater_names.push_back(std::to_string(r + 1));
  table.raters = raters;
  table.simulated = true;
  return table;
}

double on_the_scale(double felt) { return std::clamp(std::round(felt), -2.0, 2.0); }

}  // namespace

Truth make_truth(double cross, std::uint64_t seed) {
  Truth truth;
  constexpr int sizes[] = {4, 6, 8, 11};
  for (int f = 0; f < Truth::factors; ++f) truth.factor.insert(truth.factor.end(), sizes[f], f);
  truth.factor.resize(pairs, Truth::nothing);
  Rng rng(seed, 0, "loadings");
  rng.shuffle(truth.factor);
  truth.loadings = MatrixXd::Zero(pairs, Truth::factors);
  for (Index p = 0; p < pairs; ++p) {
    const int own = truth.factor[static_cast<std::size_t>(p)];
    if (own == Truth::nothing) continue;
    for (Index f = 0; f < Truth::factors; ++f) truth.loadings(p, f) = cross * rng.normal();
    truth.loadings(p, own) = 0.7 + 0.3 * rng.uniform();
  }
  return truth;
}

study::RatingsTable rate(const Truth& truth, int raters, int motions, std::uint64_t seed) {
  study::RatingsTable table = empty_table(raters, motions);
  Rng rng(seed, 0, "motions");
  MatrixXd places(Truth::factors, motions);
  for (double& place : places.reshaped()) place = rng.normal();
  // From standard deviations of a factor to steps of the scale: one is rather "1" than "0".
  const MatrixXd meant = 2 * (0.7 * truth.loadings * places).array().tanh();
  for (int r = 0; r < raters; ++r) {
    Rng own(seed, static_cast<std::uint64_t>(r) + 1, "rater");
    for (int p = 0; p < pairs; ++p) {
      const double leaning = 0.2 * own.normal();
      const bool blind = truth.factor[static_cast<std::size_t>(p)] == Truth::nothing;
      for (int m = 0; m < motions; ++m) {
        const double felt = meant(p, m) + leaning + (blind ? 1.2 : 0.5) * own.normal();
        table.ratings.push_back({r, p, m, on_the_scale(felt)});
      }
    }
  }
  return table;
}

study::RatingsTable rate_blindly(int raters, int motions, std::uint64_t seed) {
  study::RatingsTable table = empty_table(raters, motions);
  for (int r = 0; r < raters; ++r) {
    Rng rng(seed, static_cast<std::uint64_t>(r), "blind");
    for (int p = 0; p < pairs; ++p) {
      for (int m = 0; m < motions; ++m) {
        table.ratings.push_back({r, p, m, static_cast<double>(rng.below(5)) - 2});
      }
    }
  }
  return table;
}

Recovery recover(int raters, int motions, double cross, int seeds) {
  Recovery result;
  result.seeds = seeds;
  for (int s = 1; s <= seeds; ++s) {
    const auto seed = static_cast<std::uint64_t>(s);
    const Truth truth = make_truth(cross, seed);
    const auto model = study::make_adjective_model(rate(truth, raters, motions, seed), "recovery");
    std::vector<int> known;
    for (const int pair : model.quantification.kept) {
      known.push_back(truth.factor[static_cast<std::size_t>(pair)]);
    }
    result.rand_index.push_back(motion::adjusted_rand_index(model.quantification.cluster, known));
    result.kept.push_back(static_cast<double>(known.size()));
    result.refused += model.agreement.agrees() ? 0 : 1;
  }
  return result;
}

int refused_blind_raters(int raters, int motions, int seeds) {
  int refused = 0;
  for (int s = 1; s <= seeds; ++s) {
    const auto table = rate_blindly(raters, motions, static_cast<std::uint64_t>(s));
    refused += study::make_adjective_model(table, "blind").agreement.agrees() ? 0 : 1;
  }
  return refused;
}

int refused_raters_of(const std::string& builtin_set, int seeds) {
  int refused = 0;
  for (int s = 1; s <= seeds; ++s) {
    study::RaterOptions options;
    options.seed = static_cast<std::uint64_t>(s);
    const auto table = *study::simulated_ratings(builtin_set, options);
    refused += study::make_adjective_model(table, "simulated").agreement.agrees() ? 0 : 1;
  }
  return refused;
}

}  // namespace promenade::recovery
