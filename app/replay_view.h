// A logged trial on its page, drawn as the participant saw it: nothing reacts. A ring stands
// where a mouse button was last pressed, and a strip beneath the page says what is played. Needs
// no window, so that tests drive it.
#pragma once

#include "app/gui.h"
#include "app/screens/screen.h"
#include "app/trial_player.h"

namespace promenade::app {

// Every text that the page and the strip can show.
std::vector<std::string> replayed_words(const study::StudyBundle& bundle,
                                        const study::LoggedSession& log);

class ReplayView {
 public:
  // All outlive the view.
  ReplayView(const study::StudyBundle& bundle, const study::InterfaceRegistry& registry,
             const study::LoggedSession& log, TrialPlayer& player, Gui& gui);

  // Follows the size of the window. True: the fonts are new, and so must be their texture.
  bool fit(int width, int height);
  // Draws the page at the player's time; leaves it in ImGui::GetDrawData. `hint`: what the
  // strip says at its end.
  void frame(std::string_view hint = "");
  // What stands under it: the figures, large and small. They are those that the frame asked for.
  void draw_figures(FigureRenderer& renderer);

  const WidgetMap& widgets() const { return widgets_; }
  const std::string& strip() const { return said_; }  // what it says
  // Where the ring stands, pixels; nothing: there was no press, or no window.
  std::optional<Eigen::Vector2f> ring() const;

 private:
  StagePlan stage_plan() const;
  void draw_page();
  void draw_ring() const;
  void draw_strip(std::string_view hint);

  const study::StudyBundle& bundle_;
  const study::InterfaceRegistry& registry_;
  const study::LoggedSession& log_;
  TrialPlayer& player_;
  Gui& gui_;
  std::optional<Layout> logged_layout_;  // of the participant's window
  std::string language_;
  Captions captions_;
  study::InterfacePanel::Content content_;
  Box strip_;
  ScreenMemory memory_;
  WidgetMap widgets_;
  Focus focus_;
  std::string said_;
  // What the page says was done; nothing was.
  std::vector<StudyAction> actions_;
  std::vector<study::ControlInput> changes_;
  std::vector<OfferedLanguage> languages_;
};

}  // namespace promenade::app
