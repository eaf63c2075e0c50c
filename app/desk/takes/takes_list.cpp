#include "app/desk/takes/takes_list.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>

#include "app/choice.h"
#include "app/desk/column.h"
#include "app/scroll_area.h"
#include "study/capture_files.h"

namespace promenade::app {
namespace {

constexpr std::array<double, 5> units = {1, 0.01, 0.001, 0.0254, 0.0254 / 0.45};
constexpr float row_height = 38, failed_height = 62, head_height = 34;  // at 1280 x 720

// Of the list, in its order.
enum class Part { refused, used, left_out };

Part part_of(const study::Verdict& verdict) {
  if (verdict.refused()) return Part::refused;
  return verdict.state == study::TakeState::left_out ? Part::left_out : Part::used;
}

void draw_head(const Ui& ui, const study::Texts& words, const Box& box, Part part, int count) {
  const char* key = part == Part::refused ? "takes.head.refused"
                    : part == Part::used  ? "takes.head.used"
                                          : "takes.head.left_out";
  draw_text(ui.look.fonts.bold, {box.x + ui.layout.size(10), box.y, box.width, box.height},
            part == Part::refused ? ui.look.palette.alarm : ui.look.palette.quiet,
            words.with(key, {{"count", std::to_string(count)}}));
}

std::string home_folder() {
  const char* home = std::getenv("HOME");
  return home != nullptr && *home != 0 ? home : "/";
}

}  // namespace

TakesList::TakesList(TakesWork& work) : work_(work), files_(home_folder(), {".bvh", ".amc"}) {}

const std::vector<std::string>& TakesList::names() {
  if (named_ == work_.shop().revision()) return names_;
  named_ = work_.shop().revision();
  std::vector<std::string> files;
  for (const study::WorkshopTake& take : work_.shop().takes()) files.push_back(take.source.file);
  names_ = study::short_names(files);
  return names_;
}

void TakesList::take_path() {
  const std::string path = path_.text.words();
  if (path.empty()) return;
  work_.add({path.starts_with("~/") ? home_folder() + path.substr(1) : path});
  if (work_.trouble().empty()) path_ = {};
}

void TakesList::draw(const Ui& ui, const study::Texts& words, const Box& box, std::int64_t now_us) {
  Column column(ui, box);
  Box line = column.take(40, 6);
  const float gap = ui.layout.size(6);
  const float wide = text_width(ui.look.fonts.text, words("takes.browse")) + ui.layout.size(20);
  text_box(ui, "path", {line.x, line.y, line.width - wide - gap, line.height}, path_,
           {.most = 500, .several = false, .hint = words("takes.path_hint").c_str()}, now_us);
  if (path_.entered) take_path();
  if (button(ui, "browse", {line.right() - wide, line.y, wide, line.height}, words("takes.browse"),
             ButtonKind::outlined)) {
    browsing_ = !browsing_;
  }
  if (!work_.trouble().empty()) {
    column.words(ui.look.fonts.text, ui.look.palette.alarm,
                 words.with("takes.nothing_there", {{"path", work_.trouble()}}), 6);
  }
  Box left = column.left();
  draw_unit(ui, words, left);
  draw_rows(ui, words, left);
  move_by_key(ui);
}

// What was guessed for most takes is confirmed for all of them at once.
void TakesList::draw_unit(const Ui& ui, const study::Texts& words, Box& left) {
  const std::vector<std::size_t> guessed = guessed_units(work_.shop());
  if (guessed.empty()) return;
  const double guess = common_guess(work_.shop(), guessed);
  std::vector<std::size_t> alike;
  std::copy_if(guessed.begin(), guessed.end(), std::back_inserter(alike),
               [&](std::size_t t) { return work_.shop().review(t)->figure.unit_m == guess; });
  const auto leg = work_.shop().review(alike.front())->figure.leg_m;
  const std::string text = words.with(
      alike.size() == 1 ? "takes.unit_says_one" : "takes.unit_says_many",
      {{"count", std::to_string(alike.size())}, {"leg", std::to_string(std::lround(100 * leg))}});
  const Chip chip{words.with("takes.unit_guessed", {{"unit", unit_name(guess, words)}}),
                  ChipKind::doubt};
  const float in = ui.layout.size(8), line = ui.layout.size(28);
  const float high = paragraphs_height(ui.look.fonts.text, left.width - 2 * in, text);
  const Box card{left.x, left.y, left.width, line + high + ui.layout.size(36) + 4 * in};
  const Palette& palette = ui.look.palette;
  fill(card, palette.panel);
  draw_chip(ui,
            {card.x + in, card.y + in, std::min(chip_width(ui, chip), card.width - 2 * in), line},
            chip);
  draw_paragraphs(ui.look.fonts.text, card.x + in, card.y + line + 2 * in, card.width - 2 * in,
                  palette.text, text);
  const float half = (card.width - 3 * in) / 2;
  const Box yes{card.x + in, card.bottom() - in - ui.layout.size(36), half, ui.layout.size(36)};
  if (button(ui, "unit_right", yes, words("takes.unit_right"), ButtonKind::outlined)) {
    work_.shop().set_unit(alike, guess);
  }
  std::vector<std::string> names = {words("takes.unit_other")};
  for (const double unit : units) names.push_back(unit_name(unit, words));
  const auto other = drop_down(ui, "unit", {yes.right() + in, yes.y, half, yes.height}, names, 0);
  if (other && *other > 0) work_.shop().set_unit(alike, units[*other - 1]);
  left.y = card.bottom() + in;
  left.height -= card.height + in;
}

// A line over each part of the list says what it is, and how many.
void TakesList::draw_rows(const Ui& ui, const study::Texts& words, const Box& box) {
  const std::vector<std::size_t> list = work_.listed();
  std::map<Part, int> counts;
  for (const std::size_t t : list) ++counts[part_of(work_.shop().verdict(t))];
  const float head = ui.layout.size(head_height);
  const auto height = [&](std::size_t t) {
    return ui.layout.size(work_.shop().verdict(t).refused() ? failed_height : row_height);
  };
  float high = static_cast<float>(counts.size()) * head;
  for (const std::size_t t : list) high += height(t);
  scrolled("takes", box, high, [&](const Box& all) {
    float y = all.y;
    for (const std::size_t t : list) {
      const Part part = part_of(work_.shop().verdict(t));
      if (const auto count = counts.find(part); count != counts.end()) {
        draw_head(ui, words, {all.x, y, all.width, head}, part, count->second);
        y += head;
        counts.erase(count);
      }
      draw_row(ui, words, {all.x, y, all.width, height(t)}, t);
      y += height(t);
    }
  });
}

void TakesList::draw_row(const Ui& ui, const study::Texts& words, const Box& box,
                         std::size_t take) {
  const Palette& palette = ui.look.palette;
  const bool shown = work_.take() == take;
  if (pressed_area(ui, "take", work_.shop().label(take), box, shown)) {
    work_.look_at(take);
    browsing_ = false;
  }
  if (!ImGui::IsRectVisible({box.x, box.y}, {box.right(), box.bottom()})) return;
  if (shown) fill(box, palette.on_colour);
  if (shown) fill({box.x, box.y, ui.layout.size(4), box.height}, palette.created);
  const Chip chip = chip_of(work_.shop(), take, words);
  const float in = ui.layout.size(10);
  const float high = ui.layout.size(26);
  const bool failed = chip.kind == ChipKind::failed;
  const float room = box.width - 2 * in;
  const float wide = std::min(chip_width(ui, chip), failed ? room : 0.6f * room);
  const Box chip_box = failed ? Box{box.x + in, box.bottom() - high - ui.layout.size(8), wide, high}
                              : Box{box.right() - in - wide,
                                    box.y + std::round(0.5f * (box.height - high)), wide, high};
  const Box name{box.x + in, failed ? box.y + ui.layout.size(4) : box.y,
                 failed ? room : room - wide - in, failed ? high : box.height};
  const bool aside = work_.shop().verdict(take).state == study::TakeState::left_out;
  draw_line(shown || failed ? ui.look.fonts.bold : ui.look.fonts.text, name,
            aside ? palette.quiet : palette.text, names()[take]);
  draw_chip(ui, chip_box, chip);
}

void TakesList::move_by_key(const Ui& ui) {
  if (!ui.focus.on_kind("take") || work_.listed().empty()) return;
  const int by =
      (key_pressed(ImGuiKey_DownArrow) ? 1 : 0) - (key_pressed(ImGuiKey_UpArrow) ? 1 : 0);
  const std::size_t now = *work_.take();
  if (by != 0) {
    work_.step(by);
    ui.focus.go_on("take", work_.shop().label(*work_.take()));
  } else if (key_pressed(ImGuiKey_Delete, false)) {
    work_.shop().forget(now);
  }
}

void TakesList::draw_folders(const Ui& ui, const study::Texts& words, const Box& box) {
  Column column(ui, inside(ui, box, 20));
  draw_text(ui.look.fonts.title, column.take(36), ui.look.palette.text,
            words("takes.browse_title"));
  draw_line(ui.look.fonts.text, column.take(26), ui.look.palette.quiet, files_.folder());
  Box left = column.left();
  const float foot = ui.layout.size(48);
  const Box list{left.x, left.y, left.width, left.height - foot - ui.layout.size(12)};
  fill(list, ui.look.palette.on_colour);
  if (const auto file = files_.draw(ui, "browse", list)) work_.add({*file});
  const float wide = ui.layout.size(240);
  const Box all{left.x, left.bottom() - foot, wide, foot};
  if (button(ui, "add_folder", all, words("takes.add_folder"), ButtonKind::filled)) {
    work_.add({files_.folder()});
    browsing_ = false;
  }
  const Box back{all.right() + ui.layout.size(12), all.y, ui.layout.size(140), foot};
  if (button(ui, "browse_end", back, words("takes.browse_end"), ButtonKind::outlined)) {
    browsing_ = false;
  }
}

}  // namespace promenade::app
