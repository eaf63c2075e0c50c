#include "app/autopilot.h"

#include <algorithm>
#include <cmath>

#include "app/item_targets.h"
#include "study/lines.h"
#include "study/utf8.h"

namespace promenade::app {

using study::PageKind;

namespace {

using Action = decltype(study::Input::action);

constexpr const char* release_target = "experimenter:release";

}  // namespace

void Autopilot::push(InputQueue& queue, UiEvent event) const {
  event.t_us = now_us_;
  queue.push(event);
}

void Autopilot::enter(Stage stage, double seconds) {
  stage_ = stage;
  due_us_ = now_us_ + static_cast<std::int64_t>(1e6 * seconds);
}

// Another page came up while the hand was on its way (the time was over).
bool Autopilot::lost(const study::Session& session) const {
  return !errands_.empty() && page_ != &session.page();
}

void Autopilot::act(std::int64_t now_us, const study::Session& session, const WidgetMap& widgets,
                    InputQueue& queue) {
  now_us_ = now_us;
  if (session.ended()) return;
  if (lost(session)) {
    let_go(queue);
    errands_.clear();
    enter(Stage::thinking, 0.5);
  }
  switch (stage_) {
    case Stage::thinking:
      if (now_us_ < due_us_) return;
      return errands_.empty() ? think(session, widgets, queue) : enter(Stage::reaching, 0);
    case Stage::reaching:
      return reach(widgets, queue);
    case Stage::pressing:
      return press(widgets, queue);
    case Stage::dragging:
      if (moved(queue)) enter(Stage::letting_go, 0.08);
      return;
    case Stage::letting_go:
      if (now_us_ < due_us_) return;
      let_go(queue);
      if (errands_.front().kind == "type") return enter(Stage::typing, 0.2);
      return forget();
    case Stage::typing:
      return type(queue);
  }
}

namespace {

// The button that says it alone; empty: there is none.
std::string button_of(const Action& action) {
  if (const auto* choice = std::get_if<study::ChooseLanguage>(&action)) {
    return "language:" + choice->language;
  }
  if (std::holds_alternative<study::Continue>(action)) return "continue";
  if (std::holds_alternative<study::Resume>(action)) return "resume";
  if (std::holds_alternative<study::Decline>(action)) return "decline";
  if (std::holds_alternative<study::Done>(action)) return "done";
  if (std::holds_alternative<study::StartOver>(action)) return "start_over";
  if (std::holds_alternative<study::Back>(action)) return "back";
  if (std::holds_alternative<study::Leave>(action)) return "leave";
  return "";
}

}  // namespace

Autopilot::Errands Autopilot::errands_to(const study::Item& item, const study::SetAnswer& set) {
  using study::ItemKind;
  const std::string& name = item.name;
  const double value = set.value.value_or(0);
  if (set.declined) return {{"press", decline_target(name)}};
  switch (item.kind) {
    case ItemKind::scale:
      return {{"press", answer_target(name, value)}};
    case ItemKind::agree:
      return {{"press", agree_target(name)}};
    case ItemKind::number:
      return {{.kind = "type", .target = words_target(name), .text = value_text(value)}};
    case ItemKind::text:
      return {{.kind = "type", .target = words_target(name), .text = set.text}};
    case ItemKind::ranking: {
      Errands errands;
      for (const std::string& option : study::lines_of(set.text)) {
        errands.push_back({"press", rank_target(name, option)});
      }
      return errands;
    }
    case ItemKind::choice:
      break;
  }
  Errands errands = {{"press", answer_target(name, value)}};
  const auto place = static_cast<std::size_t>(value) - 1;
  if (set.text != item.choices[place].name) {
    errands.push_back({.kind = "type", .target = own_target(name), .text = set.text});
  }
  return errands;
}

Autopilot::Errands Autopilot::errands_of(const study::Session& session, const Action& action) {
  const std::string button = button_of(action);
  if (!button.empty()) return {{"press", button}};
  if (const auto* set = std::get_if<study::SetAnswer>(&action)) {
    const study::Instrument* asked = session.questions();
    const study::Item* item = asked == nullptr ? nullptr : find_item(*asked, set->item);
    return item == nullptr ? Errands{} : errands_to(*item, *set);
  }
  if (const auto* control = std::get_if<study::Control>(&action)) {
    const study::ControlInput& input = control->input;
    return {{input.kind, input.target, input.value, input.x, input.y}};
  }
  return {};
}

void Autopilot::plan(Errands errands, double seconds) {
  errands_ = std::move(errands);
  enter(Stage::thinking, seconds);
}

void Autopilot::forget() {
  if (!errands_.empty()) errands_.pop_front();
  enter(Stage::thinking, errands_.empty() ? 0.1 : 0.4);
}

bool Autopilot::think_of_the_program(const WidgetMap& widgets, InputQueue& queue) {
  if (const Widget* offer = widgets.find_first("press", "resume:")) {
    plan({{"press", offer->target}}, 1);
    return true;
  }
  if (page_->kind == PageKind::welcome && !code_typed_) {
    plan({{.kind = "type", .target = "code", .text = code_}}, 1);
    code_typed_ = true;
    return true;
  }
  if (page_->kind != PageKind::release) return false;
  if (widgets.find("press", release_target) == nullptr) {
    press_chord(queue);
    plan({}, 1);
  } else {
    plan({{"press", release_target}}, 1);
  }
  return true;
}

void Autopilot::press_chord(InputQueue& queue) {
  for (const bool down : {true, false}) {
    for (const int key : experimenter_chord) {
      push(queue, {.kind = UiEvent::Kind::key, .code = key, .down = down});
    }
  }
}

void Autopilot::think(const study::Session& session, const WidgetMap& widgets, InputQueue& queue) {
  page_ = &session.page();
  if (think_of_the_program(widgets, queue)) return;
  const study::Intention intention = participant_.next(session);
  plan(errands_of(session, intention.action), 1e-6 * static_cast<double>(intention.wait_us));
}

// The time that a hand takes grows with the way (after Fitts).
void Autopilot::start_moving(Point to) {
  from_ = at_;
  to_ = to;
  const double way = std::hypot(to.x - from_.x, to.y - from_.y);
  const double seconds = 0.12 + 0.09 * std::log2(1 + way / 20);
  left_us_ = now_us_;
  arrives_us_ = now_us_ + static_cast<std::int64_t>(1e6 * seconds);
  moving_ = true;
}

bool Autopilot::moved(InputQueue& queue) {
  if (!moving_) return true;
  const double share = std::clamp(
      static_cast<double>(now_us_ - left_us_) / static_cast<double>(arrives_us_ - left_us_), 0.0,
      1.0);
  // Smallest jerk: starts and ends at rest.
  const double eased = share * share * share * (10 + share * (6 * share - 15));
  at_ = {from_.x + eased * (to_.x - from_.x), from_.y + eased * (to_.y - from_.y)};
  push(queue, {.kind = UiEvent::Kind::move, .x = at_.x, .y = at_.y});
  moving_ = share < 1;
  return !moving_;
}

Autopilot::Point Autopilot::aim_at(const Widget& widget, const Errand& errand) {
  if (widget.plane && std::isfinite(errand.x) && std::isfinite(errand.y)) {
    return {widget.zero_x + widget.unit_x * errand.x, widget.zero_y - widget.unit_y * errand.y};
  }
  return {widget.slides ? widget.knob : widget.box.middle_x(), widget.box.middle_y()};
}

void Autopilot::reach(const WidgetMap& widgets, InputQueue& queue) {
  if (moving_ && !moved(queue)) return;
  if (now_us_ < due_us_) return;
  const Errand& errand = errands_.front();
  const Widget* widget = widgets.find(errand.kind, errand.target);
  // Not on this page: think again. What is in the order already stays there.
  const bool ranked = widget != nullptr && widget->on && errand.target.rfind("rank:", 0) == 0;
  if (widget == nullptr || ranked) return forget();
  if (!widget->visible()) {
    const Point middle{widget->view.middle_x(), widget->view.middle_y()};
    if (std::hypot(at_.x - middle.x, at_.y - middle.y) > 2) return start_moving(middle);
    const double notch = widget->box.y < widget->view.y ? 1 : -1;
    push(queue, {.kind = UiEvent::Kind::wheel, .y = notch});
    return enter(Stage::reaching, 0.06);
  }
  const Point aim = aim_at(*widget, errand);
  if (std::hypot(at_.x - aim.x, at_.y - aim.y) > 1) return start_moving(aim);
  enter(Stage::pressing, 0.06);
}

void Autopilot::press(const WidgetMap& widgets, InputQueue& queue) {
  if (now_us_ < due_us_) return;
  push(queue, {.kind = UiEvent::Kind::button, .code = 0, .down = true});
  holding_ = true;
  const Errand& errand = errands_.front();
  const Widget* widget = widgets.find(errand.kind, errand.target);
  if (widget != nullptr && widget->slides && std::isfinite(errand.value)) {
    const double span = widget->at_one - widget->at_zero;
    start_moving({widget->at_zero + errand.value * span, at_.y});
    return enter(Stage::dragging, 0);
  }
  enter(Stage::letting_go, 0.09);
}

void Autopilot::let_go(InputQueue& queue) {
  if (holding_) push(queue, {.kind = UiEvent::Kind::button, .code = 0, .down = false});
  holding_ = moving_ = false;
}

void Autopilot::type(InputQueue& queue) {
  if (now_us_ < due_us_) return;
  std::string& left = errands_.front().text;
  if (!left.empty()) {
    push(queue, {.kind = UiEvent::Kind::character, .code = study::take_character(left)});
    return enter(Stage::typing, 0.12);
  }
  forget();
  // What was written is told when the hand rests.
  enter(Stage::thinking, 1);
}

}  // namespace promenade::app
