#include "app/path_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "motion/problem.h"

namespace promenade::app {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2f;

constexpr const char* any_style = "any style";
constexpr const char* title = "Draw a path, and the figure walks it";
constexpr const char* first_words =
    "Press and drag to draw a path, or click corner after corner and end with a double click";
constexpr const char* open_words =
    "A double click or Enter ends the path, Backspace takes the last corner back";

std::string target_of(const std::string& label) { return "label:" + label; }

Vector2f pointer() { return {ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y}; }

std::string describe(const motion::PathWalk& found, double wanted_m, double frame_time) {
  std::string text = fmt::format("{:.1f} m wanted, {:.1f} m walked, {:.2f} m from it (RMS)",
                                 wanted_m, found.walked_m, found.rms_m);
  if (found.other_label > 0) {
    text += fmt::format(", {:.1f} s in other styles", found.other_label * frame_time);
  }
  return found.stopped ? "Stopped: " + text : text;
}

}  // namespace

std::vector<std::string> shown_words(const motion::MotionGraph& graph) {
  std::vector<std::string> words = {title, first_words, open_words, any_style, graph.name};
  for (const motion::GraphTake& take : graph.takes) words.push_back(take.label);
  return words;
}

PathView::PathView(const PathScene& scene, Gui& gui, InputQueue& queue,
                   std::function<void(const motion::Take&)> save)
    : scene_(scene), gui_(gui), page_(queue), save_(std::move(save)), colours_(scene.graph) {
  choices_.emplace_back();
  for (const std::string& label : colours_.labels()) choices_.push_back(label);
}

void PathView::frame() {
  page_.frame(gui_, [this](const Ui& ui) {
    follow();
    draw(ui);
  });
}

// What is wanted is asked for, and what was found is walked.
void PathView::follow() {
  if (scene_.drawing.revision() != revision_) ask();
  const std::shared_ptr<const WalkedPath> news = scene_.worker.news();
  if (news == nullptr) return;
  walked_ = news;
  way_ = {motion::pelvis_way(news->motion->take), news->motion->labels};
  scene_.stage.walk(news->motion, news->result.has_value());
}

void PathView::ask() {
  revision_ = scene_.drawing.revision();
  wanted_ = scene_.drawing.wanted();
  saved_ = {};
  if (wanted_) return scene_.worker.start(*wanted_);
  scene_.worker.forget();
  scene_.stage.wander();
  walked_.reset();
}

void PathView::draw(const Ui& ui) {
  fill(ui.layout.panel(), ui.look.palette.panel);
  draw_head(ui);
  draw_stage(ui);
  draw_plane(ui, ui.layout.box(856, 72, 400, 400));
  const float used = draw_labels(ui, ui.layout.box(856, 484, 400, 66));
  Box state = ui.layout.box(856, 498, 400, 62);
  state.y += used;
  draw_state(ui, state);
  draw_foot(ui);
}

void PathView::draw_head(const Ui& ui) const {
  const Box strip = ui.layout.strip();
  const float inset = ui.layout.size(16);
  const Box line{strip.x + inset, strip.y, strip.width - 2 * inset, strip.height};
  draw_text(ui.look.fonts.title, line, ui.look.palette.text, title);
  draw_line(ui.look.fonts.text, {line.middle_x(), line.y, line.width / 2, line.height},
            ui.look.palette.quiet, scene_.graph.name, Align::right);
}

// The stage is turned by dragging it or by the arrow keys; the style that is seen has a plate.
void PathView::draw_stage(const Ui& ui) {
  const StagePlan plan = ui.layout.stage_plan(false);
  const PlaneTouch touch = plane(ui, "stage", "stage", plan.figures, {0, 0}, {1, 1});
  float& yaw = scene_.stage.orbit().yaw;
  if (touch.held) yaw += 0.008f * touch.moved.x() / ui.layout.scale;
  if (touch.focused && key_pressed(ImGuiKey_LeftArrow)) yaw -= 0.1f;
  if (touch.focused && key_pressed(ImGuiKey_RightArrow)) yaw += 0.1f;
  const std::string& label = scene_.stage.label();
  const float wide = text_width(ui.look.fonts.bold, label) + ui.layout.size(28);
  const Box plate{std::round(plan.figures.middle_x() - wide / 2), plan.plate_y, std::round(wide),
                  ui.layout.size(30)};
  fill(plate, colours_.of(label));
  draw_text(ui.look.fonts.bold, plate, ink_on(ui.look.palette, colours_.of(label)), label,
            Align::centre);
}

