#include "app/desk/takes/takes_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "app/desk/column.h"
#include "app/desk/pages.h"

namespace promenade::app {
namespace {

// Lengths at 1280 x 720: at 1440 x 900 the columns are 280 and 360 pixels wide.
constexpr float list_width = 250, set_width = 320, foot_height = 64, edge = 12;

// The best loop beside those that are chosen; nothing: there is none.
std::optional<std::vector<double>> another_loop(const study::Workshop& shop, std::size_t take) {
  const auto review = shop.review(take);
  const std::vector<motion::GivenCycle>& chosen = shop.takes()[take].source.cycles;
  const double shift = review->take.first_frame;
  for (const motion::CycleCandidate& loop : review->search.candidates) {
    const bool apart =
        std::all_of(chosen.begin(), chosen.end(), [&](const motion::GivenCycle& one) {
          return loop.keys.back() + shift <= one.frames.front() + 1 ||
                 loop.first() + shift >= one.frames.back() - 1;
        });
    if (apart) return loop.keys;
  }
  return std::nullopt;
}

}  // namespace

TakesPage::TakesPage(const std::string& folder)
    : list_(work_), stage_(work_), timeline_(work_), set_(work_), foot_(work_, folder) {}

void TakesPage::advance(std::int64_t now_us) {
  now_us_ = now_us;
  work_.advance(now_us);
  foot_.follow_recipe();
}

void TakesPage::dropped(const std::vector<std::string>& paths) {
  work_.add(paths);
  list_.browse(false);
  foot_.follow_recipe();
}

bool TakesPage::moves() const { return !work_.shop().takes().empty() || work_.busy(); }

// What is shown beside the takes, and changes without them: troubles, what is being written, the
// lines of a file.
std::vector<std::string> TakesPage::words_beside() const {
  std::vector<std::string> words = {work_.trouble(), work_.made().file, work_.made().trouble,
                                    foot_.file(),    foot_.credit(),    list_.path(),
                                    set_.written()};
  for (const study::FileLine& line : lines_) words.push_back(line.text);
  if (!list_.browsing()) return words;
  words.push_back(list_.folders().folder());
  for (const ListedFile& file : list_.folders().files()) words.push_back(file.name);
  return words;
}

const std::vector<std::string>& TakesPage::shown_words() const {
  const study::Workshop& shop = work_.shop();
  std::vector<std::string> beside = words_beside();
  if (shown_revision_ == shop.revision() && shown_beside_ == beside) return shown_;
  shown_revision_ = shop.revision();
  shown_beside_ = std::move(beside);
  shown_ = shown_beside_;
  shown_.push_back(shop.folder());
  for (std::size_t t = 0; t < shop.takes().size(); ++t) {
    const motion::TakeSource& source = shop.takes()[t].source;
    shown_.insert(shown_.end(), {source.file, source.style, shop.verdict(t).reason});
    for (const motion::GivenCycle& cycle : source.cycles) shown_.push_back(cycle.name);
  }
  return shown_;
}

void TakesPage::draw_figures(FigureRenderer& renderer, const Gui& gui) {
  stage_.draw_figures(renderer, gui);
  set_.draw_figures(renderer, gui);
}

void TakesPage::draw(const Ui& ui, const study::Texts& words, const Box& room) {
  const float in = ui.layout.size(edge);
  const Box foot{room.x, room.bottom() - ui.layout.size(foot_height), room.width,
                 ui.layout.size(foot_height)};
  const Box all{room.x + in, room.y + in, room.width - 2 * in, foot.y - room.y - 2 * in};
  const Box left{all.x, all.y, ui.layout.size(list_width), all.height};
  const float wide = ui.layout.size(set_width);
  const Box right{all.right() - wide, all.y, wide, all.height};
  const Box middle{left.right() + in, all.y, right.x - left.right() - 2 * in, all.height};
  const float fields = foot_.fields_height(ui);
  const Box below{right.x, right.bottom() - fields, right.width, fields};
  list_.draw(ui, words, left, now_us_);
  draw_middle(ui, words, middle);
  set_.draw(ui, words, {right.x, right.y, right.width, right.height - fields - in});
  fill(below, ui.look.palette.panel);
  foot_.draw_fields(ui, words, below, now_us_);
  foot_.draw(ui, words, foot);
  hear_keys(ui);
}

void TakesPage::draw_middle(const Ui& ui, const study::Texts& words, const Box& box) {
  if (list_.browsing()) {
    stage_.hide();
    list_.draw_folders(ui, words, box);
  } else if (work_.shop().takes().empty()) {
    stage_.hide();
    draw_nothing_yet(ui, words, box);
  } else {
    draw_take(ui, words, box);
    if (std::exchange(forgotten_, false)) work_.shop().forget(*work_.take());
  }
}

void TakesPage::draw_nothing_yet(const Ui& ui, const study::Texts& words, const Box& box) {
  const Palette& palette = ui.look.palette;
  const float wide = std::min(ui.layout.size(440), box.width);
  const float head = ui.layout.size(40), foot = ui.layout.size(48), gap = ui.layout.size(20);
  const float text = paragraphs_height(ui.look.fonts.reading, wide, words("takes.drop_says"));
  const float x = std::round(box.middle_x() - wide / 2);
  const float y = std::round(box.middle_y() - (head + text + gap + foot) / 2);
  draw_text(ui.look.fonts.title, {x, y, wide, head}, palette.text, words("takes.drop"));
  draw_paragraphs(ui.look.fonts.reading, x, y + head, wide, palette.quiet,
                  words("takes.drop_says"));
  const Box press{x, y + head + text + gap, ui.layout.size(200), foot};
  if (button(ui, "browse_first", press, words("takes.drop_browse"), ButtonKind::filled)) {
    list_.browse(true);
  }
  app::frame(box, palette.line, ui.layout.size(2));
}

void TakesPage::draw_take(const Ui& ui, const study::Texts& words, const Box& box) {
  const float timeline = ui.layout.size(162), tools = ui.layout.size(44), in = ui.layout.size(8);
  const std::size_t take = *work_.take();
  const std::string reason = reason_of(work_.shop(), take, words);
  const bool seen = work_.shop().review(take) != nullptr;
  const float wide = box.width - 2 * ui.layout.size(14);
  const float says = reason.empty()
                         ? ui.layout.size(30)
                         : paragraphs_height(ui.look.fonts.text, wide, reason) + ui.layout.size(58);
  Box left = box;
  draw_says(ui, words, {left.x, left.y, left.width, says}, reason);
  left.y += says + in;
  left.height -= says + in;
  if (!seen) {
    stage_.hide();
    return draw_lines(ui, words, left);
  }
  const Box stage{left.x, left.y, left.width, left.height - timeline - tools - 2 * in};
  stage_.draw(ui, words, stage, list_.names()[take]);
  timeline_.draw(ui, words, {left.x, stage.bottom() + in, left.width, timeline});
  draw_tools(ui, words, {left.x, left.bottom() - tools, left.width, tools});
}

// The lines of the file where reading stopped.
void TakesPage::draw_lines(const Ui& ui, const study::Texts& words, const Box& box) {
  const std::size_t take = *work_.take();
  const std::vector<Problem>& problems = work_.shop().problems(take);
  if (problems.empty() || problems.front().line == 0) return;
  const Problem& problem = problems.front();
  const std::string& file = work_.shop().takes()[take].source.file;
  if (lines_of_ != file) {
    lines_of_ = file;
    lines_ = study::lines_around(file, problem.line, problem.column, 3, 64);
  }
  const Palette& palette = ui.look.palette;
  const float high = ui.layout.size(30), in = ui.layout.size(14), number = ui.layout.size(60);
  Box line{box.x, box.y, box.width, high};
  draw_line(ui.look.fonts.text, line, palette.quiet, words("takes.lines"));
  for (const study::FileLine& one : lines_) {
    line.y += high;
    const bool here = one.number == problem.line;
    fill(line, here ? palette.alarm : palette.on_colour);
    const Rgb& ink = here ? palette.on_colour : palette.quiet;
    draw_text(ui.look.fonts.text, {line.x + in, line.y, number, high}, ink,
              std::to_string(one.number));
    ImGui::PushClipRect({line.x, line.y}, {line.right() - in, line.bottom()}, true);
    draw_text(here ? ui.look.fonts.bold : ui.look.fonts.text,
              {line.x + in + number, line.y, line.width, high}, ink, one.text);
    ImGui::PopClipRect();
  }
}

std::string TakesPage::facts_of(const study::Texts& words, std::size_t take) const {
  const std::filesystem::path file(work_.shop().takes()[take].source.file);
  const auto review = work_.shop().review(take);
  if (!review) return file.filename().string();
  const motion::Take& seen = review->take;
  return words.with("takes.facts",
                    {{"file", file.filename().string()},
                     {"seconds", fmt::format("{:.1f}", seen.frames() * seen.frame_time)},
                     {"rate", fmt::format("{:.0f}", 1 / seen.frame_time)},
                     {"joints", std::to_string(review->joints())}});
}

// What the take is; where it was refused, why in plain words.
void TakesPage::draw_says(const Ui& ui, const study::Texts& words, const Box& box,
                          const std::string& reason) {
  const Palette& palette = ui.look.palette;
  const std::size_t take = *work_.take();
  if (reason.empty()) {
    return draw_line(ui.look.fonts.text, box, palette.quiet, facts_of(words, take));
  }
  const bool failed = work_.shop().verdict(take).refused();
  const float in = ui.layout.size(14), gap = ui.layout.size(8);
  fill(box, palette.on_colour);
  fill({box.x, box.y, ui.layout.size(6), box.height}, failed ? palette.alarm : palette.line);
  Box line{box.x + in, box.y + gap, box.width - 2 * in, ui.layout.size(28)};
  const float under = line.bottom() + gap, whole = line.width;
  const Chip chip = chip_of(work_.shop(), take, words);
  const Box chip_box{line.x, line.y, std::min(chip_width(ui, chip), 0.5f * whole), line.height};
  draw_chip(ui, chip_box, chip);
  const std::string& off = words("takes.forget");
  const float wide = std::round(text_width(ui.look.fonts.text, off)) + ui.layout.size(24);
  const Box forget{line.right() - wide, line.y, wide, line.height};
  if (button(ui, "forget", forget, off, ButtonKind::outlined)) forgotten_ = true;
  line.x = chip_box.right() + in;
  line.width = forget.x - in - line.x;
  const std::filesystem::path file(work_.shop().takes()[take].source.file);
  draw_line(ui.look.fonts.bold, line, palette.text, file.filename().string());
  draw_paragraphs(ui.look.fonts.text, chip_box.x, under, whole, palette.text, reason);
}

void TakesPage::draw_tools(const Ui& ui, const study::Texts& words, const Box& box) {
  study::Workshop& shop = work_.shop();
  const float in = ui.layout.size(10);
  Box left = box;
  const Box play{box.x, box.y, box.height, box.height};
  if (icon_button(ui, "play", "take", play, work_.playing() ? Icon::pause : Icon::play)) {
    work_.play(!work_.playing());
  }
  left.x += play.width + in;
  left.width -= play.width + in;
  const auto at_right = [&](std::string_view label) {
    const float wide = std::round(text_width(ui.look.fonts.text, label)) + ui.layout.size(28);
    left.width -= wide + in;
    return Box{left.right() + in, box.y, wide, box.height};
  };
  const std::size_t take = *work_.take();
  const bool out = shop.takes()[take].left_out;
  const bool used = shop.verdict(take).state == study::TakeState::used;
  const std::string& leave = words(out ? "takes.take_back" : "takes.leave_out");
  if ((used || out) && button(ui, "leave_out", at_right(leave), leave, ButtonKind::outlined)) {
    return shop.leave_out(take, !out);
  }
  const auto more = used ? another_loop(shop, take) : std::nullopt;
  const std::string& another = words("takes.another_loop");
  if (more && button(ui, "another_loop", at_right(another), another, ButtonKind::outlined)) {
    shop.add_loop(take, *more);
    return work_.look_at(take, shop.takes()[take].source.cycles.size() - 1);
  }
  draw_loop_facts(ui, words, left);
}

// Two lines beside the buttons.
void TakesPage::draw_loop_facts(const Ui& ui, const study::Texts& words, const Box& box) const {
  const std::optional<study::WalkPlace> walk = work_.walk();
  const auto loop = walk ? work_.loop(*walk) : nullptr;
  if (!loop) return;
  const std::string first =
      words.with("takes.loop_frames", {{"frames", fmt::format("{:.0f}", loop->cut.length())},
                                       {"first", std::to_string(loop->cycle().first_frame)},
                                       {"seconds", fmt::format("{:.2f}", loop->cycle().seconds)}});
  const std::string second =
      words.with("takes.loop_unlike", {{"mm", fmt::format("{:.0f}", 1000 * loop->cut.window_m)}});
  const float half = std::round(box.height / 2);
  draw_line(ui.look.fonts.text, {box.x, box.y, box.width, half}, ui.look.palette.text, first);
  draw_line(ui.look.fonts.text, {box.x, box.y + half, box.width, half}, ui.look.palette.quiet,
            second);
}

void TakesPage::hear_keys(const Ui& ui) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantTextInput || set_.writing()) return;
  if (io.KeyCtrl && key_pressed(ImGuiKey_Z)) {
    io.KeyShift ? work_.shop().redo() : work_.shop().undo();
  } else if (io.KeyCtrl && key_pressed(ImGuiKey_Y)) {
    work_.shop().redo();
  }
  const bool free = ui.focus.nowhere() || ui.focus.on_kind("take") || ui.focus.on_kind("edge") ||
                    ui.focus.on_kind("slide") || ui.focus.on_kind("stage") ||
                    ui.focus.on_kind("loop");
  if (free && key_pressed(ImGuiKey_Space, false)) work_.play(!work_.playing());
}

std::unique_ptr<DeskPage> make_takes_page(DeskServices& services) {
  return std::make_unique<TakesPage>(services.shelf.folder().string());
}

}  // namespace promenade::app
