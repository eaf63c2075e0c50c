#include "app/desk/shelf_watch.h"

#include <algorithm>

namespace promenade::app {

void ShelfWatch::look(std::int64_t now_us) {
  constexpr std::int64_t period_us = 1'000'000;
  if (auto found = work_.news()) {
    studies_ = std::move(*found);
    ++number_;
  }
  if (work_.working() || (looked_us_ != INT64_MIN && now_us - looked_us_ < period_us)) return;
  looked_us_ = now_us;
  work_.start([shelf = shelf_](const std::stop_token&) {
    return std::make_shared<const std::vector<study::ShelvedStudy>>(shelf->look());
  });
}

// By another pair of eyes: those of the thread may be in use, and what it finds now is old.
void ShelfWatch::look_now() {
  work_.forget();
  shelf_ = std::make_shared<study::StudyShelf>(shelf_->folder());
  studies_ = std::make_shared<const std::vector<study::ShelvedStudy>>(shelf_->look());
  ++number_;
}

bool ShelfWatch::session_lives() const {
  return std::any_of(studies_->begin(), studies_->end(),
                     [](const study::ShelvedStudy& one) { return one.live > 0; });
}

}  // namespace promenade::app
