#include "app/desk/desk.h"

#include <algorithm>
#include <filesystem>

#include "app/desk/desk_foot.h"
#include "app/desk/edit/edit_page.h"
#include "app/desk/pages.h"
#include "app/desk/takes/takes_page.h"
#include "app/desk/watch/watch_page.h"
#include "app/desk/words.h"
#include "motion/problem.h"

namespace promenade::app {
namespace {

constexpr DeskPlace first_of_study = DeskPlace::edit;
constexpr std::int64_t patience_us = 20'000'000;  // between two wishes to close the window

std::map<std::string, study::Texts, std::less<>> all_texts() {
  std::map<std::string, study::Texts, std::less<>> texts;
  for (const std::string& language : desk_languages()) {
    texts.emplace(language, desk_texts(language));
  }
  return texts;
}

}  // namespace

Desk::Desk(DeskSetting setting, InputQueue& queue)
    : setting_(std::move(setting)),
      shelf_(setting_.studies),
      studies_(setting_.studies),
      jobs_(setting_.program.empty() ? own_program() : setting_.program),
      services_{.jobs = jobs_,
                .shelf = shelf_,
                .studies = studies_,
                .displays = setting_.displays,
                .display = setting_.displays.size() > 1 ? std::size_t{1} : 0,
                .open = [this](const study::StudyPlace& study) { open(study); },
                .go = [this](DeskPlace place) { go(place); },
                .show = [this](const std::string& path) { show(path); },
                .in_use = [this](const study::StudyPlace& study) { return in_use(study); },
                .renamed = [this](const study::StudyPlace& from,
                                  const study::StudyPlace& to) { follow(from, to); }},
      language_(setting_.language),
      words_(all_texts()),
      page_(queue) {}

Desk::~Desk() = default;

void Desk::show(const std::string& path) {
  try {
    setting_.show(path);
  } catch (const OutsideError& error) {
    jobs_.tell(error.what());
  }
}

bool Desk::in_use(const study::StudyPlace& study) const {
  if (jobs_.busy() || jobs_.quiet()) return true;
  const auto room = rooms_.find(study.folder.string());
  if (room == rooms_.end()) return false;
  const auto& pages = room->second.pages;
  return std::any_of(pages.begin(), pages.end(),
                     [](const auto& page) { return page && page->unsaved(); });
}

// Its pages begin anew: they knew the old folder.
void Desk::follow(const study::StudyPlace& from, const study::StudyPlace& to) {
  rooms_.erase(from.folder.string());
  if (study_ && study_->folder == from.folder) study_ = to;
}

void Desk::open(const study::StudyPlace& study) {
  study_ = study;
  place_ = first_of_study;
  page_.focus().leave();
}

void Desk::go(DeskPlace place) {
  if (place >= first_of_study && !study_) return;
  place_ = place;
  page_.focus().leave();
}

Desk::Room& Desk::room() {
  const bool of_study = place_ >= first_of_study;
  Room& room = rooms_[of_study ? study_->folder.string() : ""];
  if (of_study && !room.study) room.study = std::make_unique<OpenStudy>(*study_);
  return room;
}

DeskPage& Desk::page() {
  std::unique_ptr<DeskPage>& page = room().pages[static_cast<std::size_t>(place_)];
  if (!page) page = make_page(place_);
  return *page;
}

std::unique_ptr<DeskPage> Desk::make_page(DeskPlace place) {
  switch (place) {
    case DeskPlace::studies:
      return make_studies_page(services_);
    case DeskPlace::plan:
      return make_plan_page(services_, *room().study);
    case DeskPlace::rehearse:
      return make_rehearse_page(services_, *room().study);
    case DeskPlace::run:
      return make_run_page(services_, *room().study);
    case DeskPlace::results:
      return make_results_page(services_, *room().study);
    case DeskPlace::takes:
      return make_takes_page(services_);
    case DeskPlace::edit:
      return std::make_unique<EditPage>(study_->file());
    case DeskPlace::watch:
      return std::make_unique<WatchPage>(
          study_->sessions(),
          [this, study = *study_](const study::WatchedSession& one) { resume(study, one); });
  }
  return nullptr;
}

// The first page of the session offers to go on where it stood.
void Desk::resume(const study::StudyPlace& study, const study::WatchedSession& session) {
  if (!services_.screen_is_free()) return jobs_.tell(words_.at(language_)("shell.not_free"));
  std::vector<std::string> command{"run",       study.file(),   "--db", study.sessions(),
                                   "--station", session.station};
  const std::vector<std::string> display =
      session.pilot ? std::vector<std::string>{"--windowed"} : services_.display_options();
  command.insert(command.end(), display.begin(), display.end());
  if (session.pilot) command.emplace_back("--pilot");
  if (!session.pilot && study::is_there(study.roster())) {
    command.insert(command.end(), {"--roster", study.roster()});
  }
  jobs_.start(words_.at(language_)("shell.resuming"), command, {}, JobKind::session);
}

void Desk::advance(std::int64_t now_us) {
  now_us_ = now_us;
  jobs_.look();
  studies_.look(now_us);
  if (OpenStudy* study = room().study.get()) study->look(now_us);
  page().advance(now_us);
}

void Desk::draw_figures(FigureRenderer& renderer, const Gui& gui) {
  page().draw_figures(renderer, gui);
}

void Desk::dropped(const std::vector<std::string>& paths) { page().dropped(paths); }

bool Desk::moves() const {
  const auto room = rooms_.find(place_ >= first_of_study ? study_->folder.string() : "");
  if (room == rooms_.end()) return true;
  const std::unique_ptr<DeskPage>& page = room->second.pages[static_cast<std::size_t>(place_)];
  return !page || page->moves() || jobs_.busy();
}

void Desk::frame(Gui& gui) {
  page_.frame(gui, [this](const Ui& ui) { draw(ui); });
}

void Desk::draw(const Ui& ui) {
  hear_keys();
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float head = ui.layout.size(56);
  const DeskJob* const job = jobs_.shown();
  const float foot = job != nullptr || !jobs_.trouble().empty() ? ui.layout.size(48) : 0;
  draw_tabs(ui, {0, 0, size.x, head});
  const float notice = draw_unsaved(ui, {0, head, size.x, ui.layout.size(48)});
  const float top = head + notice;
  page().draw(ui, words_.at(language_), {0, top, size.x, size.y - top - foot});
  if (foot > 0) draw_desk_foot(ui, words_.at(language_), jobs_, {0, size.y - foot, size.x, foot});
}

DeskPage* Desk::edit_page() {
  if (place_ < first_of_study) return nullptr;
  return room().pages[static_cast<std::size_t>(DeskPlace::edit)].get();
}

float Desk::draw_unsaved(const Ui& ui, const Box& box) {
  const bool closing = asked_.contains(&page()) && page().unsaved();
  DeskPage* const edit = closing ? &page() : edit_page();
  if (edit == nullptr || !edit->unsaved()) return 0;
  if (place_ == DeskPlace::edit && !closing) return 0;
  const study::Texts& words = words_.at(language_);
  fill(box, ui.look.palette.known);
  const float inset = ui.layout.size(16);
  const float wide = ui.layout.size(140);
  const float edge = ui.layout.size(5);
  draw_line(ui.look.fonts.text, {box.x + inset, box.y, box.width - wide - 3 * inset, box.height},
            ui.look.palette.text, words(closing ? "shell.close_unsaved" : "shell.unsaved"));
  const Box save{box.right() - wide - inset, box.y + edge, wide, box.height - 2 * edge};
  if (button(ui, "save_study", save, words("shell.save"), ButtonKind::outlined)) edit->save();
  return box.height;
}

bool Desk::may_close() {
  std::erase_if(asked_, [this](const auto& one) { return now_us_ - one.second > patience_us; });
  for (auto& [folder, room] : rooms_) {
    for (std::size_t i = 0; i < desk_places; ++i) {
      const DeskPage* const page = room.pages[i].get();
      if (page == nullptr || !page->unsaved() || asked_.contains(page)) continue;
      if (room.study) open(room.study->place());
      go(static_cast<DeskPlace>(i));
      asked_[page] = now_us_;
      return false;
    }
  }
  return true;
}

// Ctrl and a number: the places from left to right.
void Desk::hear_keys() {
  if (!ImGui::GetIO().KeyCtrl) return;
  for (int i = 0; i < static_cast<int>(desk_places); ++i) {
    if (ImGui::IsKeyPressed('1' + i, false)) return go(static_cast<DeskPlace>(i));
  }
}

void Desk::draw_tab(const Ui& ui, DeskPlace place, Box& left) {
  const std::string& label = words_.at(language_)("shell." + std::string(to_text(place)));
  const bool here = place == place_;
  ImFont* const font = here ? ui.look.fonts.bold : ui.look.fonts.text;
  const float width = text_width(font, label) + ui.layout.size(28);
  const Box box{left.x, left.y, width, left.height};
  if (small_button(ui, "go", to_text(place), box, here ? "" : label)) go(place);
  if (here) {
    draw_text(font, box, ui.look.palette.text, label, Align::centre);
    const float thick = ui.layout.size(4);
    fill({box.x, box.bottom() - thick, box.width, thick}, ui.look.palette.created);
  }
  left.x += width;
}

void Desk::draw_tabs(const Ui& ui, const Box& bar) {
  const Palette& palette = ui.look.palette;
  fill(bar, palette.panel);
  fill({bar.x, bar.bottom() - ui.layout.size(1), bar.width, ui.layout.size(1)}, palette.line);
  Box left{bar.x + ui.layout.size(8), bar.y, bar.width, bar.height};
  draw_tab(ui, DeskPlace::studies, left);
  draw_tab(ui, DeskPlace::takes, left);
  const std::string& other = words_.at(language_)("shell.other_language");
  const float wide = text_width(ui.look.fonts.text, other) + ui.layout.size(28);
  const Box right{bar.right() - wide - ui.layout.size(8), bar.y, wide, bar.height};
  if (small_button(ui, "press", "language", right, other)) change_language();
  if (!study_) return;
  left.x += ui.layout.size(12);
  fill({left.x, bar.y + ui.layout.size(14), ui.layout.size(1), ui.layout.size(28)}, palette.line);
  left.x += ui.layout.size(16);
  const std::string name = study_->name();
  const float room = std::min(text_width(ui.look.fonts.bold, name), ui.layout.size(240));
  draw_line(ui.look.fonts.bold, {left.x, bar.y, room, bar.height}, palette.created, name);
  left.x += room + ui.layout.size(12);
  for (auto place = static_cast<std::size_t>(first_of_study); place < desk_places; ++place) {
    draw_tab(ui, static_cast<DeskPlace>(place), left);
  }
}

void Desk::change_language() { language_ = language_ == "en" ? "ja" : "en"; }

std::vector<std::string> Desk::shown_words() const {
  std::vector<std::string> words;
  if (study_) words.push_back(study_->name());
  for (const auto& [folder, room] : rooms_) {
    for (const std::unique_ptr<DeskPage>& page : room.pages) {
      if (!page) continue;
      const std::vector<std::string>& more = page->shown_words();
      words.insert(words.end(), more.begin(), more.end());
    }
  }
  words.push_back(jobs_.trouble());
  if (const DeskJob* job = jobs_.shown()) words.push_back(job->job->messages());
  return words;
}

}  // namespace promenade::app
