#include "study/instrument.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "study/rng.h"
#include "study/utf8.h"

namespace promenade::study {
namespace {

int index_of(const Instrument& instrument, std::string_view name) {
  const auto found = std::find_if(instrument.items.begin(), instrument.items.end(),
                                  [&](const Item& item) { return item.name == name; });
  return found == instrument.items.end() ? -1 : static_cast<int>(found - instrument.items.begin());
}

bool fits_range(const Item& item, double value) {
  return value >= item.least && value <= item.most;  // no NaN
}

bool fits_step(const Item& item, double value) {
  const double steps = (value - item.least) / item.step;
  return std::abs(steps - std::round(steps)) < 1e-6;
}

bool allows_words(const Item& item, const std::string& text) {
  return !text.empty() && count_characters(text) <= item.longest;
}

// The choice at place `value`, counted from 1; null: there is none.
const Choice* choice_at(const Item& item, double value) {
  const bool is_place =
      value >= 1 && value <= static_cast<double>(item.choices.size()) && value == std::floor(value);
  return is_place ? &item.choices[static_cast<std::size_t>(value) - 1] : nullptr;
}

bool allows_choice(const Item& item, const ItemAnswer& answer) {
  const Choice* choice = answer.value ? choice_at(item, *answer.value) : nullptr;
  if (!choice) return false;
  return answer.text == choice->name || (choice->free && allows_words(item, answer.text));
}

bool allows_ranking(const Item& item, const std::string& text) {
  std::vector<std::string> wanted;
  for (const Choice& choice : item.choices) wanted.push_back(choice.name);
  std::vector<std::string> found;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    found.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  std::sort(wanted.begin(), wanted.end());
  std::sort(found.begin(), found.end());
  return found == wanted;
}

// How often a name was chosen where it was offered; nothing where a choice is missing.
std::optional<int> times_chosen(const Instrument& instrument,
                                const std::vector<ItemAnswer>& answers, std::string_view name) {
  const auto is_it = [name](const Choice& choice) { return choice.name == name; };
  int times = 0;
  for (std::size_t i = 0; i < instrument.items.size(); ++i) {
    const Item& item = instrument.items[i];
    if (item.kind != ItemKind::choice) continue;
    if (std::none_of(item.choices.begin(), item.choices.end(), is_it)) continue;
    const Choice* chosen = answers[i].value ? choice_at(item, *answers[i].value) : nullptr;
    if (!chosen) return std::nullopt;
    times += is_it(*chosen) ? 1 : 0;
  }
  return times;
}

// The items of a score, and how often each counts.
struct WeightedSum {
  double sum = 0;
  int weight = 0;
};

std::optional<WeightedSum> weighted_sum(const Instrument& instrument, const Score& score,
                                        const std::vector<ItemAnswer>& answers) {
  WeightedSum total;
  for (const ScoreItem& part : score.items) {
    const int index = index_of(instrument, part.item);
    assert(index >= 0 && "a score is made of items of its instrument");
    const Item& item = instrument.items[static_cast<std::size_t>(index)];
    const std::optional<double> value = answers[static_cast<std::size_t>(index)].value;
    const std::optional<int> weight =
        part.weight.empty() ? 1 : times_chosen(instrument, answers, part.weight);
    if (!weight || (*weight > 0 && !value)) return std::nullopt;
    if (*weight == 0) continue;
    total.sum += *weight * (part.reversed ? item.least + item.most - *value : *value);
    total.weight += *weight;
  }
  return total;
}

// What all items of a score lie between.
ValueRange item_range(const Instrument& instrument, const Score& score) {
  if (score.items.empty()) return {};
  const Item* first = find_item(instrument, score.items.front().item);
  assert(first && "a score is made of items of its instrument");
  return {first->least, first->most};
}

// Those indices of `order` that `belongs` accepts change places among themselves.
template <class Belongs>
void shuffle_those(std::vector<int>& order, Rng& rng, Belongs belongs) {
  std::vector<int> chosen;
  std::copy_if(order.begin(), order.end(), std::back_inserter(chosen), belongs);
  rng.shuffle(chosen);
  auto next = chosen.begin();
  for (int& index : order) {
    if (belongs(index)) index = *next++;
  }
}

}  // namespace

std::string_view to_text(ItemKind kind) {
  static constexpr std::string_view names[] = {"scale", "choice",  "number",
                                               "text",  "ranking", "agree"};
  return names[static_cast<int>(kind)];
}

const Item* find_item(const Instrument& instrument, std::string_view name) {
  const int index = index_of(instrument, name);
  return index < 0 ? nullptr : &instrument.items[static_cast<std::size_t>(index)];
}

std::vector<int> item_order(const Instrument& instrument, Rng& rng) {
  std::vector<int> order(instrument.items.size());
  std::iota(order.begin(), order.end(), 0);
  const auto is_pair = [&](int i) { return instrument.items[static_cast<std::size_t>(i)].pair; };
  if (instrument.shuffled) shuffle_those(order, rng, [&](int i) { return !is_pair(i); });
  shuffle_those(order, rng, is_pair);
  return order;
}

Instrument with_interfaces(Instrument instrument, const std::vector<Choice>& interfaces) {
  for (Item& item : instrument.items) {
    if (item.interfaces) item.choices = interfaces;
  }
  return instrument;
}

bool allows(const Item& item, const ItemAnswer& answer) {
  const bool has_text = !answer.text.empty();
  if (answer.declined) return item.can_decline && !answer.value && !has_text;
  if (!answer.given()) return !item.needed;
  switch (item.kind) {
    case ItemKind::scale:
      return answer.value && !has_text && fits_range(item, *answer.value) &&
             fits_step(item, *answer.value);
    case ItemKind::number:
      return answer.value && !has_text && fits_range(item, *answer.value);
    case ItemKind::choice:
      return allows_choice(item, answer);
    case ItemKind::text:
      return !answer.value && allows_words(item, answer.text);
    case ItemKind::ranking:
      return !answer.value && allows_ranking(item, answer.text);
    case ItemKind::agree:
      return answer.value == 1.0 && !has_text;
  }
  return false;
}

std::optional<double> score_of(const Instrument& instrument, const Score& score,
                               const std::vector<ItemAnswer>& answers) {
  assert(answers.size() == instrument.items.size() && "one answer for each item, or an empty one");
  const std::optional<WeightedSum> total = weighted_sum(instrument, score, answers);
  if (!total || total->weight == 0) return std::nullopt;
  if (!score.mean) return total->sum;
  if (!score.range) return total->sum / total->weight;
  // Multiplied before it is divided: scores of whole numbers are rounded once.
  const ValueRange from = item_range(instrument, score);
  const ValueRange to = *score.range;
  const double above = total->sum - total->weight * from.least;
  return to.least + (to.most - to.least) * above / (total->weight * (from.most - from.least));
}

ValueRange score_range(const Instrument& instrument, const Score& score) {
  if (score.range) return *score.range;
  const ValueRange one = item_range(instrument, score);
  const double count = score.mean ? 1 : static_cast<double>(score.items.size());
  return {count * one.least, count * one.most};
}

}  // namespace promenade::study