// The corners, and where the next one would be.
std::vector<DrawnCorner> PathView::corners_in_sight(const GroundPlan& plan,
                                                    const PlaneTouch& touch) const {
  const PathDrawing& drawing = scene_.drawing;
  std::vector<DrawnCorner> corners = drawing.corners();
  const bool leads_on = drawing.drawing() || (drawing.open() && touch.hovered);
  const Vector2d at = plan.place(plan.within(pointer()));
  if (leads_on && !corners.empty() && (corners.back().at - at).norm() > 0.01) {
    corners.push_back({at, drawing.chosen()});
  }
  return corners;
}

void PathView::draw_picture(const Ui& ui, const GroundPlan& plan, const PlaneTouch& touch) const {
  const PathPicture picture(ui, plan, colours_);
  const Box& box = plan.box;
  fill(box, ui.look.palette.on_colour);
  ImGui::PushClipRect({box.x, box.y}, {box.right(), box.bottom()}, true);
  picture.draw_grid();
  const std::vector<DrawnCorner> corners = corners_in_sight(plan, touch);
  if (wanted_ && corners.size() == scene_.drawing.ended()) {
    picture.draw_wanted(*wanted_);
  } else if (corners.size() > 1) {
    picture.draw_wanted(path_through(corners));
  }
  if (walked_) picture.draw_walked(way_);
  for (const DrawnCorner& corner : scene_.drawing.corners()) {
    const bool alone = scene_.drawing.open() && !scene_.drawing.drawing();
    if (corner.stroke == 0 && alone) picture.draw_corner(corner.at, corner.label);
  }
  picture.draw_camera(scene_.stage.to_camera());
  if (!scene_.stage.wandering()) {
    picture.draw_walker(scene_.stage.place(), scene_.stage.heading());
  }
  if (touch.focused && page_.focus().ring()) picture.draw_cursor(cursor_);
  picture.draw_scale();
  ImGui::PopClipRect();
  app::frame(box, ui.look.palette.line, ui.layout.size(1));
}

void PathView::draw_plane(const Ui& ui, const Box& box) {
  const GroundPlan before{box, sight_};
  const Vector2f zero = before.pixel({0, 0});
  // To the right is -X.
  const PlaneTouch touch = plane(ui, "draw", "path", box, zero, {-before.unit(), before.unit()});
  use_mouse(ui, before, touch);
  if (touch.focused) use_keys(before);
  if (key_pressed(ImGuiKey_Backspace)) take_back();  // nothing else has a use for it
  const GroundPlan plan{box, sight_};
  draw_picture(ui, plan, touch);
  if (!scene_.drawing.corners().empty()) return;
  const float inset = ui.layout.size(60);
  const float wide = box.width - 2 * inset;
  const float high = paragraphs_height(ui.look.fonts.text, wide, first_words);
  const float y = std::round(box.middle_y() - high / 2);
  fill({box.x + inset, y, wide, high}, ui.look.palette.on_colour);
  draw_paragraphs(ui.look.fonts.text, box.x + inset, y, wide, ui.look.palette.quiet, first_words);
}

void PathView::use_mouse(const Ui& ui, const GroundPlan& plan, const PlaneTouch& touch) {
  const Vector2f at = plan.within(pointer());
  if (touch.wheel != 0) sight_ = zoomed(sight_, touch.wheel, plan.place(at));
  if (touch.pan) {
    sight_.centre += (touch.moved / plan.unit()).cast<double>();
  } else if (touch.pressed) {
    press(at);
  } else if (pressed_at_ && touch.held) {
    drag(plan, at, ui.layout.size(4));
  } else if (pressed_at_) {
    release(plan.place(at));
  }
}

