// Rehearse: the study tried before anybody comes. As oneself, with a simulated person at the mouse,
// and with a whole crowd of them.
#include <algorithm>
#include <filesystem>

#include "app/desk/amend_box.h"
#include "app/desk/column.h"
#include "app/desk/pages.h"
#include "app/desk/readiness.h"
#include "app/number_box.h"

namespace promenade::app {
namespace {

namespace fs = std::filesystem;

class RehearsePage : public DeskPage {
 public:
  RehearsePage(DeskServices& services, OpenStudy& study) : services_(services), study_(study) {}

  void advance(std::int64_t now_us) override;
  void draw(const Ui& ui, const study::Texts& words, const Box& room) override;

 private:
  void draw_pilot(const Ui& ui, const study::Texts& words, Column& card);
  void draw_one(const Ui& ui, const study::Texts& words, Column& card);
  void draw_many(const Ui& ui, const study::Texts& words, Column& card);
  void draw_problem(const Ui& ui, const study::Texts& words, const Box& box);
  bool can_begin() const { return study_.bundle() != nullptr && services_.screen_is_free(); }
  void begin_afresh();
  void simulate(const study::Texts& words);
  void report(const study::Texts& words);

  DeskServices& services_;
  OpenStudy& study_;
  AmendBox amend_;
  NumberDraft people_{20};
  int seed_ = 1;
  std::int64_t now_us_ = 0;
};

void RehearsePage::advance(std::int64_t now_us) { now_us_ = now_us; }

// In this file are simulated people only, and they can be made again.
void RehearsePage::begin_afresh() {
  for (const char* ending : {"", "-wal", "-shm"}) {
    std::error_code error;
    fs::remove(study_.place().rehearsal().string() + ending, error);
  }
}

void RehearsePage::draw(const Ui& ui, const study::Texts& words, const Box& room) {
  const Box inner = inside(ui, room, 24);
  Column page(ui, inner);
  page.words(ui.look.fonts.title, ui.look.palette.text, words("rehearse.title"), 4);
  page.words(ui.look.fonts.text, ui.look.palette.quiet, words("rehearse.says"), 20);
  Box row = page.left();
  row.height = std::min(row.height, ui.layout.size(400));
  using Draw = void (RehearsePage::*)(const Ui&, const study::Texts&, Column&);
  constexpr Draw cards[] = {&RehearsePage::draw_pilot, &RehearsePage::draw_one,
                            &RehearsePage::draw_many};
  for (int i = 0; i < 3; ++i) {
    const Box card = part_of_row(ui, row, i, 3, 20);
    fill(card, ui.look.palette.panel);
    Column column(ui, inside(ui, card, 24));
    (this->*cards[i])(ui, words, column);
  }
}

void RehearsePage::draw_problem(const Ui& ui, const study::Texts& words, const Box& box) {
  const StudyReading* const reading = study_.reading();
  if (reading == nullptr || reading->bundle) return;
  draw_paragraphs(
      ui.look.fonts.text, box.x, box.y, box.width, ui.look.palette.alarm,
      words("shell.cannot_run") + "\n" + problem_words(reading->problems.front(), words));
}

void RehearsePage::draw_pilot(const Ui& ui, const study::Texts& words, Column& card) {
  draw_text(ui.look.fonts.title, card.take(36), ui.look.palette.text, words("rehearse.pilot"));
  card.words(ui.look.fonts.text, ui.look.palette.text, words("rehearse.pilot_says"), 16);
  amend_.draw(ui, words, card, study_, services_, now_us_);
  const bool due = study_.reading() != nullptr && study_.reading()->amendment_due;
  const Box where = card.take(48, 16);
  if (button(ui, "pilot", where, words("rehearse.pilot_start"), ButtonKind::filled,
             can_begin() && !due)) {
    services_.jobs.start(
        words("rehearse.pilot"),
        {"run", study_.place().file(), "--db", study_.place().sessions(), "--pilot", "--windowed"},
        {}, JobKind::session);
  }
  draw_problem(ui, words, card.left());
}

void RehearsePage::draw_one(const Ui& ui, const study::Texts& words, Column& card) {
  draw_text(ui.look.fonts.title, card.take(36), ui.look.palette.text, words("rehearse.one"));
  card.words(ui.look.fonts.text, ui.look.palette.text, words("rehearse.one_says"), 16);
  if (!button(ui, "one", card.take(48), words("rehearse.one_start"), ButtonKind::filled,
              can_begin())) {
    return;
  }
  begin_afresh();
  services_.jobs.start(words("rehearse.one"),
                       {"run", study_.place().file(), "--db", study_.place().rehearsal(),
                        "--windowed", "--autopilot", std::to_string(seed_++)},
                       {}, JobKind::screen);
}

void RehearsePage::draw_many(const Ui& ui, const study::Texts& words, Column& card) {
  draw_text(ui.look.fonts.title, card.take(36), ui.look.palette.text, words("rehearse.many"));
  card.words(ui.look.fonts.text, ui.look.palette.text, words("rehearse.many_says"), 16);
  Box line = card.take(40);
  draw_text(ui.look.fonts.text, line, ui.look.palette.text, words("rehearse.people"));
  const float wide = ui.layout.size(160);
  number_box(ui, "people", {line.right() - wide, line.y, wide, line.height}, people_, 1, 500,
             now_us_);
  if (button(ui, "many", card.take(48), words("rehearse.many_start"), ButtonKind::filled,
             can_begin())) {
    simulate(words);
  }
  const fs::path page = study_.place().rehearsal_report() / "report.html";
  if (!study::is_there(page)) return;
  if (button(ui, "report", card.take(48), words("rehearse.report"), ButtonKind::outlined)) {
    services_.show(page);
  }
}

void RehearsePage::simulate(const study::Texts& words) {
  begin_afresh();
  services_.jobs.start(
      words("rehearse.many"),
      {"simulate", study_.place().file(), "--participants", std::to_string(people_.value), "--seed",
       "1", "--jobs", "2", "--db", study_.place().rehearsal()},
      [this, &words](const Job& job) {
        if (job.exit_code() == 0) report(words);
      });
}

void RehearsePage::report(const study::Texts& words) {
  const study::StudyPlace& place = study_.place();
  services_.jobs.start(
      words("rehearse.reporting"),
      {"report", place.rehearsal(), "--include-simulated", "--out", place.rehearsal_report()},
      [this](const Job& job) {
        if (job.exit_code() == 0) {
          services_.show(study_.place().rehearsal_report() / "report.html");
        }
      });
}

}  // namespace

std::unique_ptr<DeskPage> make_rehearse_page(DeskServices& services, OpenStudy& study) {
  return std::make_unique<RehearsePage>(services, study);
}

}  // namespace promenade::app
