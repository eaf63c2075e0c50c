// A study that is open at the desk: read in a thread, and again when its file or its sessions
// change.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/desk/newest_work.h"
#include "study/study.h"
#include "study/study_shelf.h"

namespace promenade::app {

// What reading it came to.
struct StudyReading {
  std::shared_ptr<const study::StudyBundle> bundle;  // null: it cannot be run
  std::vector<Problem> problems;                     // errors, or the warnings of the bundle
  // Sessions were made with another state of the study: it must be amended before the next.
  bool amendment_due = false;
  bool only_pilots = false;      // of these sessions
  std::string database_problem;  // why the sessions cannot be read; empty: they can
};

class OpenStudy {
 public:
  explicit OpenStudy(study::StudyPlace place) : place_(std::move(place)) {}

  const study::StudyPlace& place() const { return place_; }
  // Looks at the files twice a second, and reads what has changed; never waits.
  void look(std::int64_t now_us);
  // As it was read last; null: it is read for the first time.
  const StudyReading* reading() const { return reading_.get(); }
  std::shared_ptr<const study::StudyBundle> bundle() const {
    return reading_ ? reading_->bundle : nullptr;
  }
  bool working() const { return work_.working(); }
  // Grows with every reading, for those who make something of it.
  int number() const { return number_; }

 private:
  study::StudyPlace place_;
  std::map<std::string, study::FileStamp> files_;  // when they were read
  study::DatabaseStamp sessions_;
  std::int64_t looked_us_ = INT64_MIN;
  std::shared_ptr<const StudyReading> reading_;
  int number_ = 0;
  NewestWork<std::shared_ptr<const StudyReading>> work_;
};

}  // namespace promenade::app
