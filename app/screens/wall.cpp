// All examples walking beside the task, as the video in [O] 6 did: small figures in rows,
// each over its name, as large as they can be.
#include <algorithm>
#include <cmath>

#include "app/screens/screen.h"

namespace promenade::app {
namespace {

struct Grid {
  int columns = 1, rows = 1;
  float width = 0, height = 0;  // of a tile, pixels
};

// The grid in which a figure, `aspect` times as high as its tile is wide, is largest.
Grid best_grid(int count, const Box& box, float caption) {
  constexpr float aspect = 1.5f;
  Grid best;
  float size = 0;
  for (int columns = 1; columns <= count; ++columns) {
    const int rows = (count + columns - 1) / columns;
    const float width = std::floor(box.width / static_cast<float>(columns));
    const float height = std::floor(box.height / static_cast<float>(rows));
    const float fits = std::min(aspect * width, height - caption);
    if (fits <= size) continue;
    size = fits;
    best = {columns, rows, width, height};
  }
  return best;
}

}  // namespace

void draw_wall(const Screen& screen) {
  const Ui& ui = screen.ui;
  const Box& box = screen.stage_plan.wall;
  fill({box.x, box.y, box.width, ui.layout.size(1)}, ui.look.palette.line);
  draw_examples(ui, box, screen.content, screen.stage.small_figures(), screen.memory.example);
}

void draw_examples(const Ui& ui, const Box& box, const study::InterfacePanel::Content& content,
                   SmallFigures& figures, Eigen::VectorXd& weights) {
  const int count = content.space.set.size();
  const float caption = ui.layout.size(22);
  // Names that would be cut are worse than none; then the one under the mouse is shown.
  Grid grid = best_grid(count, box, caption);
  const bool named = grid.width >= ui.layout.size(72);
  if (!named) grid = best_grid(count, box, 0);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  for (int k = 0; k < count; ++k) {
    const int cycle = content.captions.by_name[static_cast<std::size_t>(k)];
    const Box tile{box.x + grid.width * static_cast<float>(k % grid.columns),
                   box.y + grid.height * static_cast<float>(k / grid.columns), grid.width,
                   grid.height};
    const float below = named ? caption : 0;
    weights.setZero(count);
    weights(cycle) = 1;
    figures.ask({tile.x, tile.y, tile.width, tile.height - below}, box, weights,
                ui.look.palette.example);
    const std::string& name = content.captions.names[static_cast<std::size_t>(cycle)];
    const bool over = tile.holds(mouse.x, mouse.y);
    if (!named && !over) continue;
    const float room =
        named ? tile.width - ui.layout.size(8) : text_width(ui.look.fonts.text, name);
    const float x = std::clamp(tile.middle_x() - 0.5f * room, box.x, box.right() - room);
    const Box label{x, tile.bottom() - caption, room, caption};
    if (!named) fill(label, ui.look.palette.background);
    draw_line(ui.look.fonts.text, label, ui.look.palette.text, name, Align::centre);
  }
}

}  // namespace promenade::app
