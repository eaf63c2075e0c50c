// The page on which sessions are watched while they run, and asked to pause, to skip or to repeat.
// It reads the database of the study, and never writes it: what is asked for goes into the file
// beside it (study/control.h).
#pragma once

#include <memory>

#include "app/desk/page.h"
#include "app/desk/watch/chosen_session.h"
#include "app/desk/watch/watch_controls.h"
#include "app/desk/watch/watch_looker.h"

namespace promenade::app {

class WatchPage : public DeskPage {
 public:
  // The file need not be there yet. `on_resume` is to go on with a session whose program died, or
  // whose participant left; empty: that is not offered.
  WatchPage(const std::string& database, WatchControls::Resume on_resume);

  void advance(std::int64_t now_us) override;
  void draw(const Ui& ui, const study::Texts& texts, const Box& room) override;
  bool moves() const override { return looker_.busy() || controls_.waits(); }
  const std::vector<std::string>& shown_words() const override { return words_; }

  // What was seen last; null: nothing yet.
  const study::Watched* seen() const { return now_.get(); }
  const AskedList& asked() const { return controls_.asked(); }

 private:
  void take_news();

  WatchLooker looker_;
  WatchControls controls_;
  std::shared_ptr<const study::Watched> now_;
  std::vector<std::string> words_;
  ChosenSession chosen_;
  std::int64_t now_us_ = 0;
  std::int64_t looked_us_ = -1;  // -1: never
};

}  // namespace promenade::app
