// One interface on a panel, without a window: real widgets, real events, no
// graphics card.
#pragma once

#include <string>
#include <vector>

#include "app/gui.h"
#include "app/panel.h"
#include "app/registry.h"
#include "app/window/input_queue.h"
#include "study/study.h"

namespace promenade::app::bench {

// The built-in set with each cycle once; or `count` cycles with long names made of it.
const motion::MotionSpace& space();
const motion::MotionSpace& long_space(int count);

// How a panel is looked at.
struct PanelView {
  std::string language = "en";
  int width = 1280, height = 720;
};

class PanelBench {
 public:
  // `changed`: parameters that are not as standard.
  explicit PanelBench(const std::string& interface,
                      const motion::MotionSpace& space = bench::space(),
                      const study::Parameters& changed = {}, const PanelView& view = {});

  // Draws once; what the panel reported is applied, as the session would.
  void frame();
  void push(UiEvent event);
  void move_to(double x, double y);
  void press();
  void release();
  void click(const std::string& kind, const std::string& target);
  // Takes the knob of a slider to a value, through `steps` places on the way.
  void drag(const std::string& target, double value, int steps = 5,
            const std::string& kind = "slide");
  void key(int glfw_key);
  void type(const std::string& ascii);
  void wheel(double notches);

  const Widget* find(const std::string& kind, const std::string& target) const {
    return widgets_.find(kind, target);
  }
  const study::InterfaceType& type() const { return type_; }
  study::InterfaceState& state() { return *state_; }
  Eigen::VectorXd weights() const { return study::weights_of(*state_, now_us_); }
  const std::vector<study::ControlInput>& log() const { return log_; }  // all reports
  const study::Texts& texts() const { return captions_.texts; }
  const Focus& focus() const { return focus_; }
  std::int64_t now_us() const { return now_us_; }
  Box box() const { return gui_.layout().panel(); }
  int vertices() const { return vertices_; }  // of the last frame

 private:
  const motion::MotionSpace& space_;
  const study::InterfaceType& type_;
  Captions captions_;
  study::Parameters parameters_;
  study::PreparedModel prepared_;
  study::InterfacePanel::Content content_;
  Gui gui_;
  InputQueue queue_;
  WidgetMap widgets_;
  Focus focus_;
  std::int64_t now_us_ = 0;
  std::unique_ptr<study::InterfaceState> state_;
  std::vector<study::ControlInput> log_, changes_;
  int vertices_ = 0;
};

study::Parameters standard_parameters(const study::InterfaceType& type);
// What the type works out for a space; adjectives from the simulated raters of set A.
study::PreparedModel prepared_model(const study::InterfaceType& type,
                                    const motion::MotionSpace& space,
                                    const study::Parameters& parameters);

}  // namespace promenade::app::bench
