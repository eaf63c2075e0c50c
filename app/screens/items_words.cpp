// Answers that are written: words and numbers. They are told when the field is left, and
// while nobody types, not letter by letter.
#include <algorithm>
#include <charconv>

#include "app/screens/items.h"

namespace promenade::app {
namespace {

constexpr std::int64_t rest_us = 700'000;

bool settled(const Screen& screen, const Draft& draft) {
  return !draft.active || screen.now_us - draft.changed_us >= rest_us;
}

// What was answered before stands in the field at first, and again when it was taken back.
Draft& draft_of(const Screen& screen, const std::string& key, const std::string& answer) {
  Draft& draft = screen.memory.drafts[key];
  if (!draft.begun) draft.text.set(answer);
  draft.begun = true;
  return draft;
}

bool blank(const std::string& text) { return text.find_first_not_of(" \n") == std::string::npos; }

void decline_clears(Draft& draft, const study::ItemAnswer& answer) {
  if (answer.declined && !draft.active && !draft.text.words().empty()) draft.text.set("");
}

}  // namespace

void put_text(Pen& pen, const study::Item& item, const study::ItemAnswer& answer) {
  const Box box = pen.take(pen.size(pen.style.beside ? 92 : 132));
  if (!pen.draws) return;
  Draft& draft = draft_of(pen.screen, item.name, answer.text);
  text_box(pen.ui, words_target(item.name), box, draft,
           {.most = item.longest, .hint = pen.screen.texts("items.write").c_str()},
           pen.screen.now_us);
  if (pen.ui.inert) return;
  if (!draft.changed && !draft.active) decline_clears(draft, answer);
  const std::string words = blank(draft.text.words()) ? "" : draft.text.words();
  const bool told = words == answer.text || (words.empty() && answer.declined);
  if (!told && settled(pen.screen, draft)) pen.answer({item.name, std::nullopt, words});
}

void put_own_words(Pen& pen, const study::Item& item, const study::ItemAnswer& answer) {
  pen.skip(8);
  const Box box = pen.take(pen.size(44));
  if (!pen.draws) return;
  const auto place = static_cast<std::size_t>(*answer.value) - 1;
  const std::string& name = item.choices[place].name;
  const std::string target = own_target(item.name);
  Draft& draft = draft_of(pen.screen, target, answer.text == name ? "" : answer.text);
  if (pen.screen.memory.writes_next == target) {
    pen.ui.focus.write_in("type", target);
    pen.screen.memory.writes_next.clear();
  }
  text_box(pen.ui, target, box, draft,
           {.most = item.longest, .several = false, .hint = pen.screen.texts("items.own").c_str()},
           pen.screen.now_us);
  const std::string words = blank(draft.text.words()) ? name : draft.text.words();
  if (words != answer.text && settled(pen.screen, draft)) {
    pen.answer({item.name, answer.value, words});
  }
}

namespace {

// As people type it: full-width digits and a decimal comma too.
std::string plain_number(std::string_view typed) {
  std::string plain;
  for (std::size_t i = 0; i < typed.size(); ++i) {
    const bool wide = typed.substr(i, 2) == "\xEF\xBC" && i + 2 < typed.size();
    const char letter =
        wide ? static_cast<char>(static_cast<unsigned char>(typed[i + 2]) - 0x90 + '0') : typed[i];
    if (wide) i += 2;
    if (letter != ' ') plain += letter == ',' ? '.' : letter;
  }
  return plain;
}

std::optional<double> number_in(const std::string& typed, const study::Item& item) {
  const std::string plain = plain_number(typed);
  double value = 0;
  const auto [end, error] = std::from_chars(plain.data(), plain.data() + plain.size(), value);
  const bool whole = error == std::errc() && end == plain.data() + plain.size();
  if (!whole || !(value >= item.least && value <= item.most)) return std::nullopt;
  return value;
}

}  // namespace

void put_number(Pen& pen, const study::Item& item, const study::ItemAnswer& answer) {
  const Box row = pen.take(pen.size(44));
  if (!pen.draws) return;
  Draft& draft = draft_of(pen.screen, item.name, answer.value ? value_text(*answer.value) : "");
  const Box box{row.x, row.y, pen.size(160), row.height};
  text_box(pen.ui, words_target(item.name), box, draft, {.most = 24, .several = false},
           pen.screen.now_us);
  const std::optional<double> value = number_in(draft.text.words(), item);
  const bool wrong = !value && !draft.text.words().empty() && !draft.active;
  const Fonts& fonts = pen.ui.look.fonts;
  draw_text(
      wrong ? fonts.bold : fonts.text, {box.right() + pen.size(16), row.y, row.width, row.height},
      wrong ? pen.ui.look.palette.text : pen.ui.look.palette.quiet,
      pen.screen.texts.with("items.range",
                            {{"least", value_text(item.least)}, {"most", value_text(item.most)}}));
  if (pen.ui.inert) return;
  if (!draft.changed && !draft.active) decline_clears(draft, answer);
  const bool told = value == answer.value || (!value && answer.declined);
  if (told || !settled(pen.screen, draft)) return;
  pen.answer(value ? study::SetAnswer{item.name, value} : study::SetAnswer{item.name});
}

}  // namespace promenade::app
