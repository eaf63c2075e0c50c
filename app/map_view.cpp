#include "app/map_view.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <numbers>

#include "app/name_tags.h"
#include "app/shelf_view.h"

namespace promenade::app {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2f;
using motion::MapHeuristic;
using study::InterfacePanel;

constexpr float dot_720 = 14;  // diameters
constexpr float current_720 = 20;
constexpr float mark_720 = 22;  // of a bookmark

ImVec2 im(const Vector2f& at) { return {at.x(), at.y()}; }

void disc(const Vector2f& at, float diameter, const Rgb& colour) {
  ImGui::GetWindowDrawList()->AddCircleFilled(im(at), 0.5f * diameter, packed(colour), 32);
}

// The valid points: what the examples cover.
void draw_known(const MinimapState& state, const Chart& chart, const Palette& palette) {
  if (state.heuristic() == MapHeuristic::weights) return fill(chart.box, palette.known);
  constexpr int corners = 96;
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    list->PathLineTo(im(
        chart.pixel(state.model().radii.cwiseProduct(Vector2d(std::cos(angle), std::sin(angle))))));
  }
  list->PathFillConvex(packed(palette.known));
}

// The corners of a convex polygon, pushed out by `radius` and rounded.
void path_around(const MinimapState& state, const Chart& chart, const std::vector<int>& hull,
                 float radius) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const auto at = [&](std::size_t k) {
    return chart.pixel(state.map().examples.col(hull[k % hull.size()]));
  };
  // Of the side that leaves corner k: where its outside lies, as an angle on screen.
  const auto outside = [&](std::size_t k) {
    const Vector2f along = at(k + 1) - at(k);
    return std::atan2(along.x(), -along.y());
  };
  constexpr float turn = 2 * std::numbers::pi_v<float>;
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const float from = hull.size() == 1 ? 0 : outside(k + hull.size() - 1);
    float to = hull.size() == 1 ? -turn : outside(k);
    while (to > from) to -= turn;
    list->PathArcTo(im(at(k)), radius, from, to, 16);
  }
}

void draw_clusters(const MinimapState& state, const Chart& chart, InterfacePanel& panel) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (std::size_t c = 0; c < state.model().clusters.size(); ++c) {
    const Rgb& colour = panel.look().palette.clusters[c];
    const std::vector<int>& hull = state.model().clusters[c];
    path_around(state, chart, hull, panel.size(16));
    list->PathFillConvex(packed(colour, 0.22f));
    path_around(state, chart, hull, panel.size(16));
    list->PathStroke(packed(colour, 0.9f), ImDrawFlags_Closed, panel.size(1));
  }
}

void draw_dots(const MinimapState& state, const Chart& chart, InterfacePanel& panel,
               const Item& hovered) {
  const Palette& palette = panel.look().palette;
  const Eigen::Matrix2Xd& examples = state.map().examples;
  for (int i = 0; i < examples.cols(); ++i) {
    const Vector2f at = chart.pixel(examples.col(i));
    if (hovered.example == i) disc(at, panel.size(dot_720 + 6), palette.line);
    disc(at, panel.size(dot_720), palette.example);
  }
}

void draw_marks(const MinimapState& state, const Chart& chart, InterfacePanel& panel,
                const Item& hovered) {
  const Palette& palette = panel.look().palette;
  for (const Bookmark& bookmark : state.shelf().bookmarks()) {
    const Vector2f at = chart.pixel(bookmark.spot.point);
    const bool is_current = state.shelf().current().bookmark == bookmark.number;
    if (is_current || hovered.bookmark == bookmark.number) {
      disc(at, panel.size(mark_720 + 8), is_current ? palette.current : palette.line);
      disc(at, panel.size(mark_720 + 3), palette.on_colour);
    }
    disc(at, panel.size(mark_720), palette.bookmark);
    const float half = panel.size(16);
    draw_text(panel.look().fonts.bold, {at.x() - half, at.y() - half, 2 * half, 2 * half},
              palette.on_colour, digit_of(bookmark), Align::centre);
  }
}

void draw_current(const MinimapState& state, const Chart& chart, InterfacePanel& panel) {
  if (state.shelf().current().bookmark > 0) return;  // it has a frame
  const Vector2f at = chart.pixel(state.point());
  disc(at, panel.size(current_720 + 3), panel.look().palette.on_colour);
  disc(at, panel.size(current_720), panel.look().palette.current);
}

Vector2f tag_size(const InterfacePanel& panel, std::string_view name) {
  ImFont* font = panel.look().fonts.text;
  const float width = std::min(text_width(font, name), panel.size(200));
  return {width + panel.size(6), font->FontSize + panel.size(2)};
}

void draw_tag(InterfacePanel& panel, const Box& box, std::string_view name) {
  const float inset = panel.size(3);
  panel.line(panel.look().fonts.text, {box.x + inset, box.y, box.width - 2 * inset, box.height},
             panel.look().palette.text, name);
}

