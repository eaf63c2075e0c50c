// The studies as they are now, looked at once a second in a thread: databases are opened there.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/desk/newest_work.h"
#include "study/study_shelf.h"

namespace promenade::app {

class ShelfWatch {
 public:
  explicit ShelfWatch(const std::filesystem::path& folder)
      : shelf_(std::make_shared<study::StudyShelf>(folder)) {}

  void look(std::int64_t now_us);
  // Waits for it: something was done to the studies just now.
  void look_now();
  const std::vector<study::ShelvedStudy>& studies() const { return *studies_; }
  int number() const { return number_; }  // grows with every look
  // Does a session of any study run on this machine, whoever started it?
  bool session_lives() const;

 private:
  using Found = std::shared_ptr<const std::vector<study::ShelvedStudy>>;

  std::shared_ptr<study::StudyShelf> shelf_;  // of the thread
  Found studies_ = std::make_shared<const std::vector<study::ShelvedStudy>>();
  int number_ = 0;
  std::int64_t looked_us_ = INT64_MIN;
  NewestWork<Found> work_;
};

}  // namespace promenade::app
