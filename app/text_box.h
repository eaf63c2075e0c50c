// A box to write in, of one line or several. What is written stays in a draft, whatever
// becomes of the field: the Escape key takes nothing back.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/widgets.h"
#include "app/written_text.h"

namespace promenade::app {

struct Draft {
  WrittenText text;
  std::vector<char> buffer;     // for Dear ImGui
  bool begun = false;           // it has taken over what was there before
  bool active = false;          // the keyboard writes in it
  bool changed = false;         // in this frame
  bool entered = false;         // Enter was pressed in it, in this frame; of one line only
  std::int64_t changed_us = 0;  // when it did so last
};

struct TextBoxOptions {
  int most = 2000;      // characters
  bool several = true;  // lines
  const char* hint = "";
};

// Enters itself into the map as "type", `target`.
void text_box(const Ui& ui, std::string_view target, const Box& box, Draft& draft,
              const TextBoxOptions& options, std::int64_t now_us);

}  // namespace promenade::app
