#include "app/desk/edit/edit_page.h"

#include <algorithm>
#include <filesystem>

#include "app/choice.h"
#include "app/desk/column.h"
#include "app/registry.h"
#include "motion/problem.h"

namespace promenade::app {
namespace {

using Disk = study::StudyDraft::Disk;

constexpr std::int64_t look_period_us = 500'000;

// Of Dear ImGui, by GLFW's number of a letter's key.
bool control_and(char letter) {
  if (!ImGui::GetIO().KeyCtrl) return false;
#if IMGUI_VERSION_NUM >= 18700
  return ImGui::IsKeyPressed(static_cast<ImGuiKey>(ImGuiKey_A + (letter - 'A')), false);
#else
  return ImGui::IsKeyPressed(letter, false);
#endif
}

}  // namespace

EditPage::EditPage(std::string file)
    : file_(std::move(file)),
      options_(file_, interfaces()),
      checker_(std::make_unique<StudyChecker>(file_, interfaces())) {
  read();
}

EditPage::~EditPage() = default;

void EditPage::read() {
  try {
    draft_.emplace(file_);
    trouble_.clear();
    follow();
  } catch (const InputError& error) {
    trouble_ = error.problems().front().message;
  }
}

void EditPage::advance(std::int64_t now_us) {
  now_us_ = now_us;
  const bool due = now_us - looked_us_ >= look_period_us;
  if (due) looked_us_ = now_us;
  if (!draft_) {
    if (due) read();
    return;
  }
  if (due && draft_->look()) saved_ = {};
  checker_->see(draft_->text(), now_us);
  follow();
  figures_.advance(now_us);
  if (side_ == Side::distances) distances_.follow(bundle_);
  distances_.advance();
}

bool EditPage::moves() const {
  return checker_->working() || distances_.working() || preview_.working() || figures_.moves();
}

void EditPage::draw_figures(FigureRenderer& renderer, const Gui& gui) {
  figures_.draw(renderer, gui.look().palette);
}

// What is derived from the text and from its check, once for each.
void EditPage::follow() {
  const auto found = checker_->found();
  if (followed_ == draft_->version() && found == check_) return;
  followed_ = draft_->version();
  check_ = found;
  if (check_ && check_->bundle) bundle_ = check_->bundle;
  if (check_) figures_.follow(check_->motions);
  options_.follow(draft_->root(), check_ ? check_->motions.get() : nullptr);
  shown_ = {file_, draft_->text()};
  for (const PlacedProblem& one : problems()) shown_.push_back(one.problem.message);
  for (const char* source : {"@walks", "@sets"}) {
    const std::vector<std::string>& names = options_.of(source);
    shown_.insert(shown_.end(), names.begin(), names.end());
  }
}

const std::vector<PlacedProblem>& EditPage::problems() const {
  static const std::vector<PlacedProblem> none;
  return check_ ? check_->problems : none;
}

// A line that is being written counts, though it is not in the draft yet.
bool EditPage::unsaved() const { return draft_ && (!draft_->saved() || line_.differs(*draft_)); }

void EditPage::save() {
  if (!draft_) return;
  line_.take(*draft_);
  saved_ = report_of_saving([this] { draft_->save(); });
}

void EditPage::hear_keys() {
  if (control_and('S')) save();
  if (control_and('Z')) go_back(ImGui::GetIO().KeyShift);
  if (control_and('Y')) go_back(true);
}

// Undo, or redo: `again`. What it changes comes into sight.
void EditPage::go_back(bool again) {
  line_.take(*draft_);
  const std::string before = draft_->text();
  again ? draft_->redo() : draft_->undo();
  const std::string& now = draft_->text();
  if (now == before) return;
  const auto at = std::mismatch(before.begin(), before.end(), now.begin(), now.end()).second;
  const auto byte = static_cast<std::size_t>(at - now.begin());
  file_view_.show(study::line_at(now, byte));
  // What is gone stood in the text before.
  const std::string& longer = now.size() < before.size() ? before : now;
  const std::size_t changed = longer.find_first_not_of(" \t\r\n", byte);
  const study::TomlPath path = study::path_at(study::scan_toml(longer), changed);
  if (!path.empty()) form_.reveal(path);
}

void EditPage::draw(const Ui& ui, const study::Texts& words, const Box& room) {
  figures_.clear();
  if (!draft_) return draw_trouble(ui, words, room);
  hear_keys();
  const float edge = ui.layout.size(16);
  const float head = ui.layout.size(48);
  Box left{room.x + edge, room.y + ui.layout.size(8), room.width - 2 * edge, head};
  draw_head(ui, words, left);
  left.y += head + ui.layout.size(8);
  left.y += draw_notice(ui, words, left);
  left.height = room.bottom() - left.y - ui.layout.size(8);
  const float half = 0.53f * left.width;
  const float between = ui.layout.size(16);
  const FormScene scene{*draft_, options_, problems(), interfaces(), now_us_};
  const Box form{left.x, left.y, half, left.height};
  if (draft_->is_toml()) {
    form_.draw(ui, words, form, scene);
  } else {
    draw_paragraphs(ui.look.fonts.reading, form.x, form.y, form.width, ui.look.palette.quiet,
                    words("edit.no_form"));
  }
  draw_right({ui, words, scene},
             {left.x + half + between, left.y, left.width - half - between, left.height});
}

// "saved", "not saved", "changed on disk".
std::string EditPage::state_key() const {
  if (draft_->disk() == Disk::both) return "edit.both";
  if (draft_->disk() == Disk::gone) return "edit.gone";
  return unsaved() ? "edit.not_saved" : "edit.saved";
}

void EditPage::draw_head(const Ui& ui, const study::Texts& words, const Box& box) {
  const Palette& palette = ui.look.palette;
  const float high = ui.layout.size(40);
  const Box save_box{box.right() - ui.layout.size(128), box.y + ui.layout.size(4),
                     ui.layout.size(128), high};
  const Box redo_box{save_box.x - ui.layout.size(52), save_box.y, ui.layout.size(44), high};
  const Box undo_box{redo_box.x - ui.layout.size(44), save_box.y, ui.layout.size(44), high};
  const std::string name = std::filesystem::path(file_).filename().string();
  const float wide = std::min(text_width(ui.look.fonts.title, name), 0.5f * box.width);
  draw_line(ui.look.fonts.title, {box.x, box.y, wide, box.height}, palette.text, name);
  const std::string key = state_key();
  const float x = box.x + wide + ui.layout.size(20);
  const bool calm = key == "edit.saved";
  draw_line(calm ? ui.look.fonts.text : ui.look.fonts.bold,
            {x, box.y + ui.layout.size(2), undo_box.x - x, box.height},
            calm ? palette.quiet : palette.steps.front(), words(key));
  if (icon_button(ui, "press", "undo", undo_box, Icon::undo, draft_->can_undo())) go_back(false);
  if (icon_button(ui, "press", "redo", redo_box, Icon::redo, draft_->can_redo())) go_back(true);
  if (button(ui, "save", save_box, words("edit.save"), ButtonKind::filled, unsaved())) {
    save();
  }
}

// What needs an answer, or a look; empty: nothing does.
std::string EditPage::notice(const study::Texts& words) const {
  if (saved_.failed) return saved_.words;
  switch (draft_->disk()) {
    case Disk::both:
      return words("edit.notice.both");
    case Disk::reread:
      return words("edit.notice.reread");
    case Disk::gone:
      return words("edit.notice.gone");
    case Disk::same:
      break;
  }
  return draft_->is_toml() ? draft_->refusal() : words("edit.notice.no_toml");
}

// A bar across the page; the height that it takes.
float EditPage::draw_notice(const Ui& ui, const study::Texts& words, const Box& box) {
  const std::string text = notice(words);
  if (text.empty()) return 0;
  const Palette& palette = ui.look.palette;
  const float high = ui.layout.size(48);
  const Disk disk = draft_->disk();
  const bool calm = !saved_.failed && (disk == Disk::reread || disk == Disk::gone);
  const Rgb mark = calm ? palette.created : palette.pilot;
  fill({box.x, box.y, box.width, high}, 0.14f * mark + 0.86f * palette.on_colour);
  fill({box.x, box.y, ui.layout.size(6), high}, mark);
  const Box row = inside(ui, {box.x, box.y, box.width, high}, 6);
  const float x = row.x + ui.layout.size(10);
  const float end = draw_answers(ui, words, row);
  draw_line(ui.look.fonts.text, {x, row.y, end - x - ui.layout.size(8), row.height}, palette.text,
            text);
  return high + ui.layout.size(8);
}

// What can be done about a notice; where the leftmost button begins, pixels.
float EditPage::draw_answers(const Ui& ui, const study::Texts& words, const Box& row) {
  const float wide = ui.layout.size(200);
  Box place{row.right() - wide, row.y, wide, row.height};
  const auto answer = [&](const char* target) {
    return button(ui, target, place, words("edit." + std::string(target)), ButtonKind::outlined);
  };
  const bool both = draft_->disk() == Disk::both && !saved_.failed;
  const bool told = saved_.failed || draft_->disk() == Disk::reread || !draft_->refusal().empty();
  if (both) {
    if (answer("keep_mine")) draft_->keep_mine();
    place.x -= wide + ui.layout.size(8);
    if (answer("take_the_files")) draft_->take_the_files();
  } else if (told) {
    if (!answer("seen")) return place.x;
    draft_->seen();
    draft_->forget_refusal();
    saved_ = {};
  } else {
    return row.right();
  }
  return place.x;
}

void EditPage::draw_right(const FormPass& pass, const Box& box) {
  const std::vector<std::string> sides = {pass.words("edit.file"), pass.words("edit.walks"),
                                          pass.words("edit.preview"), pass.words("edit.distances")};
  const Box tabs{box.x, box.y, box.width, pass.ui.layout.size(36)};
  if (const auto picked =
          choice_row(pass.ui, "side", tabs, sides, static_cast<std::size_t>(side_))) {
    side_ = static_cast<Side>(*picked);
  }
  const float top = tabs.bottom() + pass.ui.layout.size(8);
  const Box rest{box.x, top, box.width, box.bottom() - top};
  if (side_ == Side::file) return draw_file(pass, rest);
  if (figures_.ready()) return draw_motions(pass, rest);
  draw_paragraphs(pass.ui.look.fonts.text, rest.x, rest.y, rest.width, pass.ui.look.palette.quiet,
                  pass.words("edit.no_preview"));
}

void EditPage::draw_motions(const FormPass& pass, const Box& box) {
  if (side_ == Side::walks) return walks_.draw(pass, box, figures_);
  if (side_ == Side::preview) return preview_.draw(pass, box, bundle_, figures_);
  distances_.draw(pass, box);
}

void EditPage::draw_file(const FormPass& pass, const Box& box) {
  const Ui& ui = pass.ui;
  const float list = ui.layout.size(problems().empty() ? 28 : 160);
  const float between = ui.layout.size(8);
  const float high = ui.layout.size(36);
  const Box view{box.x, box.y, box.width, box.height - list - high - 2 * between};
  if (const auto line = file_view_.draw(ui, view, *draft_, problems(), form_.focused())) {
    const std::size_t begin = study::byte_at(draft_->text(), {*line, 1});
    const std::size_t at = draft_->text().find_first_not_of(" \t", begin);
    const study::TomlPath path = study::path_at(draft_->spans(), at);
    if (!path.empty()) form_.go_to(path);
  }
  const Box line_box{box.x, view.bottom() + between, box.width, high};
  line_.draw(pass, line_box, file_view_.chosen());
  const Box below{box.x, line_box.bottom() + between, box.width, list};
  const auto pressed = draw_problem_list(ui, pass.words, below, problems(), checker_->working());
  if (pressed && problems()[*pressed].line > 0) form_.go_to(problems()[*pressed].path);
}

void EditPage::draw_trouble(const Ui& ui, const study::Texts& words, const Box& room) {
  Column column(ui, inside(ui, room, 32));
  column.words(ui.look.fonts.title, ui.look.palette.alarm, words("edit.unreadable"));
  column.words(ui.look.fonts.reading, ui.look.palette.text, file_ + ": " + trouble_);
}

}  // namespace promenade::app
