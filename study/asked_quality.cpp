#include "study/asked_quality.h"

#include <algorithm>

#include "motion/builtin.h"

namespace promenade::study {
namespace {

// The words of "sad-happy"; a word may hold no hyphen.
struct Poles {
  std::string left, right;
};

Poles poles_of(const std::string& pair) {
  const std::size_t hyphen = pair.find('-');
  if (hyphen == std::string::npos) return {pair, ""};
  return {pair.substr(0, hyphen), pair.substr(hyphen + 1)};
}

}  // namespace

std::optional<AskedPair> asked_pair(const std::vector<std::string>& pairs, const Target& target) {
  const std::string english = text_in(target.quality, "en");
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Poles poles = poles_of(pairs[i]);
    const auto index = static_cast<int>(i);
    if (!target.pair.empty()) {
      if (target.pair == pairs[i]) return AskedPair{index, false};
      if (target.pair == poles.right + "-" + poles.left) return AskedPair{index, true};
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
