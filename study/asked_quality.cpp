#include "study/asked_quality.h"

#include <algorithm>

#include "motion/builtin.h"
#include "motion/models/adjective_pairs.h"

namespace promenade::study {

std::optional<AskedPair> asked_pair(const std::vector<std::string>& pairs, const Target& target) {
  const std::string english = text_in(target.quality, "en");
  const motion::PairWords asked = motion::words_of_pair(target.pair);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const motion::PairWords poles = motion::words_of_pair(pairs[i]);
    const auto index = static_cast<int>(i);
    if (!target.pair.empty()) {
      if (target.pair == pairs[i]) return AskedPair{index, false};
      if (asked.left == poles.right && asked.right == poles.left) return AskedPair{index, true};
      continue;
    }
    for (const std::string& word : {target.name, english}) {
      if (word.empty()) continue;
      if (word == poles.right) return AskedPair{index, false};
      if (word == poles.left) return AskedPair{index, true};
    }
  }
  return std::nullopt;
}

Eigen::VectorXd asked_ratings(const AdjectiveModel& model, const AskedPair& asked) {
  const Eigen::VectorXd means = model.quantification.mean.row(asked.pair);
  return asked.left ? Eigen::VectorXd(-means) : means;
}

std::optional<AdjectiveModel> rated_adjectives(const StudyBundle& bundle) {
  if (bundle.adjectives) return *bundle.adjectives;
  const auto builtin = motion::builtin_name(bundle.study.set);
  return builtin ? builtin_adjective_model(*builtin) : std::nullopt;
}

}  // namespace promenade::study
