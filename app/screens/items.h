// The items of a questionnaire, one below the other, on a page or in the panel of a rate
// task. A pen goes over them twice: once to measure, once to draw, so that the two cannot
// disagree. items.cpp arranges them; each kind of answer has its own file.
#pragma once

#include "app/item_targets.h"
#include "app/screens/screen.h"

namespace promenade::app {

// At 1280 x 720.
struct ItemStyle {
  ImFont* font = nullptr;  // of the questions
  float between = 28;      // two items
  float above = 14;        // the answers
  float cell = 52;         // a number of a scale
  float row = 44;          // a choice, an option
  bool beside = false;     // the words of a scale stand beside its numbers
};

struct Pen {
  const Screen& screen;
  const Ui& ui;  // inert in a picture
  ItemStyle style;
  float x = 0, y = 0, width = 0;  // pixels; y goes down
  float pole = 0;                 // the widest word at the end of a short scale
  bool draws = false;             // else it only measures

  float size(float at_720) const { return ui.layout.size(at_720); }
  void skip(float at_720) { y += size(at_720); }
  // The next `height` pixels over the whole width.
  Box take(float height);
  void write(ImFont* font, const Rgb& colour, std::string_view text);
  std::string_view in_language(const study::LocalText& text) const;
  void answer(study::SetAnswer set) const;
};

// What is asked, in which order, and what was answered so far.
struct Sheet {
  const study::Instrument& instrument;
  const std::vector<study::ItemAnswer>& answers;  // in the order of the instrument
  const std::vector<int>& order;                  // indices of the items, as shown
};

// The words above the items, and the items; scrolls when there is no room. `narrow`: small
// letters, little room. Marks what is missing once somebody wanted to go on too early.
void draw_sheet(const Screen& screen, const Sheet& sheet, const Box& box, bool narrow);
// The same to be looked at.
void draw_sheet_picture(const Screen& screen, const study::Instrument& instrument, const Box& box);
// Typed digits answer the item that has the keyboard, else the first open one.
void take_digits(const Screen& screen, const Sheet& sheet);
// The questions of this page or trial.
Sheet sheet_of(const Screen& screen);
// The first item that is needed and has no answer; null: none. `count`: how many there are.
const study::Item* first_open(const Sheet& sheet, int& count);
// What asks for an answer: the question, or the two poles.
std::string name_of(const Screen& screen, const study::Item& item);

// Each kind of answer, below the question.
void put_scale(Pen& pen, const study::Item& item, const study::ItemAnswer& answer);
void put_choice(Pen& pen, const study::Item& item, const study::ItemAnswer& answer);
void put_ranking(Pen& pen, const study::Item& item, const study::ItemAnswer& answer);
void put_agree(Pen& pen, const study::Item& item, const study::ItemAnswer& answer);
void put_text(Pen& pen, const study::Item& item, const study::ItemAnswer& answer);
void put_number(Pen& pen, const study::Item& item, const study::ItemAnswer& answer);
// The person's own words for a choice that is free.
void put_own_words(Pen& pen, const study::Item& item, const study::ItemAnswer& answer);

// Scales.
constexpr int most_numbers = 11;  // on buttons; beyond that they are narrow cells
int points_of(const study::Item& item);
double value_at(const study::Item& item, int point);  // point: from 0
int point_of(const study::Item& item, const study::ItemAnswer& answer);  // -1: none
// Two opposite words: only they are shown, no numbers.
bool has_poles(const study::Item& item);
// Puts an option at the end of the order, or takes it out; an order is an answer once it is
// complete.
void rank(const Screen& screen, const study::Item& item, const study::ItemAnswer& answer,
          const std::string& option);

}  // namespace promenade::app
