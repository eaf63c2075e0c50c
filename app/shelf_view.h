// Draws the shelf and reports what is done to it: the same under the map and under the
// list of labels.
#pragma once

#include "app/panel.h"
#include "app/shelf.h"
#include "app/short_line.h"

namespace promenade::app {

// The upper part of a panel, for the interface itself, and the shelf under it.
Box upper_part(const study::InterfacePanel& panel);
void draw_shelf(const Shelf& shelf, study::InterfacePanel& panel);

// One meaning of a press: it goes there; on what is shown already it offers the rest.
// `kind` goes to an example.
void report_press(const Shelf& shelf, const Item& item, std::string_view kind,
                  study::InterfacePanel& panel);

// As people read it: the name of an example, the bookmark's or "Bookmark 2".
ShortLine name_of(const Shelf& shelf, const Item& item, const study::InterfacePanel& panel);

// "1" to "9".
std::string_view digit_of(const Bookmark& bookmark);

inline constexpr std::array shelf_texts = {
    "interface.shelf.add",    "interface.shelf.keep",    "interface.shelf.named",
    "interface.shelf.mix",    "interface.shelf.mixed",   "interface.shelf.rename",
    "interface.shelf.remove", "interface.shelf.hint",    "interface.shelf.name_hint",
    "interface.shelf.one",    "interface.shelf.all_zero"};
// `own` and those of the shelf.
std::vector<std::string> with_shelf_texts(std::vector<std::string> own);

}  // namespace promenade::app