// Room for names, off all that lies on the map.
NameTags tags_of(const MinimapState& state, const Chart& chart, const InterfacePanel& panel) {
  NameTags tags(chart.box);
  const auto keep_free = [&](const Vector2d& point, float size) {
    const Vector2f at = chart.pixel(point);
    tags.keep_free({at.x() - 0.5f * size, at.y() - 0.5f * size, size, size});
  };
  for (const auto& dot : state.map().examples.colwise()) keep_free(dot, panel.size(dot_720 - 2));
  keep_free(state.point(), panel.size(current_720));
  for (const Bookmark& bookmark : state.shelf().bookmarks()) {
    keep_free(bookmark.spot.point, panel.size(mark_720));
  }
  return tags;
}

using Named = std::bitset<512>;  // of the examples

// Names where there is room for them; whose name is to be read then?
Named draw_all_names(const MinimapState& state, const Chart& chart, InterfacePanel& panel) {
  NameTags tags = tags_of(state, chart, panel);
  Named named;
  const Eigen::Matrix2Xd& examples = state.map().examples;
  for (int i = 0; i < examples.cols(); ++i) {
    const std::string& name = panel.content().captions.names[static_cast<std::size_t>(i)];
    const Vector2f at = chart.pixel(examples.col(i));
    if (!chart.holds(at)) continue;
    const auto box = tags.place(at, panel.size(0.5f * dot_720 + 1), tag_size(panel, name));
    if (!box) continue;
    draw_tag(panel, *box, name);
    if (i < static_cast<int>(named.size())) named.set(static_cast<std::size_t>(i));
  }
  return named;
}

// The name of one item, on top of everything.
void draw_name(const MinimapState& state, const Chart& chart, InterfacePanel& panel,
               const Item& item) {
  if (item.empty()) return;
  const Bookmark* bookmark = state.shelf().find_bookmark(item.bookmark);
  const Vector2d point =
      bookmark != nullptr ? bookmark->spot.point : Vector2d(state.map().examples.col(item.example));
  const Vector2f at = chart.pixel(point);
  if (!chart.holds(at)) return;
  const ShortLine name = name_of(state.shelf(), item, panel);
  const Vector2f size = tag_size(panel, name.text());
  NameTags tags = tags_of(state, chart, panel);
  const float radius = panel.size(15);
  const Box anyway = tags.place_anyway(at, radius, size);
  const Box box = tags.place(at, radius, size).value_or(anyway);
  fill(box, panel.look().palette.on_colour);
  draw_tag(panel, box, name.text());
}

// The map's own line: why the point is not where it was asked for.
void draw_note(const MinimapState& state, const Chart& chart, InterfacePanel& panel) {
  if (!state.pulled_back()) return;
  const float height = panel.size(28);
  const Box box{chart.box.x, chart.box.bottom() - height, chart.box.width, height};
  fill(box, panel.look().palette.panel);
  panel.line(panel.look().fonts.text, box, panel.look().palette.quiet,
             panel.text("interface.map.outside"), Align::centre);
}

}  // namespace

Chart chart_of(const MinimapState& state, const Box& box) {
  const MapSight& sight = state.sight();
  const double side = std::min(box.width, box.height);
  const double unit = side * sight.zoom / (2 * state.model().half);
  const Vector2d centre = unit * sight.centre;
  return {box,
          {box.middle_x() - static_cast<float>(centre.x()),
           box.middle_y() + static_cast<float>(centre.y())},
          static_cast<float>(unit)};
}

Item item_at(const MinimapState& state, const Chart& chart, const Vector2f& at, float reach) {
  Item nearest;
  float least = reach;
  const auto consider = [&](const Vector2d& point, const Item& item) {
    const float away = (chart.pixel(point) - at).norm();
    if (away > least || (away == least && !nearest.empty())) return;
    least = away;
    nearest = item;
  };
  for (const Bookmark& bookmark : state.shelf().bookmarks()) {
    consider(bookmark.spot.point, {.bookmark = bookmark.number});
  }
  const Eigen::Matrix2Xd& examples = state.map().examples;
  for (int i = 0; i < examples.cols(); ++i) consider(examples.col(i), {.example = i});
  return nearest;
}

void draw_chart(const MinimapState& state, const Chart& chart, InterfacePanel& panel,
                const Item& hovered) {
  fill(chart.box, panel.look().palette.on_colour);
  draw_known(state, chart, panel.look().palette);
  if (state.shows_clusters()) draw_clusters(state, chart, panel);
  draw_dots(state, chart, panel, hovered);
  const Named named = state.names_always() ? draw_all_names(state, chart, panel) : Named();
  const auto name_once = [&](const Item& item) {
    const auto example = static_cast<std::size_t>(std::max(0, item.example));
    const bool is_named = item.example >= 0 && example < named.size() && named[example];
    if (!is_named) draw_name(state, chart, panel, item);
  };
  draw_current(state, chart, panel);
  draw_marks(state, chart, panel, hovered);
  name_once({.example = state.shelf().current().example});
  name_once(hovered);
  draw_note(state, chart, panel);
  frame(chart.box, panel.look().palette.line, panel.size(1));
}

}  // namespace promenade::app
