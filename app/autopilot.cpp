#include "app/autopilot.h"

#include <algorithm>
#include <cmath>

namespace promenade::app {

using study::PageKind;

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
  return has_errand_ && page_ != &session.page();
}

void Autopilot::act(std::int64_t now_us, const study::Session& session, const WidgetMap& widgets,
                    InputQueue& queue) {
  now_us_ = now_us;
  if (session.ended()) return;
  if (lost(session)) {
    let_go(queue);
    has_errand_ = false;
    enter(Stage::thinking, 0.5);
  }
  switch (stage_) {
    case Stage::thinking:
      if (now_us_ < due_us_) return;
      return has_errand_ ? enter(Stage::reaching, 0) : think(session, widgets);
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
      if (errand_.kind == "type") return enter(Stage::typing, 0.2);
      has_errand_ = false;
      return enter(Stage::thinking, 0.1);
    case Stage::typing:
      return type(queue);
  }
}

Autopilot::Errand Autopilot::errand_of(const decltype(study::Input::action)& action) const {
  if (const auto* choice = std::get_if<study::ChooseLanguage>(&action)) {
    return {"press", "language:" + choice->language};
  }
  if (std::holds_alternative<study::Continue>(action)) return {"press", "continue"};
  if (std::holds_alternative<study::Resume>(action)) return {"press", "resume"};
  if (std::holds_alternative<study::Decline>(action)) return {"press", "decline"};
  if (std::holds_alternative<study::Done>(action)) return {"press", "done"};
  if (std::holds_alternative<study::StartOver>(action)) return {"press", "start_over"};
  if (const auto* answer = std::get_if<study::SetAnswer>(&action)) {
    const auto point = static_cast<int>(std::lround(answer->value.value_or(0)));
    return {"press", "answer:" + answer->item + ":" + std::to_string(point)};
  }
  if (const auto* control = std::get_if<study::Control>(&action)) {
    const study::ControlInput& input = control->input;
    return {input.kind, input.target, input.value, input.x, input.y};
  }
  return {};
}

void Autopilot::think(const study::Session& session, const WidgetMap& widgets) {
  page_ = &session.page();
  if (const Widget* offer = widgets.find_first("press", "resume:")) {
    has_errand_ = true;
    errand_ = {"press", offer->target};
    return enter(Stage::thinking, 1);
  }
  if (page_->kind == PageKind::welcome && !code_typed_) {
    has_errand_ = true;
    errand_ = {"type", "code"};
    return enter(Stage::thinking, 1);
  }
  const study::Intention intention = participant_.next(session);
  errand_ = errand_of(intention.action);
  has_errand_ = !errand_.kind.empty();
  enter(Stage::thinking, 1e-6 * static_cast<double>(intention.wait_us));
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
  const Widget* widget = widgets.find(errand_.kind, errand_.target);
  if (widget == nullptr) {  // not on this page: think again
    has_errand_ = false;
    return enter(Stage::thinking, 0.3);
  }
  if (!widget->visible()) {
    const Point middle{widget->view.middle_x(), widget->view.middle_y()};
    if (std::hypot(at_.x - middle.x, at_.y - middle.y) > 2) return start_moving(middle);
    const double notch = widget->box.y < widget->view.y ? 1 : -1;
    push(queue, {.kind = UiEvent::Kind::wheel, .y = notch});
    return enter(Stage::reaching, 0.06);
  }
  const Point aim = aim_at(*widget, errand_);
  if (std::hypot(at_.x - aim.x, at_.y - aim.y) > 1) return start_moving(aim);
  enter(Stage::pressing, 0.06);
}

void Autopilot::press(const WidgetMap& widgets, InputQueue& queue) {
  if (now_us_ < due_us_) return;
  push(queue, {.kind = UiEvent::Kind::button, .code = 0, .down = true});
  holding_ = true;
  const Widget* widget = widgets.find(errand_.kind, errand_.target);
  if (widget != nullptr && widget->slides && std::isfinite(errand_.value)) {
    const double span = widget->at_one - widget->at_zero;
    start_moving({widget->at_zero + errand_.value * span, at_.y});
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
  if (typed_ < code_.size()) {
    push(queue, {.kind = UiEvent::Kind::character, .code = code_[typed_++]});
    return enter(Stage::typing, 0.12);
  }
  code_typed_ = true;
  has_errand_ = false;
  enter(Stage::thinking, 0.2);
}

}  // namespace promenade::app