void PathView::press(const Vector2f& at) {
  if (!ImGui::IsMouseDoubleClicked(0)) {
    pressed_at_ = at;
  } else {
    scene_.drawing.end();
  }
}

// A hand that trembles while it clicks draws no stroke.
void PathView::drag(const GroundPlan& plan, const Vector2f& at, float least) {
  PathDrawing& drawing = scene_.drawing;
  if (!drawing.drawing()) {
    if ((at - *pressed_at_).norm() < least) return;
    drawing.begin_stroke(plan.place(*pressed_at_));
  }
  drawing.draw_to(plan.place(at));
}

void PathView::release(const Vector2d& at) {
  pressed_at_.reset();
  cursor_ = at;
  if (scene_.drawing.drawing()) return scene_.drawing.end_stroke(at);
  scene_.drawing.add_corner(at);
}

void PathView::use_keys(const GroundPlan& plan) {
  if (pressed_at_) return;
  if (key_pressed(ImGuiKey_LeftArrow)) move_cursor(plan, -1, 0);
  if (key_pressed(ImGuiKey_RightArrow)) move_cursor(plan, 1, 0);
  if (key_pressed(ImGuiKey_UpArrow)) move_cursor(plan, 0, 1);
  if (key_pressed(ImGuiKey_DownArrow)) move_cursor(plan, 0, -1);
  if (key_pressed(ImGuiKey_PageUp)) sight_ = zoomed(sight_, 1, cursor_);
  if (key_pressed(ImGuiKey_PageDown)) sight_ = zoomed(sight_, -1, cursor_);
  if (key_pressed(ImGuiKey_Home)) sight_ = {};
  if (key_pressed(ImGuiKey_Enter, false) || key_pressed(ImGuiKey_Space, false)) set_corner();
}

// By half a metre, with Shift by a tenth; the sight goes along.
void PathView::move_cursor(const GroundPlan& plan, double right, double up) {
  const double step = ImGui::GetIO().KeyShift ? 0.1 : 0.5;
  cursor_ += step * Vector2d(-right, up);
  const Vector2f at = plan.pixel(cursor_);
  sight_.centre += plan.place(at) - plan.place(plan.within(at));
}

// The same place twice: the path ends.
void PathView::set_corner() {
  PathDrawing& drawing = scene_.drawing;
  const bool again =
      !drawing.corners().empty() && (drawing.corners().back().at - cursor_).norm() < 0.01;
  if (!again) return drawing.add_corner(cursor_);
  drawing.end();
}

void PathView::take_back() {
  scene_.drawing.take_back();
  if (!scene_.drawing.corners().empty()) cursor_ = scene_.drawing.corners().back().at;
}

// One beside the other and, where there is no room, below; from (0, 0).
std::vector<Box> PathView::label_boxes(const Ui& ui, float width) const {
  const float high = ui.layout.size(30), gap = ui.layout.size(6);
  std::vector<Box> boxes;
  Box next{0, 0, 0, high};
  for (const std::string& label : choices_) {
    const std::string_view words = label.empty() ? any_style : std::string_view(label);
    next.width = std::round(text_width(ui.look.fonts.bold, words)) + ui.layout.size(26);
    next.width = std::min(next.width, width);
    if (next.x > 0 && next.right() > width) next = {0, next.bottom() + gap, next.width, high};
    boxes.push_back(next);
    next.x = next.right() + gap;
  }
  return boxes;
}

float PathView::draw_labels(const Ui& ui, const Box& box) {
  const std::vector<Box> boxes = label_boxes(ui, box.width - ImGui::GetStyle().ScrollbarSize);
  const float high = std::min(box.height, boxes.back().bottom());
  ImGui::SetCursorScreenPos({box.x, box.y});
  ImGui::BeginChild("labels", {box.width, high}, false, ImGuiWindowFlags_NoBackground);
  const ImVec2 from = ImGui::GetCursorScreenPos();
  for (std::size_t k = 0; k < choices_.size(); ++k) {
    const Box& at = boxes[k];
    draw_label(ui, {from.x + at.x, from.y + at.y, at.width, at.height}, k);
  }
  ImGui::SetCursorScreenPos({from.x, from.y + boxes.back().bottom()});
  ImGui::EndChild();
  choose_by_key(ui);
  return high;
}

