#include "app/monitor_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/monitor_words.h"
#include "app/scroll_area.h"

namespace promenade::app {
namespace {

using study::Watched;
using study::WatchedSession;
using study::WatchedState;

int count_ended(const Watched& now) {
  return static_cast<int>(
      std::count_if(now.sessions.begin(), now.sessions.end(),
                    [](const WatchedSession& one) { return one.state == WatchedState::ended; }));
}

void draw_finished_bar(const Ui& ui, const Watched& now, const Box& box) {
  if (now.planned == 0) return;
  fill(box, ui.look.palette.track);
  const float share =
      std::min(1.0f, static_cast<float>(now.finished) / static_cast<float>(now.planned));
  fill({box.x, box.y, share * box.width, box.height}, ui.look.palette.target);
}

void draw_ended_row(const Ui& ui, const WatchedSession& session, const Box& box) {
  const Palette& palette = ui.look.palette;
  const auto cell = [&](float from, float to, const Rgb& colour, const std::string& text) {
    const float x = box.x + from * box.width;
    draw_line(ui.look.fonts.reading, {x, box.y, (to - from - 0.015f) * box.width, box.height},
              colour, text);
  };
  cell(0, 0.3f, palette.text, session.participant);
  cell(0.3f, 0.42f, palette.quiet, kind_words(session));
  cell(0.42f, 0.54f, palette.text, session.outcome);
  cell(0.54f, 0.7f, palette.quiet, duration_words(session.ended_s) + " ago");
  cell(0.7f, 0.82f, palette.quiet, fmt::format("{} trials", session.trials_done));
  cell(0.82f, 1, palette.quiet, time_words(session));
  place(ui, "ended", session.uuid, box, false);
}

}  // namespace

std::vector<std::string> shown_words(const Watched& now) {
  std::vector<std::string> words = {now.study, now.problem};
  for (const WatchedSession& one : now.sessions) {
    words.insert(words.end(), {one.participant, one.station, trial_words(one)});
    for (const study::WatchedNote& note : one.notes) words.push_back(note.text);
  }
  return words;
}

void MonitorView::frame(Gui& gui, const Watched& now) {
  page_.frame(gui, [&](const Ui& ui) { draw(ui, now); });
}

void MonitorView::draw(const Ui& ui, const Watched& now) {
  draw_head(ui, now);
  const int rows = std::min(count_ended(now), 4);
  const float foot = rows == 0 ? 0 : ui.layout.size(static_cast<float>(30 * rows + 36));
  const Box body = ui.layout.box(16, 84, 1248, 624);
  draw_sessions(ui, now, {body.x, body.y, body.width, body.height - foot});
  if (rows > 0) draw_ended(ui, now, {body.x, body.bottom() - foot, body.width, foot});
}

void MonitorView::draw_head(const Ui& ui, const Watched& now) {
  const Palette& palette = ui.look.palette;
  const Box line = ui.layout.box(16, 8, 1248, 48);
  const std::string finished = finished_words(now);
  const float wide = text_width(ui.look.fonts.title, finished);
  const std::string title = now.study.empty() ? "Promenade" : now.study;
  draw_line(ui.look.fonts.heading,
            {line.x, line.y, line.width - wide - ui.layout.size(24), line.height}, palette.text,
            title);
  draw_text(ui.look.fonts.title, line, palette.text, finished, Align::right);
  draw_finished_bar(ui, now, ui.layout.box(16, 62, 1248, 8));
}

void MonitorView::draw_sessions(const Ui& ui, const Watched& now, const Box& box) {
  const Palette& palette = ui.look.palette;
  float top = box.y;
  if (!now.problem.empty()) {
    top += draw_paragraphs(ui.look.fonts.title, box.x, top, box.width,
                           now.is_input_error ? palette.alarm : palette.text, now.problem);
    top += ui.layout.size(8);
  }
  const int count = static_cast<int>(now.sessions.size()) - count_ended(now);
  if (count == 0 && now.problem.empty()) {
    draw_text(ui.look.fonts.title, box, palette.quiet, "No session runs", Align::centre);
  }
  if (count == 0) return;
  const Box room{box.x, top, box.width, box.bottom() - top};
  const float gap = ui.layout.size(10);
  const float step =
      std::clamp(room.height / static_cast<float>(count), ui.layout.size(170), ui.layout.size(300));
  scrolled("sessions", room, step * static_cast<float>(count), [&](const Box& inner) {
    for (int i = 0; i < count; ++i) {
      const float y = inner.y + static_cast<float>(i) * step;
      draw_session_card(ui, now.sessions[static_cast<std::size_t>(i)],
                        {inner.x, y, inner.width, step - gap});
    }
  });
}

void MonitorView::draw_ended(const Ui& ui, const Watched& now, const Box& box) {
  const float high = ui.layout.size(30);
  const Box head{box.x, box.y, box.width, ui.layout.size(36)};
  draw_text(ui.look.fonts.bold, head, ui.look.palette.quiet, "Ended in the last 12 hours");
  const int count = count_ended(now);
  const std::size_t first = now.sessions.size() - static_cast<std::size_t>(count);
  const Box room{box.x, head.bottom(), box.width, box.bottom() - head.bottom()};
  scrolled("ended", room, high * static_cast<float>(count), [&](const Box& inner) {
    for (int i = 0; i < count; ++i) {
      draw_ended_row(ui, now.sessions[first + static_cast<std::size_t>(i)],
                     {inner.x, inner.y + static_cast<float>(i) * high, inner.width, high});
    }
  });
}

}  // namespace promenade::app
