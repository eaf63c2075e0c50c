#include "analysis/report/gnuplot.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <vector>

#include "motion/files.h"
#include "motion/problem.h"

namespace promenade::analysis {
namespace {

constexpr const char* script_name = "figure.gp";

// What gnuplot is told by spawn before it starts.
class Actions {
 public:
  Actions(const std::filesystem::path& folder, const std::string& message_name) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, message_name.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0600);
  }
  ~Actions() { posix_spawn_file_actions_destroy(&actions_); }
  Actions(const Actions&) = delete;
  Actions& operator=(const Actions&) = delete;
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

// Ctrl-C is ours to hear: gnuplot runs in a process group of its own, and ends its figure.
class OwnGroup {
 public:
  OwnGroup() {
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes_, 0);
  }
  ~OwnGroup() { posix_spawnattr_destroy(&attributes_); }
  OwnGroup(const OwnGroup&) = delete;
  OwnGroup& operator=(const OwnGroup&) = delete;
  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_;
};

// Ours, but for what would change numbers or read the settings of a user.
std::vector<std::string> plain_environment() {
  std::vector<std::string> result = {"LC_ALL=C.UTF-8"};
  for (char** entry = environ; *entry; ++entry) {
    const std::string_view text = *entry;
    const bool ours = text.rfind("LC_", 0) == 0 || text.rfind("LANG", 0) == 0 ||
                      text.rfind("GNUPLOT", 0) == 0 || text.rfind("GDFONTPATH", 0) == 0;
    if (!ours) result.emplace_back(text);
  }
  return result;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

// The exit code; -1 with errno when it could not be started.
int spawn_gnuplot(const std::string& script, const std::filesystem::path& folder,
                  const std::string& message_name) {
  std::vector<std::string> arguments = {"gnuplot", "-d", script};
  std::vector<std::string> environment = plain_environment();
  const Actions actions(folder, message_name);
  const OwnGroup group;
  pid_t process = 0;
  const int error = posix_spawnp(&process, "gnuplot", actions.get(), group.get(),
                                 pointers(arguments).data(), pointers(environment).data());
  if (error != 0) {
    errno = error;
    return -1;
  }
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

}  // namespace

void run_gnuplot(const std::string& script, const std::filesystem::path& folder) {
  write_file(folder / script_name, script);
  run_gnuplot_file(script_name, folder);
  std::error_code ignored;
  std::filesystem::remove(folder / script_name, ignored);
}

void run_gnuplot_file(const std::string& name, const std::filesystem::path& folder) {
  const std::string message_name = name + ".log";
  const int code = spawn_gnuplot(name, folder, message_name);
  const int error = errno;
  if (code < 0 || code == 127) {
    throw OutsideError(std::string("cannot start gnuplot, which draws the figures (") +
                       (code < 0 ? std::strerror(error) : "not found") +
                       "); install the package gnuplot-nox");
  }
  if (code != 0) {
    throw OutsideError("gnuplot could not draw a figure: " + read_file(folder / message_name));
  }
  std::error_code ignored;
  std::filesystem::remove(folder / message_name, ignored);
}

std::string gnuplot_text(std::string_view text) {
  std::string result = "'";
  for (const char letter : text) {
    if (letter == '\'') {
      result += "''";
    } else if (static_cast<unsigned char>(letter) < 0x20) {
      result += ' ';
    } else {
      result += letter;
    }
  }
  return result + "'";
}

std::string without_creation_date(std::string pdf) {
  const std::string key = "/CreationDate (D:";
  const std::size_t found = pdf.find(key);
  if (found == std::string::npos) return pdf;
  const std::string fixed = "20000101000000";  // YYYYMMDDhhmmss
  for (std::size_t i = 0; i < fixed.size() && found + key.size() + i < pdf.size(); ++i) {
    pdf[found + key.size() + i] = fixed[i];
  }
  return pdf;
}

}  // namespace promenade::analysis
