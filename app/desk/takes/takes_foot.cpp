#include "app/desk/takes/takes_foot.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/desk/column.h"

namespace promenade::app {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view recipe_ending = ".recipe.toml";

std::string whole(const std::string& folder) {
  std::error_code error;
  const fs::path path = fs::absolute(folder, error);
  return error ? folder : path.lexically_normal().string();
}

std::string free_file(const std::string& folder) {
  for (int number = 1;; ++number) {
    const std::string name = number == 1 ? "walks" : "walks-" + std::to_string(number);
    const fs::path file = fs::path(folder) / "sets" / (name + ".set");
    std::error_code error;
    const bool there = fs::exists(file, error) || fs::exists(study::recipe_beside(file), error);
    if (!there) return file.string();
  }
}

std::string set_beside(std::string recipe) {
  const std::string_view ending = recipe.ends_with(recipe_ending) ? recipe_ending : ".toml";
  return recipe.replace(recipe.size() - ending.size(), ending.size(), ".set");
}

std::string counted(const study::Texts& words, const char* key, std::size_t count) {
  if (count == 0) return words(std::string(key) + "_none");
  return count == 1 ? words(std::string(key) + "_one")
                    : words.with(std::string(key) + "_many", {{"count", std::to_string(count)}});
}

}  // namespace

TakesFoot::TakesFoot(TakesWork& work, const std::string& folder)
    : work_(work), folder_(whole(folder)) {
  file_.text.set(free_file(folder_));
}

void TakesFoot::follow_recipe() {
  const std::string& recipe = work_.shop().recipe();
  if (recipe == recipe_) return;
  if (recipe_.empty()) {
    own_file_ = file_.text.words();
    own_credit_ = credit_.text.words();
  }
  recipe_ = recipe;
  file_.text.set(recipe.empty() ? own_file_ : set_beside(recipe));
  credit_.text.set(recipe.empty() ? own_credit_ : work_.shop().options().credit);
}

std::string TakesFoot::file() const {
  std::string file = file_.text.words();
  if (file.empty()) return {};
  if (!file.ends_with(".set")) file += ".set";
  return (fs::path(folder_) / file).lexically_normal().string();
}

float TakesFoot::fields_height(const Ui& ui) const {
  return ui.layout.size(24 + 38 + 24 + 38 + 22);
}

void TakesFoot::draw_fields(const Ui& ui, const study::Texts& words, const Box& box,
                            std::int64_t now_us) {
  Column column(ui, inside(ui, box, 8));
  const Palette& palette = ui.look.palette;
  draw_line(ui.look.fonts.text, column.take(22, 2), palette.quiet, words("takes.credit"));
  text_box(ui, "credit", column.take(36, 4), credit_,
           {.most = 300, .several = false, .hint = words("takes.credit_hint").c_str()}, now_us);
  std::error_code error;
  const bool there = fs::exists(file(), error) && work_.made().file != file();
  draw_line(ui.look.fonts.text, column.take(22, 2), there ? palette.alarm : palette.quiet,
            words(there ? "takes.file_there" : "takes.file"));
  text_box(ui, "file", column.take(36, 0), file_, {.most = 500, .several = false}, now_us);
}

void TakesFoot::draw(const Ui& ui, const study::Texts& words, const Box& box) {
  const Palette& palette = ui.look.palette;
  fill(box, palette.panel);
  const float in = ui.layout.size(12);
  const float wide = ui.layout.size(160), icon = ui.layout.size(44);
  const Box press{box.right() - in - wide, box.y + in / 2, wide, box.height - in};
  study::Workshop& shop = work_.shop();
  const Box redo{press.x - in - icon, std::round(box.middle_y() - icon / 2), icon, icon};
  const Box undo{redo.x - icon, redo.y, icon, icon};
  if (icon_button(ui, "undo", "takes", undo, Icon::undo, shop.can_undo())) shop.undo();
  if (icon_button(ui, "redo", "takes", redo, Icon::redo, shop.can_redo())) shop.redo();
  const Box left{box.x + ui.layout.size(16), box.y, undo.x - box.x - ui.layout.size(28),
                 box.height};
  if (work_.made().working) {
    draw_progress(ui, words, left);
    if (button(ui, "stop", press, words("takes.stop"), ButtonKind::outlined)) work_.stop_making();
    return;
  }
  draw_state(ui, words, left);
  const bool ready = !shop.walks().empty() && work_.to_read() == 0 && !file().empty();
  if (button(ui, "make", press, words("takes.make"), ButtonKind::filled, ready)) make();
}

void TakesFoot::draw_progress(const Ui& ui, const study::Texts& words, const Box& box) {
  const Palette& palette = ui.look.palette;
  const float half = std::round(box.height / 2);
  draw_line(ui.look.fonts.text, {box.x, box.y + ui.layout.size(4), box.width, half}, palette.text,
            words.with("takes.making", {{"file", work_.made().file}}));
  const Box bar{box.x, box.y + half + ui.layout.size(6), box.width, ui.layout.size(10)};
  fill(bar, palette.track);
  fill({bar.x, bar.y, std::round(static_cast<float>(work_.made().share) * bar.width), bar.height},
       palette.created);
}

// "28 walks, one skeleton, 2 takes refused", and below it what became of the set.
void TakesFoot::draw_state(const Ui& ui, const study::Texts& words, const Box& box) const {
  const study::Workshop& shop = work_.shop();
  const MadeSet& made = work_.made();
  const Palette& palette = ui.look.palette;
  std::string text = words("takes.none_yet");
  if (const std::size_t left = work_.to_read(); left > 0) {
    text = counted(words, "takes.reading", left);
  } else if (!shop.takes().empty()) {
    text =
        words.with("takes.state", {{"walks", counted(words, "takes.walks", shop.walks().size())},
                                   {"refused", counted(words, "takes.refused", shop.refused())}});
  }
  std::string below;
  Rgb ink = palette.quiet;
  if (made.done() && work_.changed_since_made()) {
    below = words.with("takes.changed", {{"file", made.file}});
  } else if (made.done()) {
    below = words.with("takes.made", {{"file", made.file}});
    ink = palette.bookmark;
  } else if (made.stopped) {
    below = words("takes.stopped");
  } else if (!made.trouble.empty()) {
    below = words.with("takes.not_made", {{"reason", made.trouble}});
    ink = palette.alarm;
  }
  const float high = below.empty() ? box.height : std::round(box.height / 2);
  draw_line(ui.look.fonts.bold, {box.x, box.y, box.width, high}, palette.text, text);
  if (below.empty()) return;
  draw_line(ui.look.fonts.text, {box.x, box.y + high - ui.layout.size(4), box.width, high}, ink,
            below);
}

void TakesFoot::describe(const std::string& set) {
  work_.shop().describe(fs::path(set).stem().string(), credit_.text.words());
}

void TakesFoot::make() {
  const std::string set = file();
  describe(set);
  work_.make(set);
}

void TakesFoot::save() {
  const std::string set = file().empty() ? free_file(folder_) : file();
  describe(set);
  work_.save(set);
}

}  // namespace promenade::app
