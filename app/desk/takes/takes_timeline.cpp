#include "app/desk/takes/takes_timeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace promenade::app {
namespace {

constexpr double most_seconds = 12;  // that are seen at first

float to_pixels(double value) { return static_cast<float>(value); }

// Slanted lines over a part of the picture.
void hatch(const Ui& ui, const Box& box, const Rgb& colour) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float step = ui.layout.size(8);
  ImGui::PushClipRect({box.x, box.y}, {box.right(), box.bottom()}, true);
  const int lines = static_cast<int>((box.width + box.height) / step) + 1;
  for (int k = 0; k < lines; ++k) {
    const float x = box.x - box.height + static_cast<float>(k) * step;
    list->AddLine({x, box.bottom()}, {x + box.height, box.y}, packed(colour), ui.layout.size(1));
  }
  ImGui::PopClipRect();
}

bool same_loop(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return std::abs(x - y) < 0.02; });
}

std::string millimetres(double metres) { return std::to_string(std::lround(1000 * metres)); }

std::string seam_says(const motion::LoopReview& loop, const study::Texts& words) {
  return words.with("takes.seam", {{"mm", millimetres(loop.seam_m)}});
}

std::string slide_says(const motion::LoopReview& loop, const study::Texts& words) {
  return words.with("takes.slide", {{"mm", millimetres(loop.slide_m)}});
}

}  // namespace

std::string loop_says(const motion::LoopReview& loop, const study::Texts& words) {
  return words.with("takes.seam_slide",
                    {{"seam", seam_says(loop, words)}, {"slide", slide_says(loop, words)}});
}

// Where everything is: pixels.
struct TakesTimeline::Rows {
  Box ruler, left, right, loops, overview;  // without their labels
  Box all;                                  // from the ruler to the loops
  Shown shown;
  double frame_time = 1;
  int frames = 1;

  float x(double frame) const {
    return all.x + to_pixels((frame - shown.from) / (shown.to - shown.from)) * all.width;
  }
  Box between(const Box& row, double from, double to) const {
    const float a = std::clamp(x(from), row.x, row.right());
    const float b = std::clamp(x(to), row.x, row.right());
    return {std::round(a), row.y, std::max(std::round(b) - std::round(a), 1.0f), row.height};
  }
  bool sees(double from, double to) const { return to >= shown.from && from <= shown.to; }
  double frames_per_pixel() const { return (shown.to - shown.from) / all.width; }
};

// A take is seen as a whole, a long one around its chosen loop.
void TakesTimeline::follow(const motion::TakeReview& review) {
  if (&review == review_) return;
  review_ = &review;
  const double last = std::max(review.take.frames() - 1, 1);
  const double most = most_seconds / review.take.frame_time;
  shown_ = {0, last};
  if (last <= most) return;
  const std::optional<study::WalkPlace> walk = work_.walk();
  const double middle = walk ? work_.shop().order_of(*walk).keys.front() : 0;
  shown_.from = std::clamp(middle - most / 2, 0.0, last - most);
  shown_.to = shown_.from + most;
}

// By the wheel about the pointer, by keys about the middle.
void TakesTimeline::zoom(const Ui& ui, const Box& box) {
  const ImGuiIO& io = ImGui::GetIO();
  float notches = box.holds(io.MousePos.x, io.MousePos.y) ? io.MouseWheel : 0;
  const bool by_key = ui.focus.on_kind("edge") || ui.focus.on_kind("slide");
  if (by_key && key_pressed(ImGuiKey_PageUp)) notches += 1;
  if (by_key && key_pressed(ImGuiKey_PageDown)) notches -= 1;
  if (notches == 0) return;
  const double last = std::max(review_->take.frames() - 1, 1);
  const bool pointed = io.MouseWheel != 0;
  const double share = pointed ? (io.MousePos.x - box.x) / box.width : 0.5;
  const double at = shown_.from + share * (shown_.to - shown_.from);
  const double wide = std::clamp((shown_.to - shown_.from) * std::pow(0.8, notches), 10.0, last);
  shown_.from = std::clamp(at - share * wide, 0.0, std::max(last - wide, 0.0));
  shown_.to = std::min(shown_.from + wide, last);
}

