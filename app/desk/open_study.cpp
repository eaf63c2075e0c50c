#include "app/desk/open_study.h"

#include <filesystem>

#include "app/registry.h"
#include "motion/problem.h"
#include "study/migrate.h"
#include "study/versions.h"

namespace promenade::app {
namespace {

void compare_with_sessions(const study::StudyPlace& place, StudyReading& reading) {
  if (!reading.bundle || !study::is_there(place.sessions())) return;
  study::Database database = study::open_log(place.sessions());
  const auto versions = study::study_versions(database);
  if (versions.empty()) return;
  reading.amendment_due = versions.back().sha256 != reading.bundle->sha256;
  study::Statement counts(database, "SELECT count(*) FROM session WHERE NOT pilot");
  counts.step();
  reading.only_pilots = counts.integer(0) == 0;
}

void read_study_file(const study::StudyPlace& place, StudyReading& reading) {
  try {
    reading.bundle =
        std::make_shared<const study::StudyBundle>(study::load_study(place.file(), interfaces()));
    reading.problems = reading.bundle->warnings;
  } catch (const InputError& error) {
    reading.problems = error.problems();
  } catch (const std::exception& error) {
    reading.problems = {{.file = place.file(), .message = error.what()}};
  }
}

// `before`: of the same files, when only the sessions are others; null: it is all new.
std::shared_ptr<const StudyReading> read_place(const study::StudyPlace& place,
                                               const std::shared_ptr<const StudyReading>& before) {
  auto reading = std::make_shared<StudyReading>();
  if (before) {
    reading->bundle = before->bundle;
    reading->problems = before->problems;
  } else {
    read_study_file(place, *reading);
  }
  try {
    compare_with_sessions(place, *reading);
  } catch (const InputError& error) {
    reading->database_problem = to_text(error.problems().front());
  } catch (const std::exception& error) {
    reading->database_problem = error.what();
  }
  return reading;
}

}  // namespace

void OpenStudy::look(std::int64_t now_us) {
  constexpr std::int64_t period_us = 500'000;
  if (auto news = work_.news()) {
    reading_ = std::move(*news);
    ++number_;
  }
  if (looked_us_ != INT64_MIN && now_us - looked_us_ < period_us) return;
  if (work_.working()) return;
  looked_us_ = now_us;
  auto files = study::stamps_of_files(place_);
  const study::DatabaseStamp sessions = study::database_stamp(place_.sessions());
  if (files == files_ && sessions == sessions_) return;
  const auto before = files == files_ ? reading_ : nullptr;
  files_ = std::move(files);
  sessions_ = sessions;
  work_.start(
      [place = place_, before](const std::stop_token&) { return read_place(place, before); });
}

}  // namespace promenade::app
