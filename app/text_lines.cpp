// One line of text that always fits.
#include "app/widgets.h"
#include "study/utf8.h"

namespace promenade::app {
namespace {

std::size_t before(std::string_view text, std::size_t at) {
  do {
    --at;
  } while (at > 0 && !study::begins_character(text[at]));
  return at;
}

std::size_t after(std::string_view text, std::size_t at) {
  do {
    ++at;
  } while (at < text.size() && !study::begins_character(text[at]));
  return at;
}

}  // namespace

Gap fitting_gap(ImFont* font, std::string_view text, float width) {
  const float dots = text_width(font, ellipsis);
  std::size_t head = 0;
  std::size_t tail = text.size();
  float used = dots;
  // Letters are taken from both ends by turns until the next one has no room.
  for (bool from_head = true; head < tail; from_head = !from_head) {
    const std::size_t next = from_head ? after(text, head) : before(text, tail);
    const std::string_view letter =
        from_head ? text.substr(head, next - head) : text.substr(next, tail - next);
    used += text_width(font, letter);
    if (used > width) break;
    (from_head ? head : tail) = next;
  }
  return {head, tail};
}

void draw_line(ImFont* font, const Box& box, const Rgb& colour, std::string_view text,
               Align align) {
  if (text_width(font, text) <= box.width) return draw_text(font, box, colour, text, align);
  const Gap gap = fitting_gap(font, text, box.width);
  const std::string_view head = text.substr(0, gap.head);
  Box rest = box;
  draw_text(font, rest, colour, head);
  rest.x += text_width(font, head);
  draw_text(font, rest, colour, ellipsis);
  rest.x += text_width(font, ellipsis);
  draw_text(font, rest, colour, text.substr(gap.tail));
}

}  // namespace promenade::app
