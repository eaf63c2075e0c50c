#include "app/monitor_view.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/desk/words.h"
#include "app/monitor_words.h"
#include "app/scroll_area.h"

namespace promenade::app {
namespace {

using study::Texts;
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

// The study and how far it is; returns where the next begins.
float draw_head(const Ui& ui, const Texts& texts, const Watched& now, const Box& room) {
  const Palette& palette = ui.look.palette;
  const Box line{room.x, room.y, room.width, ui.layout.size(48)};
  const std::string finished = now.study.empty() ? "" : finished_words(texts, now);
  const float wide = text_width(ui.look.fonts.title, finished);
  const std::string title = now.study.empty() ? "Promenade" : now.study;
  draw_line(ui.look.fonts.heading,
            {line.x, line.y, line.width - wide - ui.layout.size(24), line.height}, palette.text,
            title);
  draw_text(ui.look.fonts.title, line, palette.text, finished, Align::right);
  const Box bar{room.x, line.bottom() + ui.layout.size(6), room.width, ui.layout.size(8)};
  draw_finished_bar(ui, now, bar);
  return bar.bottom() + ui.layout.size(14);
}

// Returns where the next begins.
float draw_problem(const Ui& ui, const Texts& texts, const Watched& now, const Box& box) {
  if (now.problem.empty()) return box.y;
  if (now.waits && now.sessions.empty()) {
    draw_text(ui.look.fonts.title, box, ui.look.palette.quiet, texts("watch.waits"), Align::centre);
    return box.bottom();
  }
  const Palette& palette = ui.look.palette;
  const float high =
      draw_paragraphs(ui.look.fonts.title, box.x, box.y, box.width,
                      now.is_input_error ? palette.alarm : palette.text, problem_words(texts, now));
  return box.y + high + ui.layout.size(8);
}

void draw_card(const Ui& ui, const Texts& texts, const WatchedSession& session, const Box& box,
               std::string* chosen) {
  if (chosen == nullptr) return draw_session_card(ui, texts, session, box);
  if (pressed_area(ui, "choose", session.uuid, box)) *chosen = session.uuid;
  draw_session_card(ui, texts, session, box, {session.uuid == *chosen, true});
}

// With the gaps below. The chosen one has room for its notes.
std::vector<float> card_heights(const Ui& ui, const Watched& now, float room, int count,
                                const std::string* chosen) {
  const float each =
      std::clamp(room / static_cast<float>(count), ui.layout.size(170), ui.layout.size(360));
  std::vector<float> heights(static_cast<std::size_t>(count), each);
  for (std::size_t i = 0; i < heights.size() && chosen != nullptr; ++i) {
    if (now.sessions[i].uuid == *chosen) heights[i] = std::max(each, ui.layout.size(250));
  }
  return heights;
}

void draw_sessions(const Ui& ui, const Texts& texts, const Watched& now, const Box& box,
                   std::string* chosen) {
  const float top = draw_problem(ui, texts, now, box);
  const int count = static_cast<int>(now.sessions.size()) - count_ended(now);
  if (count == 0 && now.problem.empty()) {
    draw_text(ui.look.fonts.title, box, ui.look.palette.quiet, texts("watch.nobody"),
              Align::centre);
  }
  if (count == 0) return;
  const Box room{box.x, top, box.width, box.bottom() - top};
  const std::vector<float> heights = card_heights(ui, now, room.height, count, chosen);
  const float high = std::accumulate(heights.begin(), heights.end(), 0.0f);
  scrolled("sessions", room, high, [&](const Box& inner) {
    float y = inner.y;
    for (std::size_t i = 0; i < heights.size(); y += heights[i++]) {
      draw_card(ui, texts, now.sessions[i],
                {inner.x, y, inner.width, heights[i] - ui.layout.size(10)}, chosen);
    }
  });
}

void draw_ended_row(const Ui& ui, const Texts& texts, const WatchedSession& session,
                    const Box& box) {
  const Palette& palette = ui.look.palette;
  const auto cell = [&](float from, float to, const Rgb& colour, const std::string& text) {
    const float x = box.x + from * box.width;
    draw_line(ui.look.fonts.reading, {x, box.y, (to - from - 0.015f) * box.width, box.height},
              colour, text);
  };
  cell(0, 0.3f, palette.text, session.participant);
  cell(0.3f, 0.42f, palette.quiet, kind_words(texts, session));
  cell(0.42f, 0.54f, palette.text, outcome_words(texts, session));
  cell(0.54f, 0.7f, palette.quiet,
       texts.with("watch.ago", {{"time", duration_words(texts, session.ended_s)}}));
  cell(0.7f, 0.82f, palette.quiet,
       texts.with("watch.trials", {{"count", std::to_string(session.trials_done)}}));
  cell(0.82f, 1, palette.quiet, time_words(texts, session));
  place(ui, "ended", session.uuid, box, false);
}

void draw_ended(const Ui& ui, const Texts& texts, const Watched& now, const Box& box) {
  const float high = ui.layout.size(30);
  const Box head{box.x, box.y, box.width, ui.layout.size(36)};
  draw_text(ui.look.fonts.bold, head, ui.look.palette.quiet, texts("watch.ended"));
  const int count = count_ended(now);
  const std::size_t first = now.sessions.size() - static_cast<std::size_t>(count);
  const Box room{box.x, head.bottom(), box.width, box.bottom() - head.bottom()};
  scrolled("ended", room, high * static_cast<float>(count), [&](const Box& inner) {
    for (int i = 0; i < count; ++i) {
      draw_ended_row(ui, texts, now.sessions[first + static_cast<std::size_t>(i)],
                     {inner.x, inner.y + static_cast<float>(i) * high, inner.width, high});
    }
  });
}

// The cards come first: those who ended give way to them.
float ended_height(const Ui& ui, const Watched& now, float room) {
  const int rows = std::min(count_ended(now), room < ui.layout.size(500) ? 2 : 4);
  return rows == 0 ? 0 : ui.layout.size(static_cast<float>(30 * rows + 36));
}

}  // namespace

std::vector<std::string> shown_words(const Watched& now) {
  std::vector<std::string> words = {now.study, now.problem};
  for (const WatchedSession& one : now.sessions) {
    words.insert(words.end(), {one.participant, one.station});
    if (one.trial) {
      words.insert(words.end(), {one.trial->task, one.trial->interface, one.trial->target});
    }
    for (const study::WatchedNote& note : one.notes) words.push_back(note.text);
  }
  return words;
}

void draw_monitor(const Ui& ui, const Texts& texts, const Watched& now, const Box& room,
                  std::string* chosen) {
  const float top = draw_head(ui, texts, now, room);
  const float foot = ended_height(ui, now, room.height);
  draw_sessions(ui, texts, now, {room.x, top, room.width, room.bottom() - foot - top}, chosen);
  if (foot > 0) draw_ended(ui, texts, now, {room.x, room.bottom() - foot, room.width, foot});
}

MonitorView::MonitorView(InputQueue& queue) : texts_(desk_texts("en")), page_(queue) {}

void MonitorView::frame(Gui& gui, const Watched& now) {
  page_.frame(
      gui, [&](const Ui& ui) { draw_monitor(ui, texts_, now, ui.layout.box(16, 8, 1248, 700)); });
}

}  // namespace promenade::app