void TakesTimeline::draw(const Ui& ui, const study::Texts& words, const Box& box) {
  const Palette& palette = ui.look.palette;
  fill(box, palette.panel);
  const std::optional<std::size_t> now = work_.take();
  const auto review = now ? work_.shop().review(*now) : nullptr;
  if (!review) return;
  follow(*review);
  const float label = ui.layout.size(76), in = ui.layout.size(12);
  Rows rows;
  Box line{box.x + label, box.y + ui.layout.size(4), box.width - label - in, 0};
  const auto take = [&](float height, float gap) {
    Box row = line;
    row.height = ui.layout.size(height);
    line.y += row.height + ui.layout.size(gap);
    return row;
  };
  rows.ruler = take(26, 2);
  rows.left = take(22, 4);
  rows.right = take(22, 8);
  rows.loops = take(42, 10);
  rows.overview = take(12, 0);
  rows.all = {rows.ruler.x, rows.ruler.y, rows.ruler.width, rows.loops.bottom() - rows.ruler.y};
  rows.frames = review->take.frames();
  rows.frame_time = review->take.frame_time;
  zoom(ui, rows.all);
  rows.shown = shown_;
  const auto name = [&](const Box& row, const char* key) {
    draw_line(ui.look.fonts.text, {box.x + in, row.y, label - in, row.height}, palette.quiet,
              words(key));
  };
  name(rows.left, "takes.left_foot");
  name(rows.right, "takes.right_foot");
  name(rows.loops, "takes.row_loops");
  draw_rows(ui, words, rows);
  draw_loops(ui, words, rows);
  draw_ruler(ui, rows);
  draw_overview(ui, rows);
}

void TakesTimeline::draw_rows(const Ui& ui, const study::Texts& words, const Rows& rows) const {
  const Palette& palette = ui.look.palette;
  const Box ground{rows.all.x, rows.left.y - ui.layout.size(2), rows.all.width,
                   rows.right.bottom() - rows.left.y + ui.layout.size(4)};
  fill(ground, palette.on_colour);
  fill({rows.loops.x, rows.loops.y, rows.loops.width, rows.loops.height}, palette.on_colour);
  const auto stretches = [&](const std::vector<motion::FrameRange>& list) {
    for (const motion::FrameRange& one : list) {
      if (!rows.sees(one.first, one.last)) continue;
      const Box part = rows.between(ground, one.first, one.last + 1);
      fill(part, palette.hover);
      hatch(ui, part, palette.example);
    }
  };
  stretches(review_->stretches.standing);
  stretches(review_->stretches.turning);
  const auto steps = [&](const std::vector<motion::Stance>& list, const Box& row) {
    for (const motion::Stance& stance : list) {
      if (rows.sees(stance.on, stance.off)) {
        fill(rows.between(row, stance.on, stance.off), palette.quiet);
      }
    }
  };
  steps(review_->contacts.left, rows.left);
  steps(review_->contacts.right, rows.right);
  // On a plate, so that it is read over the steps.
  const auto say = [&](const std::vector<motion::FrameRange>& list, const char* key) {
    const float wide = text_width(ui.look.fonts.text, words(key)) + ui.layout.size(12);
    for (const motion::FrameRange& one : list) {
      if (!rows.sees(one.first, one.last)) continue;
      const Box part = rows.between(ground, one.first, one.last + 1);
      if (wide + ui.layout.size(4) > part.width) continue;
      const Box plate{std::round(part.middle_x() - wide / 2),
                      std::round(part.middle_y() - ui.layout.size(11)), wide, ui.layout.size(22)};
      fill(plate, palette.panel);
      draw_text(ui.look.fonts.text, plate, palette.text, words(key), Align::centre);
    }
  };
  say(review_->stretches.standing, "takes.stands");
  say(review_->stretches.turning, "takes.turns");
  for (const motion::FrameRange& gap : review_->gaps) {
    if (rows.sees(gap.first, gap.last)) {
      fill(rows.between(ground, gap.first, gap.last + 1), palette.alarm);
    }
  }
}

void TakesTimeline::draw_ruler(const Ui& ui, const Rows& rows) {
  const Palette& palette = ui.look.palette;
  const double seconds = (rows.shown.to - rows.shown.from) * rows.frame_time;
  const double steps[] = {0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 60};
  double step = steps[0];
  for (const double one : steps) {
    step = one;
    if (seconds / one <= 10) break;
  }
  const double first = std::ceil(rows.shown.from * rows.frame_time / step);
  const double last = std::floor(rows.shown.to * rows.frame_time / step + 1e-9);
  for (int k = 0; k <= static_cast<int>(last - first); ++k) {
    const double at = (first + k) * step;
    const float x = std::round(rows.x(at / rows.frame_time));
    fill({x, rows.ruler.bottom() - ui.layout.size(5), ui.layout.size(1), ui.layout.size(5)},
         palette.quiet);
    const std::string text = step < 1 ? fmt::format("{:.1f} s", at) : fmt::format("{:.0f} s", at);
    const float half = ui.layout.size(30);
    if (x - half < rows.ruler.x || x + half > rows.ruler.right()) continue;
    draw_text(ui.look.fonts.text, {x - half, rows.ruler.y, 2 * half, ui.layout.size(20)},
              palette.quiet, text, Align::centre);
  }
  const double wide = rows.shown.to - rows.shown.from;
  const double share = std::clamp((work_.frame() - rows.shown.from) / wide, 0.0, 1.0);
  if (const auto to = drag_bar(ui, "slide", "time", rows.ruler, share)) {
    work_.scrub(rows.shown.from + *to * wide);
  }
  if (!rows.sees(work_.frame(), work_.frame())) return;
  const float x = std::round(rows.x(work_.frame()));
  const float thick = ui.layout.size(2);
  const float top = rows.ruler.bottom() - ui.layout.size(7);
  fill({x - thick / 2, top, thick, rows.right.bottom() - top}, palette.text);
}

