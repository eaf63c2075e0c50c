// The minimap ([N] 5.4): the examples are dots of a plane, and every point of it is a walk.
// app/minimap.h holds the state, app/map_view.h draws it; here is what is done to it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/map_view.h"
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
constexpr std::array switch_order = {MapHeuristic::zero, MapHeuristic::closest,
                                     MapHeuristic::weights, MapHeuristic::random};
constexpr std::array switch_texts = {"interface.map.zero", "interface.map.closest",
                                     "interface.map.weights", "interface.map.random"};

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
  // Where details are drawn by lot, Enter is the press that draws; Space is for the dots.
  const bool enter = key_pressed(ImGuiKey_Enter, false);
  const bool draws = enter && state.heuristic() == MapHeuristic::random;
  if (draws) return report_point(state, panel, state.point(), false);
  if (enter || key_pressed(ImGuiKey_Space, false)) {
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
  ImGui::PushClipRect({box.x, box.y}, {box.right(), box.bottom()}, true);
  draw_chart(state, chart, panel, hovered_item(state, panel, chart));
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
          .sentence = "how many examples the heuristic weights blends",
          .least = 1,
          .whole = true},
         {.name = "components",
          .standard = 0.0,
          .choices = {},
          .sentence = "principal components that are used, 2 or more; 0: 70 % of them",
          .least = 0,
          .whole = true},
         {.name = "glide_s",
          .standard = 0.15,
          .choices = {},
          .sentence = "time constant of the glide of the heuristic closest, seconds; 0: at once",
          .least = 0,
          .most = 10},
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
    .start = start_as<MinimapState>,
    .simulate = simulate,
    .draw = draw,
}};

}  // namespace
}  // namespace promenade::app
