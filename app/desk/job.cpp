#include "app/desk/job.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <utility>

#include "motion/problem.h"

namespace promenade::app {
namespace {

// In memory, and gone with the last who has it open.
int nameless_file(const char* name) {
  const int file = ::memfd_create(name, MFD_CLOEXEC);
  if (file < 0) throw OutsideError("no room for what a command prints; close other programs");
  return file;
}

std::string read_from(int file, std::size_t begin) {
  std::string text;
  std::array<char, 65536> part{};
  while (true) {
    const ssize_t count =
        ::pread(file, part.data(), part.size(), static_cast<off_t>(begin + text.size()));
    if (count <= 0) return text;
    text.append(part.data(), static_cast<std::size_t>(count));
  }
}

std::vector<std::string> environment() {
  std::vector<std::string> all;
  for (char** one = environ; *one != nullptr; ++one) all.emplace_back(*one);
  all.emplace_back("PROMENADE_PROGRESS=lines");
  return all;
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> all;
  for (std::string& word : words) all.push_back(word.data());
  all.push_back(nullptr);
  return all;
}

// "  simulated 12 of 40 ": nothing when the line is no progress.
std::optional<JobProgress> progress_in(std::string_view line) {
  if (!line.starts_with("  ")) return std::nullopt;
  while (line.ends_with(' ')) line.remove_suffix(1);
  const std::size_t of = line.rfind(" of ");
  if (of == std::string_view::npos) return std::nullopt;
  const std::size_t before = line.rfind(' ', of - 1);
  if (before == std::string_view::npos || before < 2) return std::nullopt;
  JobProgress progress{std::string(line.substr(2, before - 2))};
  const auto number = [](std::string_view text, int& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
  };
  const bool numbers = number(line.substr(before + 1, of - before - 1), progress.done) &&
                       number(line.substr(of + 4), progress.count);
  return numbers ? std::optional(progress) : std::nullopt;
}

// In a group of its own: Ctrl-C in the desk's terminal is not for a participant's session.
pid_t start(const std::string& program, std::vector<std::string> words, int output, int messages) {
  posix_spawn_file_actions_t files{};
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, messages, STDERR_FILENO);
  posix_spawnattr_t how{};
  posix_spawnattr_init(&how);
  posix_spawnattr_setflags(&how, POSIX_SPAWN_SETPGROUP);
  words.insert(words.begin(), program);
  std::vector<std::string> variables = environment();
  pid_t process = 0;
  const int error = ::posix_spawn(&process, program.c_str(), &files, &how, pointers(words).data(),
                                  pointers(variables).data());
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&how);
  if (error == 0) return process;
  throw OutsideError("cannot start " + program + ": " + std::strerror(error));
}

}  // namespace

std::string own_program() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

Job::Job(const std::string& program, const std::vector<std::string>& arguments)
    : output_file_(nameless_file("output")), message_file_(nameless_file("messages")) {
  try {
    process_ = start(program, arguments, output_file_, message_file_);
  } catch (...) {
    ::close(output_file_);
    ::close(message_file_);
    throw;
  }
}

Job::~Job() {
  ::close(output_file_);
  ::close(message_file_);
}

void Job::look() {
  if (!running()) return;
  int status = 0;
  const pid_t ended = ::waitpid(process_, &status, WNOHANG);
  const bool unknown = ended < 0 && errno == ECHILD;  // somebody else has waited for it
  const bool over = ended == process_ || unknown;
  read_output();
  read_messages();
  if (!over) return;
  exit_code_ = unknown ? 1 : WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  messages_ += std::exchange(unfinished_line_, {});
}

void Job::read_output() { output_ += read_from(output_file_, output_.size()); }

void Job::read_messages() {
  const std::string news = read_from(message_file_, messages_read_);
  messages_read_ += news.size();
  unfinished_line_ += news;
  for (std::size_t end = 0; (end = unfinished_line_.find('\n')) != std::string::npos;) {
    const std::string line = unfinished_line_.substr(0, end);
    unfinished_line_.erase(0, end + 1);
    if (const auto progress = progress_in(line)) {
      progress_ = *progress;
    } else {
      messages_ += line + "\n";
    }
  }
}

void Job::stop() {
  if (!running()) return;
  ::kill(-process_, ++stops_ == 1 ? SIGINT : SIGTERM);
}

}  // namespace promenade::app
