#include "app/desk/watch/watch_page.h"

#include "app/monitor_view.h"
#include "app/registry.h"

namespace promenade::app {
namespace {

constexpr std::int64_t period_us = 500'000;          // between two looks
constexpr std::int64_t waiting_period_us = 150'000;  // while an answer is waited for

}  // namespace

WatchPage::WatchPage(const std::string& database, WatchControls::Resume on_resume)
    : looker_(database, interfaces()), controls_(database, std::move(on_resume)) {}

void WatchPage::advance(std::int64_t now_us) {
  now_us_ = now_us;
  take_news();
  const std::int64_t period = controls_.waits() ? waiting_period_us : period_us;
  if (looked_us_ >= 0 && now_us - looked_us_ < period) return;
  looked_us_ = now_us;
  looker_.look();
}

void WatchPage::take_news() {
  if (auto news = looker_.news()) {
    now_ = std::move(news);
    words_ = app::shown_words(*now_);
    chosen_.follow(*now_);
  }
  if (now_) controls_.follow(*now_, now_us_);
}

void WatchPage::draw(const Ui& ui, const study::Texts& texts, const Box& room) {
  const float side = ui.layout.size(16);
  if (!now_) {
    return draw_text(ui.look.fonts.title, room, ui.look.palette.quiet, texts("watch.looking"),
                     Align::centre);
  }
  const bool asks = any_is_open(*now_) || !controls_.asked().all().empty();
  const float foot = asks ? WatchControls::height(ui) : 0;
  const float top = room.y + ui.layout.size(8);
  draw_monitor(
      ui, texts, *now_,
      {room.x + side, top, room.width - 2 * side, room.bottom() - foot - ui.layout.size(8) - top},
      &chosen_.uuid());
  if (!asks) return;
  controls_.draw(ui, texts, chosen_.in(*now_), {room.x, room.bottom() - foot, room.width, foot},
                 now_us_);
}

}  // namespace promenade::app
