#include "study/event_input.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace promenade::study {
namespace {

using Action = decltype(Input::action);
using Json = nlohmann::json;

struct Plain {
  const char* kind;
  Action action;
};

// Actions that have nothing but their name.
const std::array<Plain, 14>& plain_actions() {
  static const std::array<Plain, 14> all = {{{"continue", Continue{}},
                                             {"decline", Decline{}},
                                             {"press", Press{}},
                                             {"done", Done{}},
                                             {"start_over", StartOver{}},
                                             {"undo", Undo{}},
                                             {"back", Back{}},
                                             {"leave", Leave{}},
                                             {"redo", Redo{}},
                                             {"pause", Pause{}},
                                             {"resume", Resume{}},
                                             {"release", Release{}},
                                             {"done_refused", Done{}},
                                             {"continue_refused", Continue{}}}};
  return all;
}

bool by_the_system(const std::string& kind) {
  for (const char* one :
       {"page", "start", "won", "timeout", "won_by_guess", "practice_over", "practice_again"}) {
    if (kind == one) return true;
  }
  return false;
}

Action camera_of(const Json& detail) {
  return Camera{detail.value("yaw", 0.0), detail.value("pitch", 0.0), detail.value("zoom", 1.0),
                detail.value("right", 0.0), detail.value("up", 0.0)};
}

Action control_of(const Event& event, const Json& detail) {
  return Control{{.kind = event.kind,
                  .target = event.target,
                  .text = detail.value("text", ""),
                  .value = event.value.value_or(no_value),
                  .x = event.x.value_or(no_value),
                  .y = event.y.value_or(no_value)}};
}

std::optional<Action> action_of(const Event& event) {
  if (by_the_system(event.kind)) return std::nullopt;
  for (const Plain& plain : plain_actions()) {
    if (event.kind == plain.kind) return plain.action;
  }
  const Json detail = event.detail.empty() ? Json::object() : Json::parse(event.detail);
  if (event.kind == "language") return ChooseLanguage{event.target};
  if (event.kind == "answer") {
    return SetAnswer{event.target, event.value, detail.value("text", ""),
                     detail.value("declined", false)};
  }
  if (event.kind == "note") return Note{detail.value("text", "")};
  if (event.kind == "request_refused") return Refused{event.target, detail.value("why", "")};
  if (event.kind == "skip") return Skip{detail.value("reason", "")};
  if (event.kind == "repeat") {
    return Repeat{event.target == "block", detail.value("reason", ""), event.target == "guess"};
  }
  if (event.kind == "interrupted") {
    return Interrupted{std::llround(1e6 * event.value.value_or(0)), resume_policy_of(event.target)};
  }
  if (event.kind == "return") return Return{std::llround(1e6 * event.value.value_or(0))};
  if (event.kind == "late_frame") return LateFrame{std::llround(event.value.value_or(0))};
  if (event.kind == "camera") return camera_of(detail);
  if (event.kind == "stop") return Stop{detail.value("reason", "")};
  if (event.kind == "playback") {
    return Playback{event.target == "play", event.value.value_or(1), detail.value("phase", -1.0)};
  }
  // Whatever else was done to a control says whether it was taken.
  if (!detail.contains("applied")) return std::nullopt;
  return control_of(event, detail);
}

std::string request_in(const Event& event) {
  if (event.actor != Actor::experimenter || event.detail.empty()) return "";
  return Json::parse(event.detail).value("request", "");
}

}  // namespace

std::optional<Input> input_of(const Event& event) {
  std::optional<Action> action;
  Input input;
  try {
    action = action_of(event);
    input.request = request_in(event);
  } catch (const Json::exception&) {
    throw InputError("event \"" + event.kind + "\" at " + std::to_string(event.t_us) + " us",
                     "its detail is damaged");
  }
  if (!action) return std::nullopt;
  input.t_us = event.t_us;
  input.uncertainty_us = event.uncertainty_us;
  input.frame_us = event.frame_us;
  input.actor = event.actor;
  input.x = event.x.value_or(0);
  input.y = event.y.value_or(0);
  input.action = std::move(*action);
  return input;
}

}  // namespace promenade::study
