#include "app/captions.h"

#include <algorithm>
#include <numeric>

namespace promenade::app {
namespace {

std::string cycle_name(const motion::Cycle& cycle, const study::Texts& texts) {
  // "happy_2" is read as the second of its style.
  const bool numbered = !cycle.style.empty() && cycle.name.size() > cycle.style.size() &&
                        cycle.name.starts_with(cycle.style + "_");
  if (!numbered) return texts.style(cycle.name);
  std::string rest = cycle.name.substr(cycle.style.size() + 1);
  std::replace(rest.begin(), rest.end(), '_', ' ');
  return texts.style(cycle.style) + " " + rest;
}

std::vector<int> order_by_name(const std::vector<std::string>& names) {
  std::vector<int> order(names.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return names[static_cast<std::size_t>(a)] < names[static_cast<std::size_t>(b)];
  });
  return order;
}

std::vector<std::string> cycle_names(const motion::MotionSet& set, const study::Texts& texts) {
  std::vector<std::string> names;
  for (const motion::Cycle& cycle : set.cycles) names.push_back(cycle_name(cycle, texts));
  return names;
}

}  // namespace

Captions captions_of(study::Texts texts, const motion::MotionSet& set) {
  Captions captions{std::move(texts), {}, {}, "en"};
  captions.names = cycle_names(set, captions.texts);
  captions.by_name = order_by_name(captions.names);
  return captions;
}

Captions captions_in(const std::string& language, const study::StudyBundle& bundle) {
  Captions captions = captions_of(study::texts_of(bundle, language), bundle.space.set);
  captions.language = language;
  return captions;
}

std::vector<std::string> words_of(const Captions& captions) {
  std::vector<std::string> words = captions.names;
  for (const std::string& key : captions.texts.keys()) words.push_back(captions.texts(key));
  return words;
}

}  // namespace promenade::app
