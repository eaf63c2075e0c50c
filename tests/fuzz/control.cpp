// Any bytes as what a watcher asked for: lines one by one, and as a file that grows while a
// session reads it. What is read is written again as it was.
#include "study/control.h"

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace {

using namespace promenade::study;

constexpr const char* now = "2026-11-22T16:00:10Z";

void read_lines(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (const auto request = read_request(text.substr(0, end))) {
      const std::string line = line_of(*request);
      const auto again = read_request(std::string_view(line).substr(0, line.size() - 1));
      if (!again || line_of(*again) != line) std::abort();
      action_of(*request);
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

// In two parts, so that lines are cut anywhere.
void read_file(std::string_view text) {
  static const std::string database =
      (std::filesystem::temp_directory_path() / ("fuzz_control_" + std::to_string(::getpid())))
          .string();
  remove_requests(database);
  RequestReader reader(database);
  std::size_t asked = 0;
  for (const std::string_view part :
       {text.substr(0, text.size() / 2), text.substr(text.size() / 2), std::string_view("\n")}) {
    std::ofstream(requests_file(database), std::ios::app | std::ios::binary) << part;
    for (int k = 0; k < 3; ++k) asked += reader.take("ours", now).asked.size();
  }
  if (asked > text.size()) std::abort();
  remove_requests(database);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  read_lines(text);
  read_file(text);
  return 0;
}
