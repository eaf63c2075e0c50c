#include "app/session_window.h"

#include <algorithm>

#include "app/autopilot.h"
#include "app/doctor/doctor.h"
#include "app/examples_window.h"
#include "app/print.h"
#include "app/registry.h"
#include "app/second_copy.h"
#include "app/session_view.h"
#include "app/window/clock.h"
#include "app/window/display_loss.h"
#include "app/window/frame_loop.h"
#include "app/window/gui_renderer.h"
#include "study/copy.h"
#include "study/identity.h"
#include "study/withdraw.h"

namespace promenade::app {
namespace {

study::SessionHeader header_of(const SessionSetting& setting, const Json& machine) {
  study::SessionHeader header;
  header.started_utc = study::utc_now();
  header.station = setting.station;
  header.language =
      setting.language.empty() ? setting.bundle.study.languages.front() : setting.language;
  header.simulated = setting.autopilot.has_value();
  header.pilot = setting.pilot;
  header.machine = machine.dump();
  return header;
}

// All that lives as long as the window does, in the order in which it is made.
class Player {
 public:
  Player(const SessionSetting& setting, study::Store& store)
      : setting_(setting),
        window_({.title = setting.bundle.study.name,
                 .windowed = setting.windowed,
                 .screen = setting.bundle.study.display.screen},
                queue_),
        gui_(make_palette(setting.bundle.study.display.paper_colours), shown_words(setting.bundle)),
        machine_(describe_machine()),
        live_(make_session(setting, store), store, header_of(setting, machine_), monotonic_us()) {
    queue_.watch(setting.watch_input);
    live_.keep_frames([&store](int trial, const study::FrameHistogram& frames) {
      store.write_frames(trial, frames);
    });
    view_ = std::make_unique<SessionView>(setting.bundle, interfaces(), gui_, live_, queue_,
                                          view_options(store));
    if (setting.autopilot) {
      autopilot_ = std::make_unique<Autopilot>(
          study::SimulatedParticipant(setting.bundle, interfaces(), *setting.autopilot),
          setting.participant.empty() ? store.next_simulated_code() : "");
    }
  }

  ~Player() {
    examples_.reset();
    use_own_window();
  }
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;

  SessionResult play() {
    open_examples();
    const DisplayLossGuard guard([this] { return last_words(); });
    warm_up();
    const FrameTimes times =
        run_frames(window_, {.draw_figures = [this](std::int64_t now_us) { draw_figures(now_us); },
                             .draw_screen = [this](std::int64_t now_us) { draw_screen(now_us); },
                             .shown = [this](const ShownFrame& frame) { view_->shown(frame); },
                             .ended = [this] { return ended(); }});
    if (live_.failure()) throw OutsideError(*live_.failure());
    return {.outcome = live_.session().outcome(),
            .recorded = live_.recorded(),
            .participant = live_.participant(),
            .interrupted = interrupted_,
            .frame_median = quantile_ms(times.interval_us, 0.5),
            .frame_p99 = quantile_ms(times.interval_us, 0.99),
            .work_median = quantile_ms(times.work_us, 0.5),
            .work_p99 = quantile_ms(times.work_us, 0.99)};
  }

 private:
  // The display is gone; the session waits as it does after a crash.
  std::string last_words() {
    gui_.use();
    if (view_) view_->settle(monotonic_us());
    live_.save();
    if (!live_.recorded()) return "the display went away before the session began; start it again";
    return "the display went away; the session until then is in " + setting_.database +
           ", start it again to go on with it";
  }

  static study::Session make_session(const SessionSetting& setting, study::Store& store) {
    const int sequence = setting.sequence
                             ? *setting.sequence
                             : store.next_sequence(setting.autopilot.has_value(), setting.pilot);
    return {setting.bundle, interfaces(), study::make_plan(setting.bundle.study, sequence),
            setting.language.empty()};
  }

  // Whose code was given is asked for nobody else.
  ViewOptions view_options(study::Store& store) {
    const bool simulated = setting_.autopilot.has_value();
    ViewOptions options{setting_.language, setting_.participant, setting_.pilot, simulated, {}};
    options.ask_roster = setting_.ask_roster;
    options.requests = &requests_;
    for (study::InterruptedSession& one : store.interrupted_sessions(simulated, setting_.pilot)) {
      const bool wanted = setting_.participant.empty() || setting_.participant == one.participant;
      // Whoever left may come back anywhere.
      if (wanted && (one.left || one.station == setting_.station))
        options.interrupted.push_back(std::move(one));
    }
    return options;
  }

  // A simulated participant is there to try the program, not the machine.
  Json describe_machine() {
    fit();
    Json machine = Json::parse(window_.description());
    machine["program"] = "promenade";
    if (setting_.autopilot) return machine;
    const Canvas canvas{window_, gui_, gui_renderer_, renderer_};
    machine["doctor"] = to_json(quick_doctor(canvas, setting_.bundle, setting_.database));
    queue_.forget_presses();  // no page was there yet
    return machine;
  }

