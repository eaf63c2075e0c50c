// [[score]] of an instrument.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "motion/did_you_mean.h"
#include "study/instrument_parts.h"

namespace promenade::study {
namespace {

constexpr std::size_t most_scores = 50;
constexpr std::size_t most_names = 200;  // in one list

bool has_number(const Item& item) {
  return item.kind == ItemKind::scale || item.kind == ItemKind::number;
}

std::vector<std::string> names_of_numbers(const Instrument& instrument) {
  std::vector<std::string> names;
  for (const Item& item : instrument.items) {
    if (has_number(item)) names.push_back(item.name);
  }
  return names;
}

// All that can be chosen, sorted.
std::vector<std::string> names_of_choices(const Instrument& instrument) {
  std::set<std::string> names;
  for (const Item& item : instrument.items) {
    if (item.kind != ItemKind::choice) continue;
    for (const Choice& choice : item.choices) names.insert(choice.name);
  }
  return {names.begin(), names.end()};
}

// The first item sets the range that all others must have.
std::string trouble_with_range(const Item& item, const Item& first) {
  if (item.least == first.least && item.most == first.most) return {};
  return fmt::format(
      "\"{}\" goes from {} to {}, but \"{}\" from {} to {}: the items of a score "
      "must have one range",
      item.name, item.least, item.most, first.name, first.least, first.most);
}

// Why this item cannot be in the score; empty: it can.
std::string trouble_with(const std::string& name, const Instrument& instrument,
                         const Score& score) {
  const Item* item = find_item(instrument, name);
  if (!item) {
    return "there is no [[item]] with the name \"" + name + "\"" +
           did_you_mean(name, names_of_numbers(instrument));
  }
  if (!has_number(*item)) {
    return fmt::format(R"("{}" is of kind "{}", which is no number to be scored)", name,
                       to_text(item->kind));
  }
  const bool again = std::any_of(score.items.begin(), score.items.end(),
                                 [&](const ScoreItem& other) { return other.item == name; });
  if (again) return "\"" + name + "\" is in this score already";
  if (score.items.empty()) return {};
  return trouble_with_range(*item, *find_item(instrument, score.items.front().item));
}

std::string too_many_names() { return fmt::format("has more than {} names", most_names); }

void add_items(const TomlTable& table, std::string_view key, const ScoreItem& like,
               const Instrument& instrument, Score& score) {
  const std::vector<TomlText> entries = table.texts(key);
  if (entries.size() > most_names) return table.error(key, too_many_names());
  for (const TomlText& entry : entries) {
    const bool known = find_item(instrument, entry.text) != nullptr;
    if (!known && !table.reader().whole()) continue;  // it may have had the name
    const std::string trouble = trouble_with(entry.text, instrument, score);
    if (!trouble.empty()) {
      table.reader().add(entry.place, trouble);
      continue;
    }
    score.items.push_back(like);
    score.items.back().item = entry.text;
  }
}

// [score.weighted]: NAME = [items that count as often as NAME was chosen].
void add_weighted(const TomlTable& table, const Instrument& instrument, Score& score) {
  const std::vector<std::string> names = names_of_choices(instrument);
  const std::vector<std::string> keys = table.keys();
  if (keys.size() > most_names) return table.error(too_many_names());
  for (const std::string& name : keys) {
    const bool known = std::binary_search(names.begin(), names.end(), name);
    if (!known && table.reader().whole()) {
      table.error(name, R"(no item of kind "choice" and no pair offers ")" + name + "\"" +
                            did_you_mean(name, names));
    }
    ScoreItem like;
    like.weight = name;
    add_items(table, name, like, instrument, score);
  }
}

void read_range(const TomlTable& table, Score& score) {
  if (!table.has("range")) return;
  const std::vector<double> ends = table.numbers("range");
  const bool good = ends.size() == 2 && ends[0] >= -largest_number && ends[1] <= largest_number &&
                    ends[0] < ends[1];
  if (good) {
    score.range = ValueRange{ends[0], ends[1]};
  } else {
    table.error("range", "\"range\" must be two numbers that ascend, such as [0, 100]");
  }
}

void refuse_for_sums(const TomlTable& table, const Score& score) {
  if (score.mean) return;
  for (const char* key : {"range", "weighted"}) {
    if (table.has(key)) {
      table.error(key, fmt::format(R"("{}" is for means; leave out "combine")", key));
    }
  }
}

Score read_score(const TomlTable& table, const Instrument& instrument) {
  Score score;
  score.name = read_name(table);
  score.mean = table.choice("combine", {"mean", "sum"}) != "sum";
  read_range(table, score);
  ScoreItem reversed;
  reversed.reversed = true;
  add_items(table, "items", {}, instrument, score);
  add_items(table, "reversed", reversed, instrument, score);
  if (const auto weighted = table.table("weighted")) add_weighted(*weighted, instrument, score);
  refuse_for_sums(table, score);
  if (score.items.empty() && table.reader().ok()) {
    table.error(R"(a score needs "items", "reversed" or "weighted")");
  }
  return score;
}

}  // namespace

std::vector<Score> read_scores(const TomlTable& root, const Instrument& instrument) {
  std::vector<Score> scores;
  std::vector<std::string> names;
  const std::vector<TomlTable> tables = root.tables("score");
  if (tables.size() > most_scores) {
    root.error("score", fmt::format("an instrument has up to {} scores", most_scores));
    return scores;
  }
  for (const TomlTable& table : tables) {
    scores.push_back(read_score(table, instrument));
    names.push_back(scores.back().name);
  }
  refuse_doubles(tables, names, "score");
  return scores;
}

}  // namespace promenade::study
