// The buttons under the sessions that are watched: what can be asked of the chosen one, the line in
// which a reason is written, and what became of what was asked.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/desk/watch/asked.h"
#include "app/text_box.h"

namespace promenade::app {

class WatchControls {
 public:
  using Resume = std::function<void(const study::WatchedSession&)>;
  // `on_resume`: goes on with a session that was interrupted or left; empty: nobody can.
  WatchControls(std::string database, Resume on_resume);

  // `now_us`: of the frame, for both.
  void follow(const study::Watched& now, std::int64_t now_us);
  // `session`: the chosen one; null: none is.
  void draw(const Ui& ui, const study::Texts& texts, const study::WatchedSession* session,
            const Box& box, std::int64_t now_us);
  static float height(const Ui& ui);
  bool waits() const { return asked_.waits(); }
  const AskedList& asked() const { return asked_; }

 private:
  // What is being written: why something is asked for, or a note.
  struct Writing {
    const Order* order = nullptr;
    std::string session;  // uuid
    Draft draft;
    bool begins = true;    // the keyboard is to write in it
    bool missing = false;  // it was to be sent without words
  };

  void draw_buttons(const Ui& ui, const study::Texts& texts, const study::WatchedSession& session,
                    const Box& row);
  void draw_resume(const Ui& ui, const study::Texts& texts, const study::WatchedSession& session,
                   const Box& row);
  void draw_writing(const Ui& ui, const study::Texts& texts, const study::WatchedSession& session,
                    const Box& box);
  void draw_line_to_write(const Ui& ui, const study::Texts& texts,
                          const study::WatchedSession& session, const Box& row);
  void draw_asked(const Ui& ui, const study::Texts& texts, const Box& box) const;
  void press(const Ui& ui, const Order& order, const study::WatchedSession& session);
  void send(const Ui& ui, const study::WatchedSession& session);
  void put_away(const Ui& ui);
  void ask(const Order& order, const study::WatchedSession& session, const std::string& words);

  AskedList asked_;
  Resume on_resume_;
  std::optional<Writing> writing_;
  std::string trouble_;  // why nothing can be asked
  std::string resumed_;  // uuid of the session that is being gone on with
  std::int64_t now_us_ = 0, resumed_us_ = 0;
};

}  // namespace promenade::app
