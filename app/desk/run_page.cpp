// Run: is everything ready, on which display, and off it goes. The desk stays where it is.
#include <algorithm>
#include <filesystem>

#include "app/choice.h"
#include "app/desk/amend_box.h"
#include "app/desk/column.h"
#include "app/desk/pages.h"
#include "app/desk/readiness.h"
#include "app/scroll_area.h"
#include "motion/problem.h"

namespace promenade::app {
namespace {

Rgb colour_of(const Palette& palette, Light light) {
  switch (light) {
    case Light::green:
      return palette.bookmark;
    case Light::amber:
      return palette.pilot;
    case Light::red:
      return palette.alarm;
    case Light::unknown:
      break;
  }
  return palette.track;
}

// A sign in the mark, for people who do not see the hues.
void draw_light(const Ui& ui, const Box& box, Light light) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const Rgb colour = colour_of(ui.look.palette, light);
  list->AddCircleFilled({box.middle_x(), box.middle_y()}, 0.5f * box.width, packed(colour), 24);
  if (light == Light::unknown) return;
  const Rgb& ink = ui.look.palette.on_colour;
  const float in = 0.28f * box.width;
  const Box sign{box.x + in, box.y + in, box.width - 2 * in, box.height - 2 * in};
  if (light == Light::amber) {
    draw_text(ui.look.fonts.bold, box, ink, "!", Align::centre);
  } else {
    draw_icon(sign, light == Light::green ? Icon::check : Icon::close, ink, ui.layout.size(2));
  }
}

class RunPage : public DeskPage {
 public:
  RunPage(DeskServices& services, OpenStudy& study) : services_(services), study_(study) {}

  void advance(std::int64_t now_us) override;
  void draw(const Ui& ui, const study::Texts& words, const Box& room) override;
  const std::vector<std::string>& shown_words() const override { return shown_; }

 private:
  void draw_ready(const Ui& ui, const study::Texts& words, const Box& box);
  void draw_start(const Ui& ui, const study::Texts& words, Column& column);
  void draw_display(const Ui& ui, const study::Texts& words, Column& column);
  void draw_language(const Ui& ui, const study::Texts& words, Column& column);
  void try_machine(const study::Texts& words);
  void start(const study::Texts& words);
  std::vector<ReadyLine> lines(const study::Texts& words) const;

