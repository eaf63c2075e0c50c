// [[item]] and [pairs] of an instrument.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "study/instrument_parts.h"

namespace promenade::study {
namespace {

using Languages = std::vector<std::string>;

constexpr std::size_t most_items = 200;
constexpr std::size_t most_choices = 50;
constexpr std::size_t most_paired = 15;  // names: 105 pairs
constexpr int most_steps = 100;
constexpr double smallest_step = 0.001;
constexpr int longest_text = 10'000;

// The ends and the words of a scale; what the table does not say stays as it is.
void read_scale(const TomlTable& table, const Languages& languages, Item& item) {
  if (table.has("low")) item.low = read_words(table, "low", languages);
  if (table.has("high")) item.high = read_words(table, "high", languages);
  const auto bound = [&](const char* key, double least, double& value) {
    value = table.number(key, least, largest_number).value_or(value);
  };
  bound("least", -largest_number, item.least);
  bound("most", -largest_number, item.most);
  bound("step", smallest_step, item.step);
}

// Only where the table says something about it.
void check_scale(const TomlTable& table, const Item& item) {
  const std::array keys = {"most", "least", "step"};
  const auto* const key =
      std::find_if(keys.begin(), keys.end(), [&](const char* k) { return table.has(k); });
  if (key == keys.end()) return;
  const double steps = (item.most - item.least) / item.step;
  if (item.least >= item.most) {
    table.error(*key, fmt::format("a scale from {} to {} has no steps: \"least\" must be below "
                                  "\"most\"",
                                  item.least, item.most));
  } else if (std::abs(steps - std::round(steps)) > 1e-6) {
    table.error(*key, fmt::format("a scale from {} to {} cannot be cut into steps of {}",
                                  item.least, item.most, item.step));
  } else if (steps > most_steps + 0.5) {
    table.error(*key, fmt::format("a scale has up to {} steps, but this one has {:.0f}", most_steps,
                                  steps));
  }
}

void read_number(const TomlTable& table, Item& item) {
  for (const char* key : {"least", "most"}) table.require(key);
  item.least = table.number("least", -largest_number, largest_number).value_or(0);
  item.most = table.number("most", -largest_number, largest_number).value_or(item.least + 1);
  if (item.least >= item.most) table.error("most", R"("most" must be above "least")");
}

Choice read_choice(const TomlTable& table, const Languages& languages) {
  Choice choice;
  choice.name = read_name(table);
  choice.text = read_languages(table, choice.name, languages);
  for (const auto& [language, words] : choice.text) {
    if (words.empty() && !choice.name.empty())
      table.error(language, fmt::format("\"{}\" must not be empty", language));
  }
  return choice;
}

// Problems of their number come first: of far too many nothing else is said.
bool is_good_count(const TomlTable& table, std::size_t count, std::size_t most) {
  if (count >= 2 && count <= most) return true;
  if (!table.has("choices")) {
    table.require("choices");
  } else if (table.is("choices", TomlValue::Kind::array)) {
    table.error("choices", fmt::format("there must be from 2 to {} choices", most));
  }
  return count <= most;
}

std::vector<Choice> read_choices(const TomlTable& table, const Languages& languages,
                                 bool can_be_free, std::size_t most) {
  std::vector<Choice> choices;
  std::vector<std::string> names;
  const std::vector<TomlTable> tables = table.tables("choices");
  if (!is_good_count(table, tables.size(), most)) return choices;
  for (const TomlTable& one : tables) {
    choices.push_back(read_choice(one, languages));
    if (can_be_free) choices.back().free = one.boolean("free").value_or(false);
    names.push_back(choices.back().name);
  }
  refuse_doubles(tables, names, "choice");
  return choices;
}

void read_item_choices(const TomlTable& table, const Languages& languages, Item& item) {
  item.interfaces = table.boolean("interfaces").value_or(false);
  if (!item.interfaces) {
    item.choices = read_choices(table, languages, item.kind == ItemKind::choice, most_choices);
  } else if (table.has("choices")) {
    table.tables("choices");
    table.error("choices",
                "the choices are the interfaces of the study; leave these out, or "
                "\"interfaces = true\"");
  }
}

void read_longest(const TomlTable& table, Item& item) {
  const auto longest = table.integer("longest", 1, longest_text);
  item.longest = static_cast<int>(longest.value_or(item.longest));
}

// What belongs to the kind of the item.
void read_answer(const TomlTable& table, const Languages& languages, Item& item) {
  switch (item.kind) {
    case ItemKind::scale:
      read_scale(table, languages, item);
      return check_scale(table, item);
    case ItemKind::number:
      return read_number(table, item);
    case ItemKind::choice:
      read_longest(table, item);
      return read_item_choices(table, languages, item);
    case ItemKind::ranking:
      return read_item_choices(table, languages, item);
    case ItemKind::text:
      return read_longest(table, item);
    case ItemKind::agree:
      return;
  }
}

// Of an item whose kind is not known: what it says is not looked at.
void accept_answer_keys(const TomlTable& table) {
  for (const char* key : {"low", "high", "least", "most", "step", "longest", "interfaces"}) {
    if (table.is(key, TomlValue::Kind::table)) {
      table.table(key);
    } else {
      table.scalar(key);
    }
  }
  table.tables("choices");
}

const std::vector<ItemKind>& all_kinds() {
  static const std::vector<ItemKind> kinds = {ItemKind::scale, ItemKind::choice,  ItemKind::number,
                                              ItemKind::text,  ItemKind::ranking, ItemKind::agree};
  return kinds;
}

// Nothing after a problem.
std::optional<ItemKind> read_kind(const TomlTable& table) {
  std::vector<std::string> words;
  for (const ItemKind kind : all_kinds()) words.emplace_back(to_text(kind));
  table.require("kind");
  const auto word = table.choice("kind", words);
  if (!word) return std::nullopt;
  const auto found = std::find(words.begin(), words.end(), *word);
  return all_kinds()[static_cast<std::size_t>(found - words.begin())];
}

// Two poles are a question too.
void check_question(const TomlTable& table, const Item& item) {
  const bool poles = item.kind == ItemKind::scale && table.has("low") && table.has("high");
  if (!poles) table.require("question");
}

// `standard`: what the file says of all its scales.
Item read_item(const TomlTable& table, const Languages& languages, const Item& standard) {
  Item item;
  item.name = read_name(table);
  item.question = read_words(table, "question", languages);
  item.needed = table.boolean("needed").value_or(true);
  item.can_decline = table.boolean("can_decline").value_or(false);
  const std::optional<ItemKind> kind = read_kind(table);
  if (!kind) {
    accept_answer_keys(table);
    return item;
  }
  item.kind = *kind;
  if (item.kind == ItemKind::scale) {
    item.low = standard.low;
    item.high = standard.high;
    item.least = standard.least;
    item.most = standard.most;
    item.step = standard.step;
  }
  read_answer(table, languages, item);
  check_question(table, item);
  return item;
}

// None of far too many.
std::vector<Item> read_item_tables(const std::vector<TomlTable>& tables, const Languages& languages,
                                   const Item& standard) {
  std::vector<Item> items;
  std::vector<std::string> names;
  if (tables.size() > most_items) return items;
  for (const TomlTable& table : tables) {
    items.push_back(read_item(table, languages, standard));
    names.push_back(items.back().name);
  }
  refuse_doubles(tables, names, "item");
  return items;
}

// One choice between two names. Each name stands first in half of its pairs, or one more.
Item make_pair_of(const std::vector<Choice>& choices, std::size_t i, std::size_t j) {
  const bool in_order = (j - i) % 2 == 1;
  const Choice& first = choices[in_order ? i : j];
  const Choice& second = choices[in_order ? j : i];
  Item item;
  item.name = first.name + "-" + second.name;
  item.kind = ItemKind::choice;
  item.choices = {first, second};
  item.pair = true;
  return item;
}

std::vector<Item> read_pairs(const TomlTable& table, const Languages& languages) {
  table.require("question");
  const LocalText question = read_words(table, "question", languages);
  const bool can_decline = table.boolean("can_decline").value_or(false);
  const std::vector<Choice> choices = read_choices(table, languages, false, most_paired);
  std::vector<Item> items;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    for (std::size_t j = i + 1; j < choices.size(); ++j) {
      items.push_back(make_pair_of(choices, i, j));
      items.back().question = question;
      items.back().can_decline = can_decline;
    }
  }
  return items;
}

void add_pairs(const TomlTable& table, const Languages& languages, std::vector<Item>& items) {
  for (Item& pair : read_pairs(table, languages)) {
    const bool known = std::any_of(items.begin(), items.end(),
                                   [&](const Item& item) { return item.name == pair.name; });
    if (known) {
      table.error("choices",
                  "there is another item with the name of the pair \"" + pair.name + "\"");
    }
    items.push_back(std::move(pair));
  }
}

}  // namespace

LocalText read_words(const TomlTable& table, std::string_view key, const Languages& languages) {
  LocalText text = read_local_text(table, key, languages);
  const bool empty =
      std::any_of(text.begin(), text.end(), [](const auto& entry) { return entry.second.empty(); });
  const bool none = text.empty() && table.is(key, TomlValue::Kind::table);
  if (empty || none) table.error(key, fmt::format("\"{}\" must not be empty", key));
  return text;
}

std::vector<Item> read_items(const TomlTable& root, const Languages& languages) {
  Item standard;
  read_scale(root, languages, standard);
  check_scale(root, standard);
  const std::vector<TomlTable> tables = root.tables("item");
  std::vector<Item> items = read_item_tables(tables, languages, standard);
  if (const auto pairs = root.table("pairs")) add_pairs(*pairs, languages, items);
  if (!root.has("item") && !root.has("pairs")) {
    root.error("an instrument needs at least one [[item]], or [pairs]");
  }
  if (std::max(tables.size(), items.size()) > most_items) {
    root.error("item", fmt::format("an instrument has up to {} items and pairs", most_items));
  }
  return items;
}

}  // namespace promenade::study
