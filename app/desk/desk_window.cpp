#include "app/desk/desk_window.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>

#include "app/desk/desk.h"
#include "app/desk/words.h"
#include "app/print.h"
#include "app/window/frame_loop.h"
#include "app/window/growing_gui.h"
#include "motion/files.h"
#include "motion/problem.h"

namespace promenade::app {
namespace {

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

// Those that were started to show something and have not ended.
std::vector<pid_t>& openers() {
  static std::vector<pid_t> all;
  return all;
}

void forget_ended_openers() {
  std::erase_if(openers(), [](pid_t one) { return ::waitpid(one, nullptr, WNOHANG) != 0; });
}

// Whoever opens it goes on without the desk, in a group of its own.
void show_with_system(const std::string& path) {
  std::string program = variable("PROMENADE_OPENER");
  if (program.empty()) program = "xdg-open";
  std::string file = path;
  char* words[] = {program.data(), file.data(), nullptr};
  posix_spawn_file_actions_t files{};
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t how{};
  posix_spawnattr_init(&how);
  posix_spawnattr_setflags(&how, POSIX_SPAWN_SETPGROUP);
  pid_t process = 0;
  const int error = ::posix_spawnp(&process, program.c_str(), &files, &how, words, environ);
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&how);
  if (error != 0) throw OutsideError(program + " is not installed; open " + path + " yourself");
  openers().push_back(process);
}

// "KIND TARGET X Y WIDTH HEIGHT", divided by tabs, of all that is in sight.
void write_trace(const std::string& file, const WidgetMap& widgets) {
  std::string text;
  for (std::size_t i = 0; i < widgets.size(); ++i) {
    const Widget& one = widgets[i];
    if (!one.visible()) continue;
    text += fmt::format("{}\t{}\t{}\t{}\t{}\t{}\n", one.kind, one.target, one.box.x, one.box.y,
                        one.box.width, one.box.height);
  }
  write_file(file, text);
}

std::string folder_of(const DeskWindowSetting& setting) {
  const std::string folder = setting.studies.empty() ? default_studies_folder() : setting.studies;
  return std::filesystem::absolute(folder).lexically_normal().string();
}

// Drawn at the pace of the display while something moves or somebody works with it; a few times a
// second else, and while a person takes part at this machine.
class DeskWindow {
 public:
  explicit DeskWindow(const DeskWindowSetting& setting)
      : trace_(setting.trace),
        window_({.title = "Promenade", .windowed = true}, queue_),
        fonts_(make_palette(false), all_desk_words()),
        desk_({.studies = folder_of(setting),
               .language = setting.language,
               .program = "",
               .displays = display_names(),
               .show = show_with_system},
              queue_) {
    queue_.watch([this](const UiEvent& event) { touched_us_ = event.t_us; });
  }

  void work() {
    constexpr std::int64_t calm_period_us = 250'000;
    while (!ended()) {
      run_frames(window_, {.draw_figures = [this](std::int64_t now_us) { draw_figures(now_us); },
                           .draw_screen = [this](std::int64_t) { draw_screen(); },
                           .shown = [](const ShownFrame&) {},
                           .ended = [this] { return ended() || !lively(); }});
      const auto draw = [this](std::int64_t now_us) {
        draw_figures(now_us);
        draw_screen();
      };
      run_slowly(
          window_, draw, [this] { return ended() || lively(); }, calm_period_us);
    }
  }

 private:
  bool ended() {
    if (interrupted()) return true;
    if (!window_.closing()) return false;
    if (desk_.may_close()) return true;
    window_.stay();
    return false;
  }
  bool lively() const {
    constexpr std::int64_t patience_us = 2'000'000;
    return !desk_.quiet() && (desk_.moves() || now_us_ - touched_us_ < patience_us);
  }
  void draw_figures(std::int64_t now_us) {
    now_us_ = now_us;
    forget_ended_openers();
    const std::vector<std::string> dropped = window_.take_dropped();
    if (!dropped.empty()) desk_.dropped(dropped);
    desk_.advance(now_us);
    gui_ = &fonts_.gui_for(desk_.shown_words(), window_);
    renderer_.begin(window_.width(), window_.height(), gui_->look().palette.background);
    desk_.draw_figures(renderer_, *gui_);
  }
  void draw_screen() {
    desk_.frame(*gui_);
    fonts_.renderer().draw();
    if (!trace_.empty()) write_trace(trace_, desk_.widgets());
  }

  std::string trace_;
  InputQueue queue_;
  Window window_;
  GrowingGui fonts_;
  FigureRenderer renderer_;
  Desk desk_;
  Gui* gui_ = nullptr;
  std::int64_t now_us_ = 0, touched_us_ = 0;
};

}  // namespace

std::string default_studies_folder() {
  std::string chosen = variable("PROMENADE_STUDIES");
  if (!chosen.empty()) return chosen;
  const std::string home = variable("HOME");
  return home.empty() ? "Promenade" : home + "/Promenade";
}

std::string language_of_system() {
  for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
    const std::string value = variable(name);
    if (value.empty()) continue;
    for (const std::string& language : desk_languages()) {
      if (value.starts_with(language)) return language;
    }
    return "en";
  }
  return "en";
}

void open_desk(const DeskWindowSetting& setting) {
  require_display();
  require_fonts();
  interrupted();                  // from now on Ctrl-C closes the window properly
  std::signal(SIGCHLD, SIG_DFL);  // whoever started us may not have wanted to know
  DeskWindow(setting).work();
}

}  // namespace promenade::app
