// One running session on one screen, without a window: hands input to the pages
// and what they say to the session. The tests play whole sessions with it.
#pragma once

#include <functional>
#include <memory>

#include "app/gui.h"
#include "app/live_session.h"
#include "app/roster_place.h"
#include "app/screens/screen.h"
#include "app/window/input_queue.h"
#include "app/window/shown_frame.h"

namespace promenade::app {

struct ViewOptions {
  std::string language = "en";  // empty: the first page asks
  std::string participant;      // empty: the welcome page asks
  bool pilot = false, simulated = false;
  std::vector<study::InterruptedSession> interrupted = {};  // here, of this kind
  // What a roster says to a code; empty: there is none, and every code is good.
  std::function<RosterAnswer(const std::string& typed)> ask_roster = {};
  // Where a watcher asks for things; null: nowhere. Outlives the view.
  study::RequestReader* requests = nullptr;
};

// Every text that the pages can show, in every language of the study.
std::vector<std::string> shown_words(const study::StudyBundle& bundle);
class SessionView {
 public:
  // Everything named outlives the view. `gui` has been fitted.
  SessionView(const study::StudyBundle& bundle, const study::InterfaceRegistry& registry,
              const Gui& gui, LiveSession& live, InputQueue& queue, const ViewOptions& options);

  // Lets the figures walk on, as the session now is.
  void advance(std::int64_t now_us);
  // Takes in the events, draws the page and steps the session: again for each change of a
  // button or a key that waits, as long as the page stays, for nobody has seen another one.
  // Leaves the drawing in ImGui::GetDrawData.
  void frame(std::int64_t now_us);
  // Takes in all that has arrived, whatever page it leads to: nothing comes after.
  void settle(std::int64_t now_us);
  // A frame was put on screen.
  void shown(const ShownFrame& frame);
  // The window is to be closed. Where there can be a pause it opens one that offers the end
  // of the session; asked there again, or anywhere else, the session is over.
  void ask_to_close(std::int64_t now_us);
  // What arrived before comes first. `actor`: the participant who closed the window, or the
  // experimenter.
  void stop(const std::string& reason, std::int64_t now_us, study::Actor actor);
  bool ended() const;
  // The last page says from now on that there is no second copy of the database, and why.
  void tell_copy_problem(std::string problem) { copy_problem_ = std::move(problem); }

  // Draws the figures of the page, large and small, and the ground of its panel.
  void draw_figures(FigureRenderer& renderer);
  Stage& stage() { return stage_; }
  const std::string& language() const { return language_; }
  const WidgetMap& widgets() const { return widgets_; }
  const Focus& focus() const { return focus_; }

 private:
  bool covered() const;            // by a page without figures
  void pass(std::int64_t now_us);  // one change of a button or a key
  int cover() const;
  bool has_turned() const;  // since the last pass
  bool is_fresh();
  void take_late_frames(std::int64_t until_us);
  void end(const std::string& reason, std::int64_t t_us, study::Actor actor);
  bool has_panel() const;
  Cast cast(std::int64_t now_us) const;
  StagePlan stage_plan() const;
  const study::PlannedTrial& planned() const;  // of the page
  Moment moment_at(std::int64_t t_us, std::int64_t uncertainty_us) const;
  void take_presses();
  void take_requests(std::int64_t now_us);
  void obey(const study::Request& request, const Moment& moment);
  void take_actions();
  void leave_welcome();
  void close_left();
  bool is_expected();
  void resume(const std::string& uuid, std::int64_t now_us);
  void refuse_offers();
  void speak(const std::string& language);

  const study::StudyBundle& bundle_;
  const study::InterfaceRegistry& registry_;
  const Gui& gui_;
  LiveSession& live_;
  InputQueue& queue_;
  ViewOptions options_;
  std::string language_;
  Captions captions_;
  std::vector<OfferedLanguage> languages_;
  Stage stage_;
  study::InterfacePanel::Content content_;
  motion::Cycle average_;  // walks where nothing is asked yet
  ScreenMemory memory_;
  WidgetMap widgets_;
  Focus focus_;
  std::vector<StudyAction> actions_;
  std::vector<StudyAction> orders_;  // of the experimenter
  std::vector<study::ControlInput> changes_;
  std::int64_t drawn_us_ = 0;
  std::int64_t shown_us_ = -1, shown_before_us_ = -1;
  std::vector<ShownFrame> late_;       // not logged yet: events wait that came before
  const study::Page* page_ = nullptr;  // of the frame before
  int cover_ = 0;                      // and what covered it
  std::string copy_problem_;           // empty: none
  std::int64_t asked_us_ = 0;          // when it was last seen whether a watcher asks
  bool closed_ = false;
};

}  // namespace promenade::app
