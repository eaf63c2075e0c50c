#include "app/monitor_card.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/monitor_words.h"

namespace promenade::app {
namespace {

using study::Texts;
using study::WatchedSession;
using study::WatchedState;
using study::WatchedTrial;

float line_of(ImFont* font) { return std::round(1.3f * font->FontSize); }

bool wants_help(const WatchedSession& session) {
  return session.state == WatchedState::interrupted || is_silent(session);
}

// Who and of what kind, on one line; returns where the next begins.
float draw_name(const Ui& ui, const Texts& texts, const WatchedSession& session, const Box& box) {
  const Palette& palette = ui.look.palette;
  const float high = line_of(ui.look.fonts.heading);
  float flag = 0;
  if (session.simulated || session.pilot) {
    const std::string kind = kind_words(texts, session);
    flag = text_width(ui.look.fonts.bold, kind) + ui.layout.size(16);
    const Rgb& ground = session.simulated ? palette.quiet : palette.pilot;
    const Box mark{box.right() - flag, box.y + ui.layout.size(8), flag, ui.layout.size(26)};
    fill(mark, ground);
    draw_text(ui.look.fonts.bold, mark, ink_on(palette, ground), kind, Align::centre);
  }
  const Box name{box.x, box.y, box.width - flag - ui.layout.size(8), high};
  draw_line(ui.look.fonts.heading, name, palette.text, session.participant);
  place(ui, "code", session.uuid, name, false);
  return name.bottom();
}

void draw_notes(const Ui& ui, const WatchedSession& session, const Box& box, float top) {
  const float high = line_of(ui.look.fonts.text);
  const auto room = static_cast<std::size_t>(std::max(0.0f, (box.bottom() - top) / high));
  const std::size_t count = std::min(room, session.notes.size());
  for (std::size_t i = session.notes.size() - count; i < session.notes.size(); ++i, top += high) {
    const study::WatchedNote& note = session.notes[i];
    draw_line(ui.look.fonts.text, {box.x, top, box.width, high}, ui.look.palette.quiet,
              clock_words(note.t_us) + "  " + note.text);
  }
}

// The left part: name, what they do, times, notes.
void draw_words(const Ui& ui, const Texts& texts, const WatchedSession& session,
                const CardLook& look, const Box& box) {
  const Palette& palette = ui.look.palette;
  float y = draw_name(ui, texts, session, box);
  const Rgb& tone = wants_help(session) ? palette.alarm : palette.text;
  ImFont* large = ui.look.fonts.title;
  std::string doing = doing_words(texts, session);
  if (!look.can_resume) doing += advice_words(texts, session);
  const bool fits = text_width(large, doing) <= box.width;
  ImFont* font = fits ? large : ui.look.fonts.reading;
  y += draw_paragraphs(font, box.x, y, box.width, tone, doing);
  const auto line = [&](const Rgb& colour, const std::string& text) {
    const float high = line_of(ui.look.fonts.reading);
    if (text.empty() || y + high > box.bottom()) return;
    draw_line(ui.look.fonts.reading, {box.x, y, box.width, high}, colour, text);
    y += high;
  };
  line(palette.text, trial_words(texts, session));
  line(palette.quiet, time_words(texts, session));
  draw_notes(ui, session, box, y + ui.layout.size(2));
}

struct Axes {
  Box box;
  double most_s = 1, most_d = 1;

  ImVec2 at(double seconds, double d) const {
    return {box.x + static_cast<float>(std::min(1.0, seconds / most_s)) * box.width,
            box.bottom() - static_cast<float>(std::min(1.0, d / most_d)) * box.height};
  }
};

Axes axes_of(const WatchedTrial& trial, const Box& box) {
  Axes axes{box, std::max(10.0, trial.seconds), 0};
  if (trial.limit_s) axes.most_s = std::max(axes.most_s, *trial.limit_s);
  for (const WatchedTrial::Shown& one : trial.shown) axes.most_d = std::max(axes.most_d, one.d);
  axes.most_d = 1.08 * std::max(axes.most_d, 1.5 * trial.threshold_m.value_or(0));
  if (axes.most_d <= 0) axes.most_d = 1;
  return axes;
}

// D stays what it is until the next change; of changes within a pixel the last is drawn.
void draw_curve(const Ui& ui, const WatchedTrial& trial, const Axes& axes) {
  std::vector<ImVec2> points;
  for (const WatchedTrial::Shown& one : trial.shown) {
    const ImVec2 at = axes.at(one.seconds, one.d);
    if (!points.empty() && at.x - points.back().x < 1) {
      points.back().y = at.y;
      continue;
    }
    if (!points.empty()) points.push_back({at.x, points.back().y});
    points.push_back(at);
  }
  if (points.empty()) return;
  points.push_back({axes.at(trial.seconds, 0).x, points.back().y});
  ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()),
                                          packed(ui.look.palette.created), ImDrawFlags_None,
                                          ui.layout.size(3));
}