void PathView::draw_label(const Ui& ui, const Box& box, std::size_t k) {
  const std::string& label = choices_[k];
  const bool chosen = scene_.drawing.chosen() == label;
  const Rgb colour = k == 0 ? ui.look.palette.quiet : colours_.of(label);
  const std::string_view words = k == 0 ? any_style : std::string_view(label);
  if (answer_button(ui, target_of(label), box, words, chosen, chosen, &colour)) choose(k);
  if (!chosen) fill({box.x, box.y, ui.layout.size(4), box.height}, colour);
}

void PathView::choose(std::size_t k) { scene_.drawing.choose(choices_[k]); }

// The arrow keys go from style to style, as among the answers to a question.
void PathView::choose_by_key(const Ui& ui) {
  const auto chosen = static_cast<std::size_t>(
      std::find(choices_.begin(), choices_.end(), scene_.drawing.chosen()) - choices_.begin());
  if (!ui.focus.on("press", target_of(scene_.drawing.chosen()))) return;
  std::size_t next = chosen;
  if (key_pressed(ImGuiKey_RightArrow) || key_pressed(ImGuiKey_DownArrow)) ++next;
  if ((key_pressed(ImGuiKey_LeftArrow) || key_pressed(ImGuiKey_UpArrow)) && next > 0) --next;
  if (next == chosen || next >= choices_.size()) return;
  choose(next);
  ui.focus.go_on("press", target_of(choices_[next]));
}

std::string PathView::words() const {
  if (!scene_.worker.trouble().empty()) return scene_.worker.trouble();
  if (!saved_.words.empty()) return saved_.words;
  if (scene_.drawing.open() && !scene_.drawing.drawing()) return open_words;
  if (scene_.worker.working() || !wanted_ || !walked_ || !walked_->result) return {};
  return describe(*walked_->result, wanted_->length, scene_.graph.frame_time);
}

void PathView::draw_state(const Ui& ui, const Box& box) {
  if (scene_.worker.working()) return draw_progress(ui, box);
  const bool alarm = !scene_.worker.trouble().empty() || saved_.failed;
  draw_paragraphs(ui.look.fonts.text, box.x, box.y, box.width,
                  alarm ? ui.look.palette.alarm : ui.look.palette.text, words());
}

void PathView::draw_progress(const Ui& ui, const Box& box) {
  const Palette& palette = ui.look.palette;
  const float high = ui.layout.size(32);
  const Box stop{box.right() - ui.layout.size(80), box.y, ui.layout.size(80), high};
  const Box bar{box.x, box.y + ui.layout.size(10), stop.x - box.x - ui.layout.size(16),
                ui.layout.size(12)};
  fill(bar, palette.track);
  const double share = scene_.worker.share();
  fill({bar.x, bar.y, std::round(static_cast<float>(share) * bar.width), bar.height},
       palette.created);
  if (button(ui, "stop", stop, "Stop", ButtonKind::outlined)) scene_.worker.stop();
  draw_text(ui.look.fonts.text, {box.x, box.y + high, box.width, box.height - high}, palette.text,
            fmt::format("Looking for the best walk: {:.0f} %", 100 * share));
}

void PathView::draw_foot(const Ui& ui) {
  const Layout& layout = ui.layout;
  const bool drawn = !scene_.drawing.corners().empty();
  const bool walks = !scene_.stage.wandering();
  if (button(ui, "clear", layout.start_over(), "Clear", ButtonKind::outlined, drawn)) {
    scene_.drawing.clear();
    pressed_at_.reset();
  }
  const Box again = save_ ? layout.box(992, 648, 104, 48) : layout.done();
  if (button(ui, "again", again, "Walk again", ButtonKind::outlined, walks)) {
    scene_.stage.begin_again();
  }
  const bool whole = walked_ != nullptr && walked_->result && !scene_.worker.working();
  if (save_ && button(ui, "save", layout.done(), "Save", ButtonKind::filled, whole)) save();
}

void PathView::save() {
  saved_ = report_of_saving([this] { save_(walked_->motion->take); });
}

}  // namespace promenade::app
