#include "app/instruments_page.h"

#include <fmt/format.h>

#include <algorithm>

namespace promenade::app {
namespace {

using study::Instrument;
using study::Item;

// "6 scale, 15 pairs": how many of each sort, in the order in which they first come.
std::string items_text(const Instrument& instrument) {
  std::vector<std::pair<std::string, int>> sorts;
  for (const Item& item : instrument.items) {
    const std::string sort = item.pair ? "pairs" : std::string(to_text(item.kind));
    const auto same = [&](const auto& entry) { return entry.first == sort; };
    const auto found = std::find_if(sorts.begin(), sorts.end(), same);
    if (found == sorts.end()) {
      sorts.emplace_back(sort, 1);
    } else {
      ++found->second;
    }
  }
  std::string text;
  for (const auto& [sort, count] : sorts) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, sort);
  }
  return text;
}

std::string scores_text(const Instrument& instrument) {
  std::string text;
  for (const study::Score& score : instrument.scores) {
    const study::ValueRange range = score_range(instrument, score);
    text += fmt::format("{}`{}` ({} to {})", text.empty() ? "" : ", ", score.name, range.least,
                        range.most);
  }
  return text.empty() ? "none; each item stands for itself" : text;
}

}  // namespace

std::string instruments_list(const std::vector<Instrument>& instruments) {
  std::string list;
  for (const Instrument& instrument : instruments) {
    list += fmt::format("\n### {}\n\n\"{}\", version {}.\n\n", instrument.name,
                        study::text_in(instrument.title, "en"), instrument.version);
    list +=
        fmt::format("- Items: {}\n- Scores: {}\n", items_text(instrument), scores_text(instrument));
    list += fmt::format("- Source: {}\n- Terms: {}\n- Translations: {}\n", instrument.citation,
                        instrument.terms, instrument.translations);
  }
  return list;
}

}  // namespace promenade::app