std::string metres(double length) { return fmt::format("{:.3f}", length); }

void draw_threshold(const Ui& ui, const Texts& texts, double threshold_m, const Axes& axes) {
  const Palette& palette = ui.look.palette;
  const float y = axes.at(0, threshold_m).y;
  fill({axes.box.x, y - ui.layout.size(1), axes.box.width, ui.layout.size(2)}, palette.target);
  const float high = line_of(ui.look.fonts.text);
  draw_text(ui.look.fonts.text, {axes.box.x, y - high, axes.box.width - ui.layout.size(4), high},
            palette.quiet, texts.with("watch.threshold", {{"distance", metres(threshold_m)}}),
            Align::right);
}

void draw_time_axis(const Ui& ui, const Texts& texts, const Axes& axes) {
  const Box line{axes.box.x, axes.box.bottom(), axes.box.width, line_of(ui.look.fonts.text)};
  draw_text(ui.look.fonts.text, line, ui.look.palette.quiet, "0");
  draw_text(
      ui.look.fonts.text, line, ui.look.palette.quiet,
      texts.with("watch.seconds", {{"count", fmt::format("{:.0f}", std::floor(axes.most_s))}}),
      Align::right);
}

// D now in large digits, the best beside it, and beneath how it went.
void draw_distance(const Ui& ui, const Texts& texts, const WatchedSession& session,
                   const Box& box) {
  const Palette& palette = ui.look.palette;
  if (!session.trial) return;
  const WatchedTrial& trial = *session.trial;
  const float head = line_of(ui.look.fonts.heading);
  const Box line{box.x, box.y, box.width, head};
  if (trial.shown.empty()) {
    return draw_text(ui.look.fonts.reading, line, palette.quiet, texts("watch.unmeasured"));
  }
  draw_text(ui.look.fonts.heading, line, palette.created,
            texts.with("watch.distance", {{"distance", metres(trial.shown.back().d)}}));
  if (trial.d_best) {
    draw_text(ui.look.fonts.reading, line, palette.quiet,
              texts.with("watch.best", {{"distance", metres(*trial.d_best)}}), Align::right);
  }
  const float foot = line_of(ui.look.fonts.text);
  const Axes axes =
      axes_of(trial, {box.x, line.bottom(), box.width, box.bottom() - line.bottom() - foot});
  fill(axes.box, palette.panel);
  fill({axes.box.x, axes.box.bottom(), axes.box.width, ui.layout.size(1)}, palette.quiet);
  if (trial.threshold_m) draw_threshold(ui, texts, *trial.threshold_m, axes);
  draw_curve(ui, trial, axes);
  draw_time_axis(ui, texts, axes);
  place(ui, "plot", session.uuid, axes.box, false);
}

void draw_arc(const Ui& ui, const ImVec2& centre, float radius, double share, const Rgb& colour) {
  constexpr float top = -1.5707963f;
  constexpr float whole = 6.2831853f;
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->PathArcTo(centre, radius, top, top + static_cast<float>(share) * whole, 64);
  list->PathStroke(packed(colour), ImDrawFlags_None, ui.layout.size(9));
}

// Within the ring, or beside it where it is too small.
void draw_time(const Ui& ui, const Texts& texts, const WatchedTrial& trial, bool limited,
               const Box& box, bool beside) {
  const Palette& palette = ui.look.palette;
  const float high = line_of(ui.look.fonts.title);
  const Align align = beside ? Align::left : Align::centre;
  draw_text(ui.look.fonts.title, {box.x, box.middle_y() - 0.8f * high, box.width, high},
            palette.text,
            duration_words(texts, limited ? std::ceil(*trial.left_s()) : trial.seconds), align);
  draw_text(ui.look.fonts.text, {box.x, box.middle_y() + 0.1f * high, box.width, high},
            palette.quiet, texts(limited ? "watch.time_left" : "watch.time_so_far"), align);
}

