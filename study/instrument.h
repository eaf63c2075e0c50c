// A questionnaire as data: items, how they are answered, how answers become scores, and
// what to cite. configs/instruments/NAME.toml holds those that come with the program; a
// study may name a file of its own. docs/instruments.md describes the format,
// load_instrument.h reads it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "study/rng.h"
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

std::string_view to_text(ItemKind kind);  // "scale", as in the file

struct Choice {
  std::string name;  // as in the results
  LocalText text;
  bool free = false;  // the person may say it in own words (kind choice)
};

struct Item {
  std::string name;  // as in the results; unique within the instrument
  ItemKind kind = ItemKind::scale;
  LocalText question;   // empty: the two poles say it
  LocalText low, high;  // words at the ends of a scale
  double least = 1, most = 7, step = 1;
  std::vector<Choice> choices;
  bool interfaces = false;   // the choices are the interfaces of the study: with_interfaces
  bool pair = false;         // made by [pairs]: one choice between two of its names
  bool needed = true;        // nobody goes on without an answer, or declining it
  bool can_decline = false;  // there is a button "I would rather not say"
  int longest = 2000;        // of a text, and of own words of a free choice, characters
};

// What answers or scores lie between.
struct ValueRange {
  double least = 0, most = 0;
};

struct ScoreItem {
  std::string item;       // of kind scale or number
  bool reversed = false;  // counts as least + most - value
  // It counts as often as this name was chosen in the items of kind choice that offer it
  // (NASA-TLX, CSI); empty: once.
  std::string weight;
};

// The mean of its items, which have one range; SUS and others bring it onto a range of their
// own, so that 1 to 5 becomes 0 to 100.
struct Score {
  std::string name;
  std::vector<ScoreItem> items;
  bool mean = true;                 // else the sum; then nothing weighs, and there is no range
  std::optional<ValueRange> range;  // onto which the mean is brought; nothing: that of the items
};

struct Instrument {
  std::string name, version = "1";
  LocalText title, text;     // of its page
  std::string citation;      // empty: the study's own
  std::string terms;         // under which it may be used
  std::string translations;  // who translated it: "ja: by Promenade, not validated"
  bool shuffled = false;     // the items, anew for each person and page; the order is stored
  std::vector<Item> items;
  std::vector<Score> scores;
};

const Item* find_item(const Instrument& instrument, std::string_view name);  // null: none

// The order in which a person meets the items, as indices: those of [[item]] as they stand,
// or shuffled; those of [pairs] always shuffled. Each stays among its own.
std::vector<int> item_order(const Instrument& instrument, Rng& rng);

// With the interfaces of a study as the choices of the items that ask for them.
Instrument with_interfaces(Instrument instrument, const std::vector<Choice>& interfaces);

// An answer to one item. A ranking and a text are in `text`: the names in order, one a line.
struct ItemAnswer {
  std::optional<double> value;
  std::string text;
  bool declined = false;

  bool given() const { return declined || value.has_value() || !text.empty(); }
};

// Is it one that the item allows? A choice is known by its place among the choices, from 1,
// and `text` is its name, or the person's own words where the choice is free. No answer is
// allowed where none is needed.
bool allows(const Item& item, const ItemAnswer& answer);

// A score of the answers to all items, in the order of the instrument; nothing where an
// item that it needs was declined or left out. An item of weight 0 is not needed.
std::optional<double> score_of(const Instrument& instrument, const Score& score,
                               const std::vector<ItemAnswer>& answers);

// The least and the most that score_of can give.
ValueRange score_range(const Instrument& instrument, const Score& score);

}  // namespace promenade::study
