#include "app/number_box.h"

#include <algorithm>
#include <charconv>

namespace promenade::app {
namespace {

int step_by_key(const Draft& draft) {
  if (!draft.active) return 0;
  const int by = ImGui::GetIO().KeyShift ? 10 : 1;
  if (key_pressed(ImGuiKey_UpArrow)) return by;
  return key_pressed(ImGuiKey_DownArrow) ? -by : 0;
}

int written_number(const std::string& words, int otherwise) {
  int value = otherwise;
  std::from_chars(words.data(), words.data() + words.size(), value);
  return value;
}

}  // namespace

bool number_box(const Ui& ui, std::string_view target, const Box& box, NumberDraft& number,
                int least, int most, std::int64_t now_us) {
  const int before = number.value;
  const float side = box.height;
  const Box less{box.x, box.y, side, side};
  const Box more{box.right() - side, box.y, side, side};
  Draft& draft = number.draft;
  if (icon_button(ui, "less", target, less, Icon::minus, number.value > least)) --number.value;
  text_box(ui, target, {less.right(), box.y, box.width - 2 * side, side}, draft,
           {.most = 9, .several = false}, now_us);
  if (draft.changed) number.value = written_number(draft.text.words(), number.value);
  if (icon_button(ui, "more", target, more, Icon::plus, number.value < most)) ++number.value;
  number.value = std::clamp(number.value + step_by_key(draft), least, most);
  const std::string words = std::to_string(number.value);
  if (!draft.active && draft.text.words() != words) draft.text.set(words);
  return number.value != before;
}

}  // namespace promenade::app