  void fit() {
    const double share = setting_.bundle.study.display.scale;
    if (gui_.fit(window_.width(), window_.height(), share)) gui_renderer_.upload_fonts();
  }

  void open_examples() {
    const study::Display& display = setting_.bundle.study.display;
    if (display.examples != study::ExamplesWall::screen) return;
    const int screen = setting_.windowed ? 0 : another_display(display.screen);
    examples_ = std::make_unique<ExamplesWindow>(
        setting_.bundle, WindowOptions{.title = setting_.bundle.study.name + ": examples",
                                       .windowed = setting_.windowed,
                                       .screen = screen,
                                       .shows_only = true});
    use_own_window();
  }

  void use_own_window() {
    window_.use();
    gui_.use();
  }

  // At most 30 times a second and a fifth of the time: the session goes first.
  void draw_examples_window() {
    const std::int64_t now_us = monotonic_us();
    if (!examples_ || now_us < examples_due_us_) return;
    examples_->speak(view_->language());
    examples_->draw(view_->stage().phase(), live_.session().paused());
    examples_->show();
    use_own_window();
    const std::int64_t took_us = monotonic_us() - now_us;
    examples_due_us_ = now_us + std::max<std::int64_t>(33'000, 5 * took_us);
  }

  // Every program of the card is used once before anybody looks: the first time
  // takes up to a third of a second.
  void warm_up() {
    std::vector<Part> parts(1);
    parts[0].b = {0, 0.1f, 0};
    parts[0].radius_a = parts[0].radius_b = 0.1f;
    const View view = make_view({}, 1.7, 400, {600, 500}, {0, 0, 1000, 700});
    renderer_.begin(window_.width(), window_.height(), gui_.look().palette.background);
    renderer_.draw_ground(view, {}, Shadow{});
    renderer_.draw_parts(view, parts, gui_.look().palette.created);
    window_.poll();
    view_->frame(monotonic_us());
    gui_renderer_.draw();
    window_.swap();
    let_renderer_threads_idle();
  }

  void draw_figures(std::int64_t now_us) {
    fit();
    view_->advance(now_us);
    renderer_.begin(window_.width(), window_.height(), gui_.look().palette.background);
    view_->draw_figures(renderer_);
  }

  void draw_screen(std::int64_t now_us) {
    if (window_.closing()) close_requested(now_us);
    if (interrupted() && !view_->ended()) {
      view_->stop("interrupted", now_us, study::Actor::experimenter);
      interrupted_ = true;
    }
    if (view_->ended()) return;
    copy_on_last_page();
    if (autopilot_) autopilot_->act(now_us, live_.session(), view_->widgets(), queue_);
    view_->frame(now_us);
    gui_renderer_.draw();
    draw_examples_window();
  }

  // While there is still somebody to see that it failed.
  void copy_on_last_page() {
    const study::PageKind page = live_.session().page().kind;
    const bool last = page == study::PageKind::thanks || page == study::PageKind::declined;
    if (const auto problem = copy_.problem()) view_->tell_copy_problem(*problem);
    if (!last || copy_.started() || !live_.recorded()) return;
    live_.save();
    copy_.start([&setting = setting_] {
      return study::second_copy_problem(setting.bundle, setting.database, setting.station);
    });
  }

  // By accident, perhaps; nobody is there to be asked when the participant is simulated.
  void close_requested(std::int64_t now_us) {
    if (autopilot_) return view_->stop("window closed", now_us, study::Actor::participant);
    window_.stay();
    view_->ask_to_close(now_us);
  }

  bool ended() const { return view_->ended(); }

  const SessionSetting& setting_;
  study::RequestReader requests_{setting_.database};
  InputQueue queue_;
  Window window_;
  Gui gui_;
  GuiRenderer gui_renderer_;
  FigureRenderer renderer_;
  Json machine_;  // before the session, whose time begins after it was measured
  LiveSession live_;
  std::unique_ptr<SessionView> view_;
  std::unique_ptr<Autopilot> autopilot_;
  std::unique_ptr<ExamplesWindow> examples_;
  std::int64_t examples_due_us_ = 0;
  bool interrupted_ = false;
  SecondCopy copy_;  // its thread ends before all else does
};

}  // namespace

SessionResult run_session(const SessionSetting& setting) {
  // A display and fonts first: without them nothing is written.
  const study::Display& display = setting.bundle.study.display;
  require_display(setting.windowed ? 0 : display.screen);
  if (display.examples == study::ExamplesWall::screen && !setting.windowed) {
    another_display(display.screen);
  }
  require_fonts();
  study::Store store(setting.database, setting.bundle);
  if (!setting.trace.empty()) store.trace_to(setting.trace);
  SessionResult result = Player(setting, store).play();
  if (study::running_session(store.database(), store.session()).empty()) {
    study::remove_requests(setting.database);
  }
  // With how it ended, too.
  if (result.recorded) {
    result.copy_problem =
        study::second_copy_problem(setting.bundle, setting.database, setting.station);
  }
  return result;
}

}  // namespace promenade::app