// The time left of the limit; without one the time so far.
void draw_ring(const Ui& ui, const Texts& texts, const WatchedSession& session, const Box& box) {
  const Palette& palette = ui.look.palette;
  const WatchedTrial& trial = *session.trial;
  const float size = std::min(box.width, box.height);
  const bool beside = size < 4.2f * ui.look.fonts.title->FontSize;
  const float wide = beside ? 0.75f * size + ui.layout.size(96) : size;
  const Box ring{box.middle_x() - 0.5f * wide, box.y, size, box.height};
  const float radius = 0.5f * size - ui.layout.size(6);
  const ImVec2 centre{ring.middle_x(), box.middle_y()};
  const bool limited = trial.limit_s && *trial.limit_s > 0;
  draw_arc(ui, centre, radius, 1, palette.track);
  if (limited) draw_arc(ui, centre, radius, *trial.left_s() / *trial.limit_s, palette.created);
  const float right = ring.right() + ui.layout.size(10);
  const Box words = beside ? Box{right, box.y, box.right() - right, box.height} : box;
  draw_time(ui, texts, trial, limited, words, beside);
  place(ui, "ring", session.uuid, box, false);
}

// The right part: the ring, late frames, the last sign of life.
void draw_health(const Ui& ui, const Texts& texts, const WatchedSession& session, const Box& box) {
  const Palette& palette = ui.look.palette;
  const float high = line_of(ui.look.fonts.text);
  const auto line = [&](int from_below, const std::string& text, const Rgb& colour) {
    draw_line(ui.look.fonts.text,
              {box.x, box.bottom() - static_cast<float>(from_below) * high, box.width, high},
              colour, text, Align::centre);
  };
  if (session.trial)
    draw_ring(ui, texts, session, {box.x, box.y, box.width, box.height - 2 * high});
  std::string frames = frames_words(texts, session);
  if (session.trial && session.trial->late_frames > 0) {
    frames = texts.with("watch.late_here", {{"late", std::to_string(session.trial->late_frames)}});
  }
  line(2, frames, palette.quiet);
  line(1, life_words(texts, session), wants_help(session) ? palette.alarm : palette.quiet);
}

// One field for each trial, or one bar where they would be too narrow.
void draw_progress(const Ui& ui, const WatchedSession& session, const Box& box) {
  const Palette& palette = ui.look.palette;
  const int count = std::max(session.trials, 1);
  const int done = std::min(session.trials_done, count);
  const float step = box.width / static_cast<float>(count);
  const float gap = step > ui.layout.size(8) ? ui.layout.size(2) : 0;
  for (int i = 0; i < count; ++i) {
    const bool now = session.trial && session.trial->position == i + 1;
    const Rgb& colour = now ? palette.created : i < done ? palette.example : palette.track;
    fill({box.x + static_cast<float>(i) * step, box.y, step - gap, box.height}, colour);
  }
}

}  // namespace

void draw_session_card(const Ui& ui, const Texts& texts, const WatchedSession& session,
                       const Box& box, const CardLook& look) {
  const Palette& palette = ui.look.palette;
  fill(box, palette.on_colour);
  place(ui, "session", session.uuid, box, false);
  const float inset = ui.layout.size(14);
  const float bar = ui.layout.size(10);
  const Box inner{box.x + inset, box.y + ui.layout.size(8), box.width - 2 * inset,
                  box.height - ui.layout.size(16) - bar};
  const float words = 0.38f * inner.width;
  const float health = 0.19f * inner.width;
  draw_words(ui, texts, session, look, {inner.x, inner.y, words, inner.height});
  draw_distance(ui, texts, session,
                {inner.x + words + 2 * inset, inner.y, inner.width - words - health - 4 * inset,
                 inner.height});
  draw_health(ui, texts, session, {inner.right() - health, inner.y, health, inner.height});
  draw_progress(ui, session, {box.x, box.bottom() - bar, box.width, bar});
  if (look.chosen) frame(box, palette.created, ui.layout.size(3));
  if (wants_help(session)) frame(box, palette.alarm, ui.layout.size(3));
}

}  // namespace promenade::app
