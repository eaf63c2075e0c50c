#include "study/process.h"

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <iterator>

namespace promenade::study {
namespace {

constexpr int start_field = 22;  // of /proc/PID/stat, counted from 1 (proc(5))

std::string content_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

std::string process_start(std::int64_t process) {
  const std::string stat = content_of("/proc/" + std::to_string(process) + "/stat");
  // The second field, the name, may hold blanks and brackets; it ends at the last one.
  std::size_t at = stat.rfind(')');
  if (at == std::string::npos) return "";
  for (int field = 2; field < start_field && at != std::string::npos; ++field) {
    at = stat.find(' ', at + 1);
  }
  if (at == std::string::npos) return "";
  const std::size_t name_ends = stat.rfind(')');
  const char state = name_ends + 2 < stat.size() ? stat[name_ends + 2] : 'X';
  if (state == 'Z' || state == 'X') return "";  // it has ended, and nobody has asked how
  const std::string boot = content_of("/proc/sys/kernel/random/boot_id");
  return boot.substr(0, boot.find('\n')) + ":" +
         stat.substr(at + 1, stat.find(' ', at + 1) - at - 1);
}

bool lives(std::int64_t process, const std::string& start) {
  if (process <= 0) return false;
  if (!start.empty()) return process_start(process) == start;
  // EPERM is the answer of somebody else's process.
  return ::kill(static_cast<pid_t>(process), 0) == 0 || errno == EPERM;
}

}  // namespace promenade::study
