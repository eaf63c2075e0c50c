#include "tests/app/panel_bench.h"

#include <algorithm>
#include <stdexcept>

#include "app/session_view.h"
#include "motion/builtin.h"
#include "study/adjective_model.h"
#include "study/study.h"

namespace promenade::app::bench {
namespace {

study::Parameters with(const study::Parameters& changed, study::Parameters parameters) {
  for (const auto& [name, value] : changed) parameters.at(name) = value;
  return parameters;
}

}  // namespace

const motion::MotionSpace& space() {
  static const motion::MotionSpace made = motion::make_motion_space(*motion::builtin_set("A"));
  return made;
}

const motion::MotionSpace& long_space(int count) {
  static std::map<int, motion::MotionSpace> made;
  if (const auto found = made.find(count); found != made.end()) return found->second;
  motion::MotionSet set = space().set;
  const std::vector<motion::Cycle> cycles = set.cycles;
  set.cycles.clear();
  for (int i = 0; i < count; ++i) {
    motion::Cycle cycle = cycles[static_cast<std::size_t>(i) % cycles.size()];
    cycle.style = "a_style_with_a_long_name";
    cycle.name = cycle.style + "_" + std::to_string(100 + i);
    set.cycles.push_back(cycle);
  }
  return made.emplace(count, motion::make_motion_space(set)).first->second;
}

study::Parameters standard_parameters(const study::InterfaceType& type) {
  study::Parameters parameters;
  for (const study::ParameterSpec& spec : type.parameters) parameters[spec.name] = spec.standard;
  return parameters;
}

study::PreparedModel prepared_model(const study::InterfaceType& type,
                                    const motion::MotionSpace& space,
                                    const study::Parameters& parameters) {
  if (!type.prepare) return {};
  const auto adjectives = [&space]() -> std::shared_ptr<const study::AdjectiveModel> {
    static const auto model =
        std::make_shared<const study::AdjectiveModel>(*study::builtin_adjective_model("A"));
    return &space == &bench::space() ? model : nullptr;
  };
  return type.prepare({space, adjectives}, parameters);
}

PanelBench::PanelBench(const std::string& interface, const motion::MotionSpace& space,
                       const study::Parameters& changed, const PanelView& view)
    : space_(space),
      type_(*interfaces().find(interface)),
      captions_(captions_of(study::load_texts(view.language), space.set)),
      parameters_(with(changed, standard_parameters(type_))),
      prepared_(prepared_model(type_, space, parameters_)),
      content_{space_, captions_, nullptr},
      gui_(make_palette(false), words_of(captions_)),
      state_(type_.start({space_, parameters_, study::start_weights(space_), 1, prepared_.model})) {
  gui_.fit(view.width, view.height);
  unsigned char* pixels = nullptr;
  int width = 0;
  int height = 0;
  ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
  frame();
  frame();
}

void PanelBench::frame() {
  ImGuiIO& io = ImGui::GetIO();
  io.DeltaTime = 1.0f / 60;
  queue_.feed(io);
  changes_.clear();
  now_us_ += 16'667;
  ImGui::NewFrame();
  focus_.begin(widgets_);
  widgets_.clear();
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(io.DisplaySize);
  ImGui::Begin("page", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings);
  const Ui ui{gui_.look(), gui_.layout(), widgets_, focus_};
  study::InterfacePanel panel(ui, box(), content_, now_us_, changes_);
  type_.draw(*state_, panel);
  ImGui::End();
  ImGui::Render();
  vertices_ = ImGui::GetDrawData()->TotalVtxCount;
  for (study::ControlInput& change : changes_) {
    change.t_us = now_us_;
    if (state_->apply(change) == study::Applied::refused)
      throw std::logic_error("the panel reported what cannot be");
    log_.push_back(change);
  }
}

void PanelBench::push(UiEvent event) {
  queue_.push(event);
  while (!queue_.empty()) frame();
}

void PanelBench::move_to(double x, double y) {
  push({.kind = UiEvent::Kind::move, .x = x, .y = y});
}
void PanelBench::press() { push({.kind = UiEvent::Kind::button, .code = 0, .down = true}); }
void PanelBench::release() { push({.kind = UiEvent::Kind::button, .code = 0, .down = false}); }
void PanelBench::wheel(double notches) {
  push({.kind = UiEvent::Kind::wheel, .y = notches});
  frame();
}

void PanelBench::key(int glfw_key) {
  push({.kind = UiEvent::Kind::key, .code = glfw_key, .down = true});
  push({.kind = UiEvent::Kind::key, .code = glfw_key, .down = false});
}

void PanelBench::type(const std::string& ascii) {
  for (const char letter : ascii) push({.kind = UiEvent::Kind::character, .code = letter});
  frame();
}

void PanelBench::click(const std::string& kind, const std::string& target) {
  const Widget* widget = find(kind, target);
  if (widget == nullptr) throw std::logic_error("there is no " + kind + " " + target);
  move_to(widget->box.middle_x(), widget->box.middle_y());
  press();
  release();
  frame();  // with what it led to
}

void PanelBench::drag(const std::string& target, double value, int steps, const std::string& kind) {
  const Widget widget = *find(kind, target);
  const double from = widget.knob;
  const double to = widget.at_zero + value * (widget.at_one - widget.at_zero);
  move_to(from, widget.box.middle_y());
  press();
  for (int k = 1; k <= steps; ++k) move_to(from + (to - from) * k / steps, widget.box.middle_y());
  release();
}

}  // namespace promenade::app::bench
