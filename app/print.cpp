#include "app/print.h"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace promenade::app {
namespace {

volatile std::sig_atomic_t interrupt_seen = 0;

// The second one ends the program as usual.
void note_interrupt(int number) {
  interrupt_seen = 1;
  std::signal(number, SIG_DFL);
}

}  // namespace

void print_text(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stdout); }

void print_json(const Json& document) {
  print_text(document.dump(2, ' ', false, nlohmann::detail::error_handler_t::replace) + "\n");
}

void print_note(const std::string& sentence) { fmt::print(stderr, "{}\n", sentence); }

void print_problems(const std::vector<Problem>& problems) {
  for (const Problem& problem : problems) std::fprintf(stderr, "%s\n", to_text(problem).c_str());
}

Json to_json(const Problem& problem) {
  return {{"file", problem.file},
          {"line", problem.line},
          {"column", problem.column},
          {"severity", problem.severity == Severity::error ? "error" : "warning"},
          {"message", problem.message}};
}

Json to_json(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

void show_progress(const std::string& what, int done, int count) {
  static const bool asked = std::getenv("PROMENADE_PROGRESS") != nullptr;
  if (!asked && ::isatty(STDERR_FILENO) == 0) return;
  const char end = asked || done == count ? '\n' : '\r';
  std::fputs(fmt::format("  {} {} of {} {}", what, done, count, end).c_str(), stderr);
  std::fflush(stderr);
}

bool interrupted() {
  static const bool watching = [] {
    std::signal(SIGINT, note_interrupt);
    std::signal(SIGTERM, note_interrupt);
    // Under nohup the terminal may close.
    if (std::signal(SIGHUP, note_interrupt) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
    return true;
  }();
  return watching && interrupt_seen != 0;
}

}  // namespace promenade::app
