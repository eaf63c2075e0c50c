#include "app/desk/desk_foot.h"

#include <fmt/format.h>

#include <algorithm>

namespace promenade::app {
namespace {

std::string progress_words(const study::Texts& words, const DeskJob& one) {
  const JobProgress& progress = one.job->progress();
  if (progress.count == 0) return one.name;
  return words.with("shell.progress", {{"name", one.name},
                                       {"done", std::to_string(progress.done)},
                                       {"count", std::to_string(progress.count)}});
}

void draw_bar(const Ui& ui, const JobProgress& progress, const Box& box) {
  fill(box, ui.look.palette.track);
  if (progress.count == 0) return;
  const float share = static_cast<float>(progress.done) / static_cast<float>(progress.count);
  fill({box.x, box.y, std::clamp(share, 0.0f, 1.0f) * box.width, box.height},
       ui.look.palette.created);
}

struct Told {
  std::string words;
  bool bad = false;
};

Told outcome_of(const study::Texts& words, const DeskJob& one) {
  const Job& job = *one.job;
  if (job.exit_code() == 0) return {words.with("shell.done", {{"name", one.name}})};
  if (job.stopped()) return {words.with("shell.stopped", {{"name", one.name}})};
  const std::string why = last_sentence(job.messages());
  if (why.empty()) return {words.with("shell.died", {{"name", one.name}}), true};
  return {one.name + ": " + why, true};
}

void draw_words(const Ui& ui, const Box& box, const Told& told) {
  draw_line(ui.look.fonts.text, box, told.bad ? ui.look.palette.alarm : ui.look.palette.text,
            told.words);
}

}  // namespace

std::string last_sentence(const std::string& messages) {
  std::string_view text = messages;
  while (text.ends_with('\n')) text.remove_suffix(1);
  const std::size_t before = text.rfind('\n');
  if (before != std::string_view::npos) text.remove_prefix(before + 1);
  constexpr std::string_view own = "promenade: ";
  if (text.starts_with(own)) text.remove_prefix(own.size());
  constexpr std::string_view place = ": error: ";  // before it: a path, or an option
  const std::size_t end = text.find(place);
  if (end != std::string_view::npos) text.remove_prefix(end + place.size());
  return std::string(text);
}

void draw_desk_foot(const Ui& ui, const study::Texts& words, DeskJobs& jobs, const Box& bar) {
  const Palette& palette = ui.look.palette;
  fill(bar, palette.panel);
  fill({bar.x, bar.y, bar.width, ui.layout.size(1)}, palette.line);
  const float inset = ui.layout.size(16);
  const float gap = ui.layout.size(6);
  const float wide = ui.layout.size(120);
  const Box end{bar.right() - inset - wide, bar.y + gap, wide, bar.height - 2 * gap};
  const Box line{bar.x + inset, bar.y, end.x - bar.x - 2 * inset, bar.height};
  const DeskJob* const one = jobs.trouble().empty() ? jobs.shown() : nullptr;
  if (one != nullptr && one->kind == JobKind::session && one->job->running()) {
    return draw_words(ui, line, {words.with("shell.session", {{"name", one->name}})});
  }
  if (one != nullptr && one->job->running()) {
    const Box left{line.x, line.y, 0.6f * line.width, line.height};
    draw_words(ui, left, {progress_words(words, *one)});
    const float high = ui.layout.size(8);
    draw_bar(ui, one->job->progress(),
             {left.right() + inset, line.middle_y() - 0.5f * high,
              line.right() - left.right() - inset, high});
    if (button(ui, "job.stop", end, words("shell.stop"), ButtonKind::outlined)) jobs.stop_shown();
    return;
  }
  draw_words(ui, line, one != nullptr ? outcome_of(words, *one) : Told{jobs.trouble(), true});
  if (button(ui, "job.close", end, words("shell.close"), ButtonKind::outlined)) jobs.dismiss();
}

}  // namespace promenade::app