std::vector<std::vector<double>> TakesTimeline::loops_in_time() const {
  std::vector<std::vector<double>> loops;
  for (const motion::CycleCandidate& one : review_->search.candidates) loops.push_back(one.keys);
  std::sort(loops.begin(), loops.end());
  return loops;
}

void TakesTimeline::draw_loops(const Ui& ui, const study::Texts& words, const Rows& rows) {
  const Palette& palette = ui.look.palette;
  const Rgb line = 0.5f * (palette.known + palette.example);
  const std::vector<std::vector<double>> loops = loops_in_time();
  const bool chosen = work_.walk().has_value();
  // Before the loops, which lie below the ends.
  const Edge first = chosen ? touch_edge(ui, rows, false) : Edge{};
  const Edge last = chosen ? touch_edge(ui, rows, true) : Edge{};
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const std::vector<double>& keys = loops[k];
    if (!rows.sees(keys.front(), keys.back())) continue;
    Box band = rows.between(rows.loops, keys.front(), keys.back());
    band = {band.x + 1, band.y, std::max(band.width - 2, 1.0f), band.height};
    fill(band, palette.known);
    frame(band, line, ui.layout.size(1));
    if (pressed_area(ui, "loop", std::to_string(k), band, false)) choose(keys);
  }
  choose_by_key(ui, loops);
  draw_chosen(ui, words, rows);
  if (first.seen) draw_edge(ui, rows, false, first.hot);
  if (last.seen) draw_edge(ui, rows, true, last.hot);
}

// In the place of the chosen loop, unless another walk of the take has it.
void TakesTimeline::choose(const std::vector<double>& keys) {
  const std::optional<study::WalkPlace> walk = work_.walk();
  if (!walk) return;
  study::Workshop& shop = work_.shop();
  for (std::size_t c = 0; c < shop.takes()[walk->take].source.cycles.size(); ++c) {
    if (same_loop(shop.order_of({walk->take, c}).keys, keys)) return work_.look_at(walk->take, c);
  }
  shop.choose_loop(*walk, keys);
  work_.look_at(walk->take, walk->cycle);
}

// Whoever has an end in hand goes to the loop before or after with the arrows up and down.
void TakesTimeline::choose_by_key(const Ui& ui, const std::vector<std::vector<double>>& loops) {
  const std::optional<study::WalkPlace> walk = work_.walk();
  if (!walk || !ui.focus.on_kind("edge")) return;
  const double now = work_.shop().order_of(*walk).keys.front();
  constexpr double same = 0.02;
  if (key_pressed(ImGuiKey_DownArrow)) {
    for (const std::vector<double>& keys : loops) {
      if (keys.front() > now + same) return choose(keys);
    }
  } else if (key_pressed(ImGuiKey_UpArrow)) {
    for (std::size_t k = loops.size(); k-- > 0;) {
      if (loops[k].front() < now - same) return choose(loops[k]);
    }
  }
}

// Within the loop, on one line or on two; beside it where it is too short for them.
void TakesTimeline::draw_numbers(const Ui& ui, const study::Texts& words, const Rows& rows,
                                 const Box& band, const motion::LoopReview& loop) {
  const Palette& palette = ui.look.palette;
  const std::string seam = seam_says(loop, words), slide = slide_says(loop, words);
  const std::string both = loop_says(loop, words);
  const auto wide = [&](const std::string& text) {
    return text_width(ui.look.fonts.bold, text) + ui.layout.size(12);
  };
  if (wide(both) < band.width) {
    return draw_text(ui.look.fonts.bold, band, palette.on_colour, both, Align::centre);
  }
  Box box = band;
  box.width = std::round(std::max(wide(seam), wide(slide)));
  const bool within = box.width <= band.width;
  if (within) {
    box.width = band.width;
  } else {
    const float gap = ui.layout.size(6);
    const bool right = band.right() + gap + box.width <= rows.loops.right();
    box.x = right ? band.right() + gap : band.x - gap - box.width;
    fill(box, palette.on_colour);
  }
  const Rgb& ink = within ? palette.on_colour : palette.created;
  const float half = std::round(box.height / 2), near = ui.layout.size(1);
  draw_text(ui.look.fonts.bold, {box.x, box.y + near, box.width, half}, ink, seam, Align::centre);
  draw_text(ui.look.fonts.bold, {box.x, box.y + half - near, box.width, half}, ink, slide,
            Align::centre);
}

