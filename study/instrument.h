// A questionnaire as data: items, how they are answered, how answers become scores, and
// what to cite. configs/instruments/NAME.toml holds those that come with the program; a
// study may name a file of its own. docs/study-file.md describes the format.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/texts.h"

namespace promenade::study {

enum class ItemKind {
  scale,    // one of the numbers from `least` to `most` in steps of `step`
  choice,   // one of `choices`
  number,   // any number from `least` to `most`
  text,     // free words
  ranking,  // all of `choices`, the best first
  agree     // a box to be ticked: 1, or nothing
};

struct Choice {
  std::string name;  // as in the results
  LocalText text;
};

struct Item {
  std::string name;  // as in the results; unique within the instrument
  ItemKind kind = ItemKind::scale;
  LocalText question;   // empty: the two poles say it
  LocalText low, high;  // words at the ends of a scale
  double least = 1, most = 7, step = 1;
  std::vector<Choice> choices;
  bool interfaces = false;    // the choices are the interfaces of the study
  bool needed = true;         // nobody goes on without an answer, or declining it
  bool can_decline = false;   // there is a button "I would rather not say"
  int longest = 2000;         // of a text, characters
};

// score = factor * (sum or mean of the contributions), where an item contributes
// value - least, or most - value when it is reversed (`from_zero`), else the value itself.
struct ScoreItem {
  std::string item;
  bool reversed = false;
  // Weighted scores (NASA-TLX, CSI): times how often this name was chosen in the items of
  // kind choice; empty: once.
  std::string weight;
};
struct Score {
  std::string name;
  std::vector<ScoreItem> items;
  bool mean = true;        // else the sum
  bool from_zero = false;  // contributions count from the low end of the scale
  double factor = 1, offset = 0;
  std::string unit;  // "0 to 100"
};

struct Instrument {
  std::string name, version = "1";
  LocalText title, text;  // of its page
  std::string citation;   // empty: the study's own
  std::string terms;      // under which it may be used
  std::string translations;  // who translated it: "ja: by Promenade, not validated"
  bool shuffled = false;     // the items, anew for each person and page; the order is stored
  std::vector<Item> items;
  std::vector<Score> scores;
};

const Item* find_item(const Instrument& instrument, std::string_view name);  // null: none

// An answer to one item. A ranking and a text are in `text`: the names in order, one a line.
struct ItemAnswer {
  std::optional<double> value;
  std::string text;
  bool declined = false;

  bool given() const { return declined || value.has_value() || !text.empty(); }
};

// Is it one that the item allows? A choice is known by its place among the choices, from 1,
// and `text` is its name.
bool allows(const Item& item, const ItemAnswer& answer);

// A score of the answers to all items, in the order of the instrument; nothing where an
// item that it needs was declined or left out.
std::optional<double> score_of(const Instrument& instrument, const Score& score,
                               const std::vector<ItemAnswer>& answers);

}  // namespace promenade::study
