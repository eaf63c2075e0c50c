// A simulated participant at the mouse: turns intentions into mouse and keyboard
// events that enter where those of the window do, so that the real widgets are
// clicked and dragged. The pointer moves as a hand does: smoothly, and longer for
// longer ways. Where the experimenter has to let people go on it is the experimenter, too.
#pragma once

#include <deque>
#include <string>

#include "app/widget_map.h"
#include "app/window/input_queue.h"
#include "study/simulated.h"

namespace promenade::app {

class Autopilot {
 public:
  // `code` is typed where the welcome page asks for it.
  Autopilot(study::SimulatedParticipant participant, std::string code)
      : participant_(std::move(participant)), code_(std::move(code)) {}

  // Once a frame: pushes what the hand does by now. `widgets` are those on screen.
  void act(std::int64_t now_us, const study::Session& session, const WidgetMap& widgets,
           InputQueue& queue);

 private:
  struct Point {
    double x = 0, y = 0;
  };
  enum class Stage { thinking, reaching, pressing, dragging, letting_go, typing };
  struct Errand {  // the widget to go to and what to do there
    std::string kind, target;
    double value = study::no_value;                   // where a slider is taken to
    double x = study::no_value, y = study::no_value;  // where a plane is pressed
    std::string text = "";                            // what is typed there
  };
  using Errands = std::deque<Errand>;

  void think(const study::Session& session, const WidgetMap& widgets, InputQueue& queue);
  // Before the session asks for anything: offers, the code, the experimenter's panel.
  bool think_of_the_program(const WidgetMap& widgets, InputQueue& queue);
  void plan(Errands errands, double seconds);
  void press_chord(InputQueue& queue);
  void forget();
  static Errands errands_to(const study::Item& item, const study::SetAnswer& set);
  static Errands errands_of(const study::Session& session,
                            const decltype(study::Input::action)& action);
  static Point aim_at(const Widget& widget, const Errand& errand);
  void start_moving(Point to);
  bool moved(InputQueue& queue);  // true: there
  void reach(const WidgetMap& widgets, InputQueue& queue);
  void press(const WidgetMap& widgets, InputQueue& queue);
  void let_go(InputQueue& queue);
  void type(InputQueue& queue);
  void enter(Stage stage, double seconds);
  bool lost(const study::Session& session) const;
  void push(InputQueue& queue, UiEvent event) const;

  study::SimulatedParticipant participant_;
  std::string code_;
  bool code_typed_ = false;
  std::int64_t now_us_ = 0;
  Stage stage_ = Stage::thinking;
  std::int64_t due_us_ = 0;            // when the stage may end
  Errands errands_;                    // the first is under way
  const study::Page* page_ = nullptr;  // where the errand was thought of
  Point at_{640, 360}, from_, to_;
  std::int64_t left_us_ = 0, arrives_us_ = 0;
  bool moving_ = false, holding_ = false;
};

}  // namespace promenade::app
