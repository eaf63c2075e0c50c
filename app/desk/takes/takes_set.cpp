#include "app/desk/takes/takes_set.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/scroll_area.h"
#include "app/small_figures.h"

namespace promenade::app {
namespace {

constexpr float tile_size = 100, name_height = 28, gap_size = 4;  // at 1280 x 720

// Words that make a target of a walk.
std::string target_of(const study::Workshop& shop, const study::WalkPlace& walk) {
  return shop.label(walk.take) + "/" + std::to_string(walk.cycle);
}

}  // namespace

TakesSet::Key TakesSet::key_of(const study::WalkPlace& walk) const {
  return {work_.shop().takes()[walk.take].source.file, walk.cycle};
}

const std::string& TakesSet::name_of(const study::WalkPlace& walk) const {
  const motion::TakeSource& source = work_.shop().takes()[walk.take].source;
  const std::string& name = source.cycles[walk.cycle].name;
  return name.empty() ? source.style : name;
}

const LoopFigure* TakesSet::figure_of(const study::WalkPlace& walk) {
  const auto loop = work_.loop(walk);
  if (!loop) return nullptr;
  std::unique_ptr<LoopFigure>& figure = figures_[key_of(walk)];
  if (!figure || &figure->loop() != loop.get()) figure = std::make_unique<LoopFigure>(loop);
  return figure.get();
}

void TakesSet::draw_figures(FigureRenderer& renderer, const Gui& gui) {
  const Palette& palette = gui.look().palette;
  if (area_.width > 0) renderer.fill(area_, palette.panel);
  for (const Shown& one : shown_) {
    renderer.fill(one.clip, palette.on_colour);
    if (one.figure == nullptr) continue;
    one.figure->parts(work_.clock_s() + one.late_s, start_yaw, parts_);
    draw_small_figure(renderer, one.box, one.clip, one.figure->height(), parts_, palette.created,
                      palette.track);
  }
}

void TakesSet::draw(const Ui& ui, const study::Texts& words, const Box& box) {
  area_ = box;
  shown_.clear();
  removed_.reset();
  const float in = ui.layout.size(4), head = ui.layout.size(34);
  const std::vector<study::WalkPlace> walks = work_.shop().walks();
  draw_text(ui.look.fonts.bold, {box.x + 2 * in, box.y, box.width - 4 * in, head},
            ui.look.palette.text, words("takes.the_set"));
  if (refused_name_) {
    draw_text(ui.look.fonts.text, {box.x + 2 * in, box.y, box.width - 4 * in, head},
              ui.look.palette.alarm, words("takes.name_taken"), Align::right);
  }
  const Box area{box.x + in, box.y + head, box.width - 2 * in, box.height - head - in};
  if (walks.empty()) {
    draw_paragraphs(ui.look.fonts.text, area.x + in, area.y, area.width - 2 * in,
                    ui.look.palette.quiet, words("takes.set_empty"));
    return;
  }
  const float gap = ui.layout.size(gap_size);
  const float room = area.width - ImGui::GetStyle().ScrollbarSize + gap;
  const float columns_wide = std::max(1.0f, std::round(room / (ui.layout.size(tile_size) + gap)));
  const float tile = std::floor(room / columns_wide) - gap;
  const float high = tile + ui.layout.size(name_height) + gap;
  const auto columns = static_cast<std::size_t>(columns_wide);
  const std::size_t rows = (walks.size() + columns - 1) / columns;
  scrolled("set", area, static_cast<float>(rows) * high, [&](const Box& all) {
    for (std::size_t k = 0; k < walks.size(); ++k) {
      const std::size_t at_row = k / columns;
      const auto column = static_cast<float>(k % columns), row = static_cast<float>(at_row);
      draw_tile(ui, walks[k],
                {all.x + column * (tile + gap), all.y + row * high, tile, high - gap});
    }
  });
  if (removed_) work_.shop().remove(*removed_);
}

void TakesSet::draw_tile(const Ui& ui, const study::WalkPlace& walk, const Box& cell) {
  const Palette& palette = ui.look.palette;
  const std::string target = target_of(work_.shop(), walk);
  const Box picture{cell.x, cell.y, cell.width, cell.width};
  const Box cross{picture.right() - ui.layout.size(26), picture.y, ui.layout.size(26),
                  ui.layout.size(26)};
  // Before the tile, which lies below it.
  if (pressed_area(ui, "remove", target, cross, false)) removed_ = walk;
  const bool entered =
      ui.focus.on("tile", target) && !writing() && key_pressed(ImGuiKey_Enter, false);
  if (tile(ui, "tile", target, picture)) work_.look_at(walk.take, walk.cycle);
  if (entered) begin_renaming(ui, walk);
  if (ui.focus.on("tile", target) && key_pressed(ImGuiKey_Delete, false)) removed_ = walk;
  draw_name(ui, walk, {cell.x, picture.bottom(), cell.width, ui.layout.size(name_height)});
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const float sign = ui.layout.size(12);
  draw_icon({cross.middle_x() - sign / 2, cross.middle_y() - sign / 2, sign, sign}, Icon::close,
            cross.holds(mouse.x, mouse.y) ? palette.text : palette.example, ui.layout.size(2));
  if (work_.walk() == walk) frame(picture, palette.created, ui.layout.size(3));
  const Box clip = common_box(picture, visible_box());
  if (clip.width < 1 || clip.height < 1) return;
  const auto number = static_cast<double>(shown_.size());
  shown_.push_back({picture, clip, figure_of(walk), 0.37 * number});
}

void TakesSet::draw_name(const Ui& ui, const study::WalkPlace& walk, const Box& box) {
  const bool mine = renamed_ == key_of(walk);
  if (!mine && pressed_area(ui, "rename", target_of(work_.shop(), walk), box, false)) {
    begin_renaming(ui, walk);
  }
  if (renamed_ != key_of(walk)) {
    return draw_line(ui.look.fonts.text, box, ui.look.palette.text, name_of(walk), Align::centre);
  }
  bool entered = false;
  text_field(ui, "write", "name", box, written_, {.entered = &entered});
  const bool here = ui.focus.on("write", "name");
  if (key_pressed(ImGuiKey_Escape, false)) {
    ui.focus.use_escape();
    end_renaming(ui, false);
  } else if (entered || (was_written_ && !here)) {
    end_renaming(ui, true);
  }
  was_written_ = here;
}

void TakesSet::begin_renaming(const Ui& ui, const study::WalkPlace& walk) {
  renamed_ = key_of(walk);
  written_ = name_of(walk);
  was_written_ = refused_name_ = false;
  work_.look_at(walk.take, walk.cycle);
  ui.focus.write_in("write", "name");
}

// The keyboard goes back to the tile, unless it went elsewhere by itself.
void TakesSet::end_renaming(const Ui& ui, bool keep) {
  const Key key = *std::exchange(renamed_, std::nullopt);
  for (const study::WalkPlace& walk : work_.shop().walks()) {
    if (key_of(walk) != key) continue;
    if (ui.focus.on("write", "name")) ui.focus.go_on("tile", target_of(work_.shop(), walk));
    refused_name_ = keep && !work_.shop().rename(walk, written_);
    return;
  }
}

}  // namespace promenade::app