void TakesTimeline::draw_chosen(const Ui& ui, const study::Texts& words, const Rows& rows) {
  const std::optional<study::WalkPlace> walk = work_.walk();
  if (!walk) return;
  const Palette& palette = ui.look.palette;
  const std::size_t count = work_.shop().takes()[walk->take].source.cycles.size();
  for (std::size_t c = 0; c < count; ++c) {
    const std::vector<double> keys = work_.shop().order_of({walk->take, c}).keys;
    if (!rows.sees(keys.front(), keys.back())) continue;
    const Box band = rows.between(rows.loops, keys.front(), keys.back());
    const bool mine = c == walk->cycle;
    fill(band, mine ? palette.created : palette.example);
    const auto loop = work_.loop({walk->take, c});
    if (!loop) continue;
    if (mine) draw_numbers(ui, words, rows, band, *loop);
  }
}

// Where an end of the chosen loop can be taken; drawn later, over the loops.
TakesTimeline::Edge TakesTimeline::touch_edge(const Ui& ui, const Rows& rows, bool last) {
  const study::WalkPlace walk = *work_.walk();
  const std::vector<double> keys = work_.shop().order_of(walk).keys;
  const double at = last ? keys.back() : keys.front();
  if (!rows.sees(at, at)) return {};
  const float half = ui.layout.size(8), over = ui.layout.size(4);
  const Box grip{std::round(rows.x(at)) - half, rows.loops.y - over, 2 * half,
                 rows.loops.height + 2 * over};
  const auto scale = to_pixels(1 / rows.frames_per_pixel());
  const PlaneTouch touch =
      plane(ui, "edge", last ? "last" : "first", grip, {rows.x(0), grip.middle_y()}, {scale, 1});
  const double hand =
      rows.shown.from + (ImGui::GetIO().MousePos.x - rows.all.x) * rows.frames_per_pixel();
  if (touch.pressed) {
    grip_ = at - hand;
    gesture_ = work_.new_gesture();
  } else if (touch.held && touch.moved.x() != 0) {
    work_.shop().move_end(walk, last, hand + grip_, gesture_);
  } else if (touch.focused && !touch.held) {
    const int by =
        (key_pressed(ImGuiKey_RightArrow) ? 1 : 0) - (key_pressed(ImGuiKey_LeftArrow) ? 1 : 0);
    if (by != 0) work_.shop().move_end(walk, last, at + by, work_.new_gesture());
  }
  return {true, touch.hovered || touch.held};
}

void TakesTimeline::draw_edge(const Ui& ui, const Rows& rows, bool last, bool hot) const {
  const std::vector<double> keys = work_.shop().order_of(*work_.walk()).keys;
  const float x = std::round(rows.x(last ? keys.back() : keys.front()));
  const float thick = ui.layout.size(hot ? 6 : 4), over = ui.layout.size(4);
  fill({x - thick / 2, rows.loops.y - over, thick, rows.loops.height + 2 * over},
       ui.look.palette.text);
}

// The take as a whole; the part that is seen is moved by dragging.
void TakesTimeline::draw_overview(const Ui& ui, const Rows& rows) {
  const Palette& palette = ui.look.palette;
  const double last = std::max(rows.frames - 1, 1);
  const double wide = rows.shown.to - rows.shown.from;
  const Box& bar = rows.overview;
  const auto x = [&](double frame) { return bar.x + to_pixels(frame / last) * bar.width; };
  fill(bar, palette.track);
  for (const motion::CycleCandidate& loop : review_->search.candidates) {
    const float from = std::round(x(loop.first())), to = std::round(x(loop.keys.back()));
    fill({from, bar.y, std::max(to - from - 1, 1.0f), bar.height}, palette.example);
  }
  for (const motion::FrameRange& gap : review_->gaps) {
    fill({x(gap.first), bar.y, std::max(x(gap.last) - x(gap.first), 2.0f), bar.height},
         palette.alarm);
  }
  const Box seen{std::round(x(rows.shown.from)), bar.y,
                 std::round(to_pixels(wide / last) * bar.width), bar.height};
  frame(seen, palette.text, ui.layout.size(2));
  if (wide >= last) return;
  const double middle = (rows.shown.from + wide / 2) / last;
  if (const auto to = drag_bar(ui, "slide", "part", bar, middle)) {
    shown_.from = std::clamp(*to * last - wide / 2, 0.0, last - wide);
    shown_.to = shown_.from + wide;
  }
}

}  // namespace promenade::app
