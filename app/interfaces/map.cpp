// The minimap ([N] 5.4): the examples are dots of a plane, and every point of it is a walk.
// app/minimap.h holds the state; here it is drawn and reports what is done to it.
#include <algorithm>
#include <bitset>
#include <cmath>
#include <numbers>

#include "app/minimap.h"
#include "app/name_tags.h"
#include "app/registry.h"
#include "app/shelf_view.h"
#include "study/map_options.h"

namespace promenade::app {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2f;
using motion::MapHeuristic;
using study::ControlInput;
using study::InterfacePanel;
using study::InterfaceState;

constexpr float reach_720 = 12;  // a press this near to a dot is meant for it
constexpr float dot_720 = 14;    // diameters
constexpr float current_720 = 20;
constexpr float mark_720 = 22;  // of a bookmark

constexpr std::array switch_order = {MapHeuristic::zero, MapHeuristic::closest,
                                     MapHeuristic::weights, MapHeuristic::random};
constexpr std::array switch_texts = {"interface.map.zero", "interface.map.closest",
                                     "interface.map.weights", "interface.map.random"};

// Where the plane lies on screen.
struct Chart {
  Box box;
  Vector2f zero;  // the pixel of (0, 0)
  float unit;     // pixels of 1, to the right and up

  Vector2f pixel(const Vector2d& point) const {
    return {zero.x() + unit * static_cast<float>(point.x()),
            zero.y() - unit * static_cast<float>(point.y())};
  }
  Vector2d point(const Vector2f& pixel) const {
    return {(pixel.x() - zero.x()) / unit, (zero.y() - pixel.y()) / unit};
  }
  bool holds(const Vector2f& pixel) const { return box.holds(pixel.x(), pixel.y()); }
};

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

ImVec2 im(const Vector2f& at) { return {at.x(), at.y()}; }

void disc(const Vector2f& at, float diameter, const Rgb& colour) {
  ImGui::GetWindowDrawList()->AddCircleFilled(im(at), 0.5f * diameter, packed(colour), 32);
}

// The item within `reach` pixels of a place; of several the nearest, bookmarks first.
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
    const std::string& name = panel.content().names[static_cast<std::size_t>(i)];
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

void draw_whole_button(const MinimapState& state, const Chart& chart, InterfacePanel& panel) {
  if (state.sight().zoom <= 1) return;
  const float inset = panel.size(4);
  const Box box{chart.box.right() - panel.size(112) - inset, chart.box.y + inset, panel.size(112),
                panel.size(32)};
  fill(box, panel.look().palette.panel);
  frame(box, panel.look().palette.line, panel.size(1));
  panel.press("whole", "map", box, panel.text("interface.map.whole"));
}

void draw_switch(const MinimapState& state, InterfacePanel& panel, const Box& row) {
  const Palette& palette = panel.look().palette;
  Box part{row.x, row.y, std::floor(row.width / 4), row.height};
  for (std::size_t k = 0; k < switch_order.size(); ++k) {
    if (state.heuristic() == switch_order[k]) {
      fill({part.x, part.bottom() - panel.size(3), part.width, panel.size(3)}, palette.current);
    }
    panel.press("heuristic", study::name_of(switch_order[k]), part, panel.text(switch_texts[k]));
    part.x += part.width;
  }
}

void report_point(const MinimapState& state, InterfacePanel& panel, const Vector2d& wanted,
                  bool dragged) {
  const double half = state.model().half;
  const Vector2d point = wanted.cwiseMax(-half).cwiseMin(half);
  panel.report({.kind = "point",
                .target = "map",
                .value = dragged ? 1.0 : 0.0,
                .x = point.x(),
                .y = point.y()});
}

void report_sight(InterfacePanel& panel, const MapSight& sight, bool zooms) {
  panel.report({.kind = zooms ? "zoom" : "pan",
                .target = "map",
                .value = zooms ? sight.zoom : study::no_value,
                .x = sight.centre.x(),
                .y = sight.centre.y()});
}

// `about` stays where it is on screen.
void zoom_by(const MinimapState& state, InterfacePanel& panel, double notches,
             const Vector2d& about) {
  MapSight sight = state.sight();
  const double zoom = std::clamp(sight.zoom * std::pow(1.25, notches), 1.0, closest_zoom);
  if (zoom == sight.zoom) return;
  sight.centre = about + (sight.centre - about) * (sight.zoom / zoom);
  sight.zoom = zoom;
  report_sight(panel, sight, true);
}

// A dot has the press when it is near; whoever drags on from there scrubs.
void use_mouse(const MinimapState& state, InterfacePanel& panel, const Chart& chart,
               const PlaneTouch& touch) {
  const ImGuiIO& io = ImGui::GetIO();
  const Vector2f mouse(io.MousePos.x, io.MousePos.y);
  const bool moved = io.MouseDelta.x != 0 || io.MouseDelta.y != 0;
  if (touch.pressed) {
    const Item item = item_at(state, chart, mouse, panel.size(reach_720));
    if (item.empty()) return report_point(state, panel, chart.point(mouse), false);
    return report_press(state.shelf(), item, "go", panel);
  }
  const bool from_dot = !state.shelf().current().empty();
  if (touch.held && moved && (!from_dot || ImGui::IsMouseDragging(0, panel.size(4)))) {
    return report_point(state, panel, chart.point(mouse), true);
  }
  if (touch.wheel != 0) return zoom_by(state, panel, touch.wheel, chart.point(mouse));
  if (touch.pan && moved && state.sight().zoom > 1) {
    MapSight sight = state.sight();
    sight.centre -= Vector2d(touch.moved.x(), -touch.moved.y()) / chart.unit;
    report_sight(panel, sight, false);
  }
}

void move_by_key(const MinimapState& state, InterfacePanel& panel, const Chart& chart,
                 const Vector2d& direction) {
  const double step = ImGui::GetIO().KeyShift ? 0.004 : 0.02;
  const Vector2d wanted =
      state.point() + direction * step * 2 * state.model().half / state.sight().zoom;
  report_point(state, panel, wanted, true);
  if (chart.holds(chart.pixel(wanted))) return;
  report_sight(panel, {state.sight().zoom, wanted}, false);
}

void use_keys(const MinimapState& state, InterfacePanel& panel, const Chart& chart) {
  if (ImGui::GetIO().WantTextInput) return;
  if (key_pressed(ImGuiKey_LeftArrow)) return move_by_key(state, panel, chart, {-1, 0});
  if (key_pressed(ImGuiKey_RightArrow)) return move_by_key(state, panel, chart, {1, 0});
  if (key_pressed(ImGuiKey_UpArrow)) return move_by_key(state, panel, chart, {0, 1});
  if (key_pressed(ImGuiKey_DownArrow)) return move_by_key(state, panel, chart, {0, -1});
  if (key_pressed(ImGuiKey_PageUp)) return zoom_by(state, panel, 1, state.point());
  if (key_pressed(ImGuiKey_PageDown)) return zoom_by(state, panel, -1, state.point());
  if (key_pressed(ImGuiKey_Enter, false) || key_pressed(ImGuiKey_Space, false)) {
    const Item item = item_at(state, chart, chart.pixel(state.point()), INFINITY);
    report_press(state.shelf(), item, "go", panel);
  }
}

// The dots can be found by name, and the Tab key passes them by: the arrow keys go there.
void place_dots(const MinimapState& state, const InterfacePanel& panel, const Chart& chart) {
  if (panel.ui().inert) return;
  const float size = panel.size(28);
  for (int i = 0; i < state.map().size(); ++i) {
    const Vector2f at = chart.pixel(state.map().examples.col(i));
    if (!chart.holds(at)) continue;
    place(panel.ui(), "go", state.shelf().target_of({.example = i}),
          {at.x() - 0.5f * size, at.y() - 0.5f * size, size, size}, false);
  }
}

Item hovered_item(const MinimapState& state, const InterfacePanel& panel, const Chart& chart) {
  const Vector2f mouse(ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y);
  if (panel.ui().inert || !chart.holds(mouse) || ImGui::IsMouseDown(0)) return {};
  return item_at(state, chart, mouse, panel.size(reach_720));
}

void draw_plane(const MinimapState& state, InterfacePanel& panel, const Box& box) {
  const Chart chart = chart_of(state, box);
  const Item hovered = hovered_item(state, panel, chart);
  ImGui::PushClipRect({box.x, box.y}, {box.right(), box.bottom()}, true);
  fill(box, panel.look().palette.on_colour);
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
  frame(box, panel.look().palette.line, panel.size(1));
  draw_whole_button(state, chart, panel);
  // Last, so that what lies on the plane has its presses.
  const PlaneTouch touch =
      plane(panel.ui(), "point", "map", box, chart.zero, {chart.unit, chart.unit});
  place_dots(state, panel, chart);
  ImGui::PopClipRect();
  use_mouse(state, panel, chart, touch);
  if (touch.focused) use_keys(state, panel, chart);
}

void draw(const InterfaceState& state, InterfacePanel& panel) {
  const auto& minimap = static_cast<const MinimapState&>(state);
  Box box = upper_part(panel);
  if (minimap.has_switch()) {
    const float height = panel.size(36);
    draw_switch(minimap, panel, {box.x, box.y, box.width, height});
    box.y += height;
    box.height -= height;
  }
  draw_plane(minimap, panel, box);
  draw_shelf(minimap.shelf(), panel);
}

// A few dots, a place near the current point, one anywhere that is known.
std::vector<ControlInput> simulate(const InterfaceState& state, study::Rng& rng) {
  const auto& minimap = static_cast<const MinimapState&>(state);
  std::vector<ControlInput> ideas;
  const auto propose_point = [&](const Vector2d& wanted) {
    const double half = minimap.model().half;
    const Vector2d at = wanted.cwiseMax(-half).cwiseMin(half);
    ideas.push_back({.kind = "point", .target = "map", .value = 0, .x = at.x(), .y = at.y()});
  };
  for (int k = 0; k < 2; ++k) {
    const auto i = static_cast<int>(rng.below(static_cast<std::uint64_t>(minimap.map().size())));
    if (minimap.shelf().current().example == i) continue;
    ideas.push_back(
        {.kind = "go", .target = std::string(minimap.shelf().target_of({.example = i}))});
  }
  const Vector2d& radii = minimap.model().radii;
  for (int k = 0; k < 2; ++k) {
    propose_point(minimap.point() +
                  0.15 * radii.cwiseProduct(Vector2d(rng.normal(), rng.normal())));
  }
  const double away = std::sqrt(rng.uniform());
  const double angle = 2 * std::numbers::pi * rng.uniform();
  propose_point(away * radii.cwiseProduct(Vector2d(std::cos(angle), std::sin(angle))));
  minimap.shelf().propose(ideas, rng);
  return ideas;
}

const InterfaceEntry entry{{
    .name = "map",
    .sentence =
        "A map on which examples are dots; every point of it is a walk, and dragging scrubs "
        "through them. Bookmarks and mixtures keep and blend what was found.",
    .parameters =
        {{.name = "heuristic",
          .standard = std::string("closest"),
          .choices = {"zero", "closest", "weights", "random"},
          .sentence = "what a point shows beside its two coordinates: nothing more, the details "
                      "of the nearest example, a blend of the nearest examples, or details drawn "
                      "by lot at every press"},
         {.name = "names",
          .standard = std::string("hover"),
          .choices = {"hover", "always"},
          .sentence = "when the names of the examples are to be read"},
         {.name = "metric",
          .standard = std::string("euclidean"),
          .choices = {"euclidean", "mahalanobis"},
          .sentence = "euclidean: distances on the map are those of the motions; mahalanobis: "
                      "each axis in standard deviations of the examples"},
         {.name = "nearest",
          .standard = 5.0,
          .choices = {},
          .sentence = "how many examples the heuristic weights blends"},
         {.name = "components",
          .standard = 0.0,
          .choices = {},
          .sentence = "principal components that are used, 2 or more; 0: 70 % of them"},
         {.name = "glide_s",
          .standard = 0.15,
          .choices = {},
          .sentence = "time constant of the glide of the heuristic closest, seconds; 0: at once"},
         {.name = "switch",
          .standard = false,
          .choices = {},
          .sentence = "true: the participant can change the heuristic, in a row over the map"},
         {.name = "clusters",
          .standard = false,
          .choices = {},
          .sentence = "true: the three primary clusters of the examples are marked softly"}},
    .texts = with_shelf_texts({"interface.map.title", "interface.map.hint", "interface.map.outside",
                               "interface.map.whole", "interface.map.zero", "interface.map.closest",
                               "interface.map.weights", "interface.map.random"}),
    .prepare = prepare_minimap,
    .start =
        [](const study::InterfaceContext& context) {
          return std::make_unique<MinimapState>(context);
        },
    .simulate = simulate,
    .draw = draw,
}};

}  // namespace
}  // namespace promenade::app
