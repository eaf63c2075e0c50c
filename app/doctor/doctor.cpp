#include "app/doctor/doctor.h"

#include "app/captions.h"
#include "app/doctor/measure.h"
#include "app/registry.h"
#include "app/session_view.h"
#include "study/embedded.h"
#include "study/load_study.h"

namespace promenade::app {
namespace {

constexpr int commits = 40, quick_commits = 5;
constexpr std::size_t quick_frames = 52;
constexpr const char* caption = "Measuring this machine...";

// The demo as it was built in, whatever lies in configs/ here.
study::StudyBundle demo() {
  return study::read_study("demo.toml", std::string(*study::embedded_file("demo.toml")),
                           interfaces(), study::load_motion_set);
}

std::vector<std::string> words_of_all_languages(const study::StudyBundle& bundle) {
  std::vector<std::string> words;
  for (const std::string& language : study::known_languages()) {
    for (std::string& word : words_of(captions_in(language, bundle))) {
      words.push_back(std::move(word));
    }
  }
  return words;
}

void examine_window(const DoctorOptions& options, const study::StudyBundle& bundle,
                    Findings& findings) {
  InputQueue queue;
  Window window(
      {.title = "promenade doctor", .windowed = options.windowed, .screen = options.screen}, queue);
  Gui gui(make_palette(false), {caption});
  GuiRenderer gui_renderer;
  FigureRenderer renderer;
  gui.fit(window.width(), window.height());
  gui_renderer.upload_fonts();
  findings.display = describe_display(window);
  const double hz = window.refresh_hz() > 0 ? window.refresh_hz() : 60;
  const ScreenTest test{.frames = static_cast<std::size_t>(options.seconds * hz),
                        .longest_s = options.seconds + 1,
                        .caption = caption,
                        .stopped = [&] { return interrupted() || window.closing(); }};
  measure_screen({window, gui, gui_renderer, renderer}, bundle, test, findings);
  if (test.stopped()) throw OutsideError("interrupted before all was measured; start it again");
}

}  // namespace

DoctorReport run_doctor(const DoctorOptions& options) {
  const study::StudyBundle bundle = demo();
  Findings findings{.disk = measure_disk(options.database, commits),
                    .fonts = measure_fonts(words_of_all_languages(bundle)),
                    .clock = measure_clock()};
  try {
    require_display();
  } catch (const OutsideError& error) {
    findings.display.problem = error.what();
  }
  const bool can_draw = findings.display.problem.empty() && findings.fonts.problem.empty();
  if (can_draw) examine_window(options, bundle, findings);
  return judge(findings);
}

DoctorReport quick_doctor(const Canvas& canvas, const study::StudyBundle& bundle,
                          const std::string& database) {
  Findings findings{.display = describe_display(canvas.window),
                    .disk = measure_disk(database, quick_commits),
                    .fonts = measure_font(*canvas.gui.look().fonts.text, shown_words(bundle)),
                    .clock = measure_clock()};
  measure_screen(canvas, bundle, {.frames = quick_frames, .longest_s = 1}, findings);
  return judge(findings);
}

}  // namespace promenade::app
