#include "app/desk/takes_page.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "app/desk/column.h"

namespace promenade::app {
namespace {

// Lengths at 1280 x 720: at 1440 x 900 the columns are 280 and 360 pixels wide.
constexpr float list_width = 250, set_width = 320, foot_height = 64, edge = 12;

}  // namespace

TakesPage::TakesPage(const std::string& folder)
    : list_(work_), stage_(work_), timeline_(work_), set_(work_), foot_(work_, folder) {}

void TakesPage::advance(std::int64_t now_us) {
  now_us_ = now_us;
  work_.advance(now_us);
}

void TakesPage::dropped(const std::vector<std::string>& paths) {
  work_.add(paths);
  list_.browse(false);
  for (const std::string& path : paths) {
    if (path.ends_with(".toml") && work_.trouble().empty()) foot_.follow_recipe(path);
  }
}

bool TakesPage::moves() const { return !work_.shop().takes().empty() || work_.busy(); }

const std::vector<std::string>& TakesPage::shown_words() const {
  const study::Workshop& shop = work_.shop();
  if (shown_revision_ == shop.revision()) return shown_;
  shown_revision_ = shop.revision();
  shown_ = {shop.folder(), work_.trouble(), work_.made().file, work_.made().trouble, foot_.file()};
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
  }
}

void TakesPage::draw_nothing_yet(const Ui& ui, const study::Texts& words, const Box& box) const {
  const Palette& palette = ui.look.palette;
  const float wide = std::min(ui.layout.size(440), box.width);
  const float head = ui.layout.size(40);
  const float high =
      head + paragraphs_height(ui.look.fonts.reading, wide, words("takes.drop_says"));
  const float x = std::round(box.middle_x() - wide / 2), y = std::round(box.middle_y() - high / 2);
  draw_text(ui.look.fonts.title, {x, y, wide, head}, palette.text, words("takes.drop"));
  draw_paragraphs(ui.look.fonts.reading, x, y + head, wide, palette.quiet,
                  words("takes.drop_says"));
  app::frame(box, palette.line, ui.layout.size(2));
}

void TakesPage::draw_take(const Ui& ui, const study::Texts& words, const Box& box) {
  const float timeline = ui.layout.size(156), tools = ui.layout.size(44), in = ui.layout.size(8);
  const std::size_t take = *work_.take();
  const std::string reason = reason_of(work_.shop(), take, words);
  const bool seen = work_.shop().review(take) != nullptr;
  const float wide = box.width - 2 * ui.layout.size(14);
  const float says = reason.empty()
                         ? ui.layout.size(30)
                         : paragraphs_height(ui.look.fonts.text, wide, reason) + ui.layout.size(58);
  Box left = box;
  draw_says(ui, words, {left.x, left.y, left.width, says});
  left.y += says + in;
  left.height -= says + in;
  if (!seen) return stage_.hide();
  const Box stage{left.x, left.y, left.width, left.height - timeline - tools - 2 * in};
  stage_.draw(ui, words, stage, list_.names()[take]);
  timeline_.draw(ui, words, {left.x, stage.bottom() + in, left.width, timeline});
  draw_tools(ui, words, {left.x, left.bottom() - tools, left.width, tools});
}

// What the take is; where it was refused, why in plain words.
void TakesPage::draw_says(const Ui& ui, const study::Texts& words, const Box& box) {
  const Palette& palette = ui.look.palette;
  const study::Workshop& shop = work_.shop();
  const std::size_t take = *work_.take();
  const std::string reason = reason_of(shop, take, words);
  const auto review = shop.review(take);
  const float in = ui.layout.size(14);
  std::string facts = std::filesystem::path(shop.takes()[take].source.file).filename().string();
  if (review) {
    facts = words.with(
        "takes.facts",
        {{"file", facts},
         {"seconds", fmt::format("{:.1f}", review->take.frames() * review->take.frame_time)},
         {"rate", fmt::format("{:.0f}", 1 / review->take.frame_time)},
         {"joints", std::to_string(review->joints())}});
  }
  if (reason.empty()) {
    return draw_line(ui.look.fonts.text, box, palette.quiet, facts);
  }
  const bool failed = shop.verdict(take).refused();
  fill(box, palette.on_colour);
  fill({box.x, box.y, ui.layout.size(6), box.height}, failed ? palette.alarm : palette.line);
  const Chip chip = chip_of(shop, take, words);
  const Box line{box.x + in, box.y + ui.layout.size(8), box.width - 2 * in, ui.layout.size(28)};
  const float wide = std::min(chip_width(ui, chip), 0.6f * line.width);
  draw_chip(ui, {line.x, line.y, wide, line.height}, chip);
  draw_line(ui.look.fonts.bold, {line.x + wide + in, line.y, line.width - wide - in, line.height},
            palette.text, facts);
  draw_paragraphs(ui.look.fonts.text, line.x, line.bottom() + ui.layout.size(8), line.width,
                  palette.text, reason);
}

void TakesPage::draw_tools(const Ui& ui, const study::Texts& words, const Box& box) {
  study::Workshop& shop = work_.shop();
  const std::optional<study::WalkPlace> walk = work_.walk();
  const Box play{box.x, box.y, box.height, box.height};
  if (icon_button(ui, "play", "take", play, work_.playing() ? Icon::pause : Icon::play)) {
    work_.play(!work_.playing());
  }
  const std::size_t take = *work_.take();
  const bool out = shop.takes()[take].left_out;
  const std::string_view out_words = words(out ? "takes.take_back" : "takes.leave_out");
  const float in = ui.layout.size(10);
  const float wide = text_width(ui.look.fonts.text, out_words) + ui.layout.size(28);
  const Box leave{box.right() - wide, box.y, wide, box.height};
  if (shop.verdict(take).state == study::TakeState::used || out) {
    if (button(ui, "leave_out", leave, out_words, ButtonKind::outlined)) {
      shop.leave_out(take, !out);
    }
  }
  if (!walk) return;
  const auto loop = work_.loop(*walk);
  if (!loop) return;
  const motion::CycleCandidate& cut = loop->cut;
  const double first = loop->cycle().first_frame;
  const std::string says =
      words.with("takes.loop_facts", {{"loop", loop_says(*loop, words)},
                                      {"seconds", fmt::format("{:.2f}", loop->cycle().seconds)},
                                      {"first", fmt::format("{:.0f}", first)},
                                      {"frames", fmt::format("{:.0f}", cut.length())},
                                      {"unlike", fmt::format("{:.0f}", 1000 * cut.window_m)}});
  draw_line(ui.look.fonts.text,
            {play.right() + in, box.y, leave.x - play.right() - 2 * in, box.height},
            ui.look.palette.text, says);
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

}  // namespace promenade::app
