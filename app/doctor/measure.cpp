#include "app/doctor/measure.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <set>

#include "app/window/clock.h"
#include "study/sqlite.h"
#include "study/utf8.h"

namespace promenade::app {
namespace {

namespace fs = std::filesystem;

// The nearest folder that is there.
fs::path folder_for(const fs::path& database) {
  std::error_code error;
  fs::path folder = fs::absolute(database, error).parent_path();
  while (!fs::is_directory(folder, error) && folder != folder.parent_path()) {
    folder = folder.parent_path();
  }
  return folder;
}

class ProbeFile {
 public:
  explicit ProbeFile(const fs::path& folder)
      : file_((folder / fmt::format("promenade-doctor-{}.db", getpid())).string()) {}
  ~ProbeFile() {
    std::error_code ignored;
    for (const char* end : {"", "-wal", "-shm"}) fs::remove(file_ + end, ignored);
  }
  ProbeFile(const ProbeFile&) = delete;
  ProbeFile& operator=(const ProbeFile&) = delete;
  const std::string& name() const { return file_; }

 private:
  std::string file_;
};

void time_commits(const std::string& file, int commits, std::vector<std::int64_t>& times_us) {
  study::Database database(file, study::Database::Mode::create);
  database.exec(
      "PRAGMA journal_mode = WAL; PRAGMA wal_autocheckpoint = 0;"
      "PRAGMA synchronous = FULL; CREATE TABLE probe(number INTEGER)");
  study::Statement insert(database, "INSERT INTO probe VALUES (?)");
  for (int k = 0; k < commits; ++k) {
    const std::int64_t before_us = monotonic_us();
    insert.bind(1, k).run();
    times_us.push_back(monotonic_us() - before_us);
  }
}

}  // namespace

DiskFinding measure_disk(const fs::path& database, int commits) {
  const fs::path folder = folder_for(database);
  DiskFinding finding{.folder = folder.string()};
  std::error_code error;
  const fs::space_info space = fs::space(folder, error);
  if (!error) finding.free_bytes = static_cast<std::int64_t>(space.available);
  try {
    const ProbeFile probe(folder);
    time_commits(probe.name(), commits, finding.commit_us);
  } catch (const study::DatabaseError& problem) {
    finding.problem = "nothing can be stored in " + finding.folder + " (" + problem.what() +
                      "); make room, or name another place with --db";
  }
  return finding;
}

FontFinding measure_font(const ImFont& font, const std::vector<std::string>& words) {
  std::set<std::string> missing;
  for (const std::string& word : words) {
    for (std::string_view rest = word; !rest.empty();) {
      const study::Character first = study::first_character(rest);
      const std::size_t bytes = std::min(first.bytes, rest.size());
      const bool drawn = first.code >= ' ' || first.code == 0;
      const auto letter = static_cast<ImWchar>(first.code);
      if (drawn && font.FindGlyphNoFallback(letter) == nullptr) {
        missing.emplace(rest.substr(0, bytes));
      }
      rest.remove_prefix(bytes);
    }
  }
  return {.missing = {missing.begin(), missing.end()}};
}

FontFinding measure_fonts(const std::vector<std::string>& words) {
  try {
    ImFontAtlas atlas;
    return measure_font(*load_fonts(atlas, 1, words).reading, words);
  } catch (const OutsideError& error) {
    return {.problem = error.what()};
  }
}

ClockFinding measure_clock() {
  using Clock = std::chrono::steady_clock;
  ClockFinding finding{.step_ns = INT64_MAX};
  Clock::time_point before = Clock::now();
  const Clock::time_point enough = before + std::chrono::milliseconds(20);
  while (before < enough) {
    const Clock::time_point now = Clock::now();
    const std::int64_t step_ns =
        std::chrono::duration_cast<std::chrono::nanoseconds>(now - before).count();
    finding.ran_back = finding.ran_back || step_ns < 0;
    if (step_ns > 0) finding.step_ns = std::min(finding.step_ns, step_ns);
    before = now;
  }
  std::ifstream file("/sys/devices/system/clocksource/clocksource0/current_clocksource");
  std::getline(file, finding.source);
  return finding;
}

}  // namespace promenade::app
