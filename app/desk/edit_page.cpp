#include "app/desk/edit_page.h"

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
}

bool EditPage::moves() const { return checker_->working(); }

// What is derived from the text and from its check, once for each.
void EditPage::follow() {
  const auto found = checker_->found();
  if (followed_ == draft_->version() && found == check_) return;
  followed_ = draft_->version();
  check_ = found;
  options_.follow(draft_->root(), check_ ? check_->bundle.get() : nullptr);
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

void EditPage::save() {
  if (!draft_) return;
  saved_ = report_of_saving([this] { draft_->save(); });
}

void EditPage::hear_keys() {
  if (control_and('S')) save();
  const bool shift = ImGui::GetIO().KeyShift;
  if (control_and('Z')) shift ? draft_->redo() : draft_->undo();
  if (control_and('Y')) draft_->redo();
}

void EditPage::draw(const Ui& ui, const study::Texts& words, const Box& room) {
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
  form_.draw(ui, words, {left.x, left.y, half, left.height}, scene);
  draw_right(ui, words,
             {left.x + half + between, left.y, left.width - half - between, left.height});
}

// "saved", "not saved", "changed on disk".
std::string EditPage::state_key() const {
  if (draft_->disk() == Disk::both) return "edit.both";
  if (draft_->disk() == Disk::gone) return "edit.gone";
  return draft_->saved() ? "edit.saved" : "edit.not_saved";
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
  if (icon_button(ui, "press", "undo", undo_box, Icon::undo, draft_->can_undo())) draft_->undo();
  if (icon_button(ui, "press", "redo", redo_box, Icon::redo, draft_->can_redo())) draft_->redo();
  if (button(ui, "save", save_box, words("edit.save"), ButtonKind::filled, !draft_->saved())) {
    save();
  }
}

// A bar across the page about what needs an answer, or a look; the height that it takes.
float EditPage::draw_notice(const Ui& ui, const study::Texts& words, const Box& box) {
  const Palette& palette = ui.look.palette;
  const Disk disk = draft_->disk();
  const bool refused = !draft_->refusal().empty();
  if (disk == Disk::same && draft_->is_toml() && !refused && !saved_.failed) return 0;
  const std::string text = saved_.failed          ? saved_.words
                           : disk == Disk::both   ? words("edit.notice.both")
                           : disk == Disk::reread ? words("edit.notice.reread")
                           : disk == Disk::gone   ? words("edit.notice.gone")
                           : !draft_->is_toml()   ? words("edit.notice.no_toml")
                                                  : draft_->refusal();
  const float high = ui.layout.size(48);
  const bool alarm = saved_.failed || disk == Disk::both || !draft_->is_toml() || refused;
  const Rgb mark = alarm ? palette.pilot : palette.created;
  fill({box.x, box.y, box.width, high}, 0.14f * mark + 0.86f * palette.on_colour);
  fill({box.x, box.y, ui.layout.size(6), high}, mark);
  const Box row = inside(ui, {box.x, box.y, box.width, high}, 6);
  const float wide = ui.layout.size(200);
  Box place{row.right() - wide, row.y, wide, row.height};
  if (disk == Disk::both) {
    if (button(ui, "keep_mine", place, words("edit.keep_mine"), ButtonKind::outlined)) {
      draft_->keep_mine();
    }
    place.x -= wide + ui.layout.size(8);
    if (button(ui, "take_the_files", place, words("edit.take_the_files"), ButtonKind::outlined)) {
      draft_->take_the_files();
    }
  } else if (disk == Disk::reread || refused || saved_.failed) {
    if (button(ui, "seen", place, words("edit.seen"), ButtonKind::outlined)) {
      draft_->seen();
      draft_->forget_refusal();
      saved_ = {};
    }
  }
  const float x = row.x + ui.layout.size(10);
  draw_line(ui.look.fonts.text, {x, row.y, place.x - x - ui.layout.size(8), row.height},
            palette.text, text);
  return high + ui.layout.size(8);
}

void EditPage::draw_right(const Ui& ui, const study::Texts& words, const Box& box) {
  const float list = ui.layout.size(128);
  const float between = ui.layout.size(8);
  const Box view{box.x, box.y, box.width, box.height - list - between};
  if (const auto line = file_view_.draw(ui, view, *draft_, problems(), form_.focused())) {
    const std::size_t begin = study::byte_at(draft_->text(), {*line, 1});
    const std::size_t at = draft_->text().find_first_not_of(" \t", begin);
    const study::TomlPath path = study::path_at(draft_->spans(), at);
    if (!path.empty()) form_.go_to(path);
  }
  const Box below{box.x, view.bottom() + between, box.width, list};
  const auto pressed = draw_problem_list(ui, words, below, problems(), checker_->working());
  if (pressed && problems()[*pressed].line > 0) form_.go_to(problems()[*pressed].path);
}

void EditPage::draw_trouble(const Ui& ui, const study::Texts& words, const Box& room) {
  Column column(ui, inside(ui, room, 32));
  column.words(ui.look.fonts.title, ui.look.palette.alarm, words("edit.unreadable"));
  column.words(ui.look.fonts.reading, ui.look.palette.text, file_ + ": " + trouble_);
}

}  // namespace promenade::app