  DeskServices& services_;
  OpenStudy& study_;
  AmendBox amend_;
  std::size_t language_ = 0;  // of the study's, from 1; 0: the first page asks
  Draft code_, station_;
  std::vector<ReadyLine> machine_;                    // what the doctor found on this display
  bool tried_ = false;                                // it was asked
  std::shared_ptr<const study::StudyBundle> bundle_;  // whose languages these are
  std::vector<std::string> languages_;                // as people call them
  std::vector<std::string> shown_;
  float high_ = 0;  // of the right side, pixels, as it was drawn last
  std::int64_t now_us_ = 0;
};

void RunPage::advance(std::int64_t now_us) {
  now_us_ = now_us;
  if (study_.bundle() == bundle_) return;
  bundle_ = study_.bundle();
  languages_.clear();
  if (!bundle_) return;
  for (const std::string& language : bundle_->study.languages) {
    languages_.push_back(study::texts_of(*bundle_, language)("language"));
  }
}

// A name of a check that no text knows is shown as it is.
std::vector<ReadyLine> RunPage::lines(const study::Texts& words) const {
  std::vector<ReadyLine> all = lines_of_study(study_.reading(), words);
  for (ReadyLine line : machine_) {
    if (const std::string* name = words.find("run.check." + line.title)) line.title = *name;
    all.push_back(std::move(line));
  }
  if (machine_.empty()) {
    all.push_back({tried_ ? Light::red : Light::unknown, words("run.machine"),
                   words(tried_ ? "run.no_answer" : "run.not_tried")});
  }
  return all;
}

void RunPage::draw(const Ui& ui, const study::Texts& words, const Box& room) {
  const Box inner = inside(ui, room, 16);
  const float wide = ui.layout.size(400);
  const Box panel{inner.right() - wide, inner.y, wide, inner.height};
  draw_ready(ui, words, {inner.x, inner.y, panel.x - inner.x - ui.layout.size(16), inner.height});
  fill(panel, ui.look.palette.panel);
  scrolled("start", panel, high_, [&](const Box& all) {
    Column column(ui, inside(ui, all, 24));
    draw_start(ui, words, column);
    high_ = column.left().y - all.y + ui.layout.size(12);
  });
}

void RunPage::draw_ready(const Ui& ui, const study::Texts& words, const Box& box) {
  const Palette& palette = ui.look.palette;
  Column column(ui, inside(ui, box, 8));
  const Box head = column.take(48, 12);
  draw_text(ui.look.fonts.title, head, palette.text, words("run.ready"));
  const float wide = ui.layout.size(220);
  if (button(ui, "doctor", {head.right() - wide, head.y, wide, head.height}, words("run.try"),
             ButtonKind::outlined, services_.screen_is_free())) {
    try_machine(words);
  }
  const std::vector<ReadyLine> all = lines(words);
  const float side = ui.layout.size(28);
  const float gap = ui.layout.size(12);
  const Box room = column.left();
  ImFont* const font = ui.look.fonts.text;
  const float text = room.width - side - 3 * gap - ImGui::GetStyle().ScrollbarSize;
  float high = 0;
  for (const ReadyLine& line : all) {
    high += paragraphs_height(font, text, line.says) + font->FontSize + 2 * gap;
  }
  scrolled("ready", room, high, [&](const Box& inner) {
    float y = inner.y;
    for (const ReadyLine& line : all) {
      draw_light(ui, {inner.x + gap / 2, y, side, side}, line.light);
      const float x = inner.x + side + 2 * gap;
      draw_text(ui.look.fonts.bold, {x, y, text, font->FontSize * 1.2f}, palette.text, line.title);
      y += font->FontSize * 1.3f;
      y += draw_paragraphs(font, x, y, text, palette.quiet, line.says) + gap * 1.4f;
    }
  });
}

void RunPage::draw_display(const Ui& ui, const study::Texts& words, Column& column) {
  draw_text(ui.look.fonts.text, column.take(24, 4), ui.look.palette.quiet, words("run.display"));
  std::vector<std::string> names = services_.displays;
  names.push_back(words("run.window"));
  if (const auto picked = drop_down(ui, "display", column.take(40, 16), names, services_.display)) {
    services_.display = *picked;
    machine_.clear();
    tried_ = false;
  }
}

void RunPage::draw_language(const Ui& ui, const study::Texts& words, Column& column) {
  if (languages_.size() < 2) return;
  draw_text(ui.look.fonts.text, column.take(24, 4), ui.look.palette.quiet, words("run.language"));
  std::vector<std::string> names{words("run.ask")};
  names.insert(names.end(), languages_.begin(), languages_.end());
  if (const auto picked = drop_down(ui, "language_of_study", column.take(40, 16), names,
                                    std::min(language_, names.size() - 1))) {
    language_ = *picked;
  }
}

void RunPage::draw_start(const Ui& ui, const study::Texts& words, Column& column) {
  const Palette& palette = ui.look.palette;
  draw_text(ui.look.fonts.title, column.take(40, 12), palette.text, words("run.session"));
  amend_.draw(ui, words, column, study_, services_, now_us_);
  draw_display(ui, words, column);
  draw_language(ui, words, column);
  draw_text(ui.look.fonts.text, column.take(24, 4), palette.quiet, words("run.code"));
  text_box(ui, "code", column.take(40, 16), code_,
           {.most = 32, .several = false, .hint = words("run.code_hint").c_str()}, now_us_);
  draw_text(ui.look.fonts.text, column.take(24, 4), palette.quiet, words("run.station"));
  text_box(ui, "station", column.take(40, 24), station_,
           {.most = 32, .several = false, .hint = "1"}, now_us_);
  const StudyReading* const reading = study_.reading();
  const bool can = reading != nullptr && worst(lines_of_study(reading, words)) != Light::red &&
                   services_.screen_is_free();
  if (button(ui, "start", column.take(56, 12), words("run.start"), ButtonKind::filled, can)) {
    start(words);
  }
  column.words(ui.look.fonts.text, palette.quiet,
               words(services_.session_runs()     ? "run.runs_already"
                     : services_.screen_is_free() ? "run.start_says"
                                                  : "shell.not_free"));
}

void RunPage::try_machine(const study::Texts& words) {
  std::vector<std::string> command{"doctor", "--json", "--db", study_.place().sessions()};
  const std::vector<std::string> display = services_.display_options();
  command.insert(command.end(), display.begin(), display.end());
  services_.jobs.start(
      words("run.trying"), command,
      [this](const Job& job) {
        machine_ = read_doctor(job.output());
        tried_ = true;
        shown_.clear();
        for (const ReadyLine& line : machine_) shown_.push_back(line.says);
      },
      JobKind::screen);
}

void RunPage::start(const study::Texts& words) {
  const study::StudyPlace& place = study_.place();
  std::vector<std::string> command{"run", place.file(), "--db", place.sessions()};
  const std::vector<std::string> display = services_.display_options();
  command.insert(command.end(), display.begin(), display.end());
  const auto bundle = study_.bundle();
  if (language_ > 0 && language_ <= bundle->study.languages.size()) {
    command.insert(command.end(), {"--language", bundle->study.languages[language_ - 1]});
  }
  const std::string code = code_.text.words();
  if (!code.empty()) command.insert(command.end(), {"--participant", code});
  const std::string station = station_.text.words();
  if (!station.empty()) command.insert(command.end(), {"--station", station});
  if (study::is_there(place.roster())) {
    command.insert(command.end(), {"--roster", place.roster()});
  }
  services_.jobs.start(words("run.session"), command, {}, JobKind::session);
  code_ = {};
  services_.go(DeskPlace::watch);
}

}  // namespace

std::unique_ptr<DeskPage> make_run_page(DeskServices& services, OpenStudy& study) {
  return std::make_unique<RunPage>(services, study);
}

}  // namespace promenade::app
