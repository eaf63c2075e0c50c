// Results: the report, the data for others, the people behind them and those who are still to come.
#include <filesystem>

#include "app/choice.h"
#include "app/desk/column.h"
#include "app/desk/pages.h"
#include "app/desk/results/results_people.h"
#include "app/desk/results/results_roster.h"
#include "app/scroll_area.h"

namespace promenade::app {
namespace {

namespace fs = std::filesystem;

class ResultsPage : public DeskPage {
 public:
  ResultsPage(DeskServices& services, OpenStudy& study)
      : services_(services),
        study_(study),
        people_(services, study.place()),
        roster_(services, study) {}

  void advance(std::int64_t now_us) override;
  void draw(const Ui& ui, const study::Texts& words, const Box& room) override;
  void dropped(const std::vector<std::string>& paths) override;
  const std::vector<std::string>& shown_words() const override { return shown_; }

 private:
  enum class Side { data, chosen };

  void draw_data(const Ui& ui, const study::Texts& words, Column& column);
  void draw_stations(const Ui& ui, const study::Texts& words, Column& column);
  void report(const study::Texts& words);
  void add_kinds(std::vector<std::string>& command) const;
  void export_data(const study::Texts& words, bool open);
  // First what is new at this station goes into what was joined; `then` gets the database to read.
  void with_all_stations(const study::Texts& words,
                         const std::function<void(const fs::path& database)>& then);

  DeskServices& services_;
  OpenStudy& study_;
  ResultsPeople people_;
  ResultsRoster roster_;
  bool rostered_ = false;  // the list is the roster
  bool pilots_ = false;    // are in the report
  bool simulated_ = false;
  Draft other_station_;
  int number_ = -1;
  float high_ = 0;  // of the right side, pixels, as it was drawn last
  std::vector<std::string> shown_;
  std::int64_t now_us_ = 0;
};

void ResultsPage::advance(std::int64_t now_us) {
  now_us_ = now_us;
  if (study_.number() == number_) return;
  number_ = study_.number();
  people_.read();
  roster_.read();
}

void ResultsPage::dropped(const std::vector<std::string>& paths) {
  if (!paths.empty()) other_station_.text.set(paths.front());
}

void ResultsPage::draw(const Ui& ui, const study::Texts& words, const Box& room) {
  shown_ = people_.shown_words();
  shown_.insert(shown_.end(), roster_.shown_words().begin(), roster_.shown_words().end());
  const Box inner = inside(ui, room, 16);
  const float wide = ui.layout.size(400);
  const float gap = ui.layout.size(16);
  const Box panel{inner.right() - wide, inner.y, wide, inner.height};
  const Box left{inner.x, inner.y, panel.x - inner.x - gap, inner.height};
  Column column(ui, left);
  const std::string lists[] = {words("results.people"), words("results.roster")};
  Box line = column.take(40, 12);
  line.width = ui.layout.size(320);
  if (const auto picked = choice_row(ui, "list", line, lists, rostered_ ? 1 : 0)) {
    rostered_ = *picked == 1;
  }
  if (rostered_) {
    roster_.draw_list(ui, words, column.left());
  } else {
    people_.draw_list(ui, words, column.left());
  }
  fill(panel, ui.look.palette.panel);
  scrolled("results", panel, high_, [&](const Box& all) {
    Column right(ui, inside(ui, all, 24));
    draw_data(ui, words, right);
    if (rostered_) {
      roster_.draw_chosen(ui, words, right, now_us_);
    } else {
      people_.draw_chosen(ui, words, right, now_us_);
      right.skip(12);
      draw_stations(ui, words, right);
    }
    high_ = right.left().y - all.y + ui.layout.size(24);
  });
}

void ResultsPage::draw_data(const Ui& ui, const study::Texts& words, Column& column) {
  const study::StudyPlace& place = study_.place();
  const bool any = study::is_there(place.sessions()) || study::is_there(place.merged());
  const bool can = any && !services_.jobs.busy();
  draw_text(ui.look.fonts.title, column.take(36), ui.look.palette.text, words("results.report"));
  if (check_box(ui, "pilots", column.take(32), words("results.with_pilots"), pilots_)) {
    pilots_ = !pilots_;
  }
  if (people_.has_simulated() &&
      check_box(ui, "simulated", column.take(32), words("results.with_simulated"), simulated_)) {
    simulated_ = !simulated_;
  }
  if (button(ui, "report", column.take(48), words("results.make_report"), ButtonKind::filled,
             can)) {
    report(words);
  }
  const fs::path page = place.report() / "report.html";
  if (study::is_there(page) && button(ui, "open_report", column.take(40),
                                      words("results.open_report"), ButtonKind::outlined)) {
    services_.show(page);
  }
  const Box row = column.take(40, 24);
  if (button(ui, "export", part_of_row(ui, row, 0, 2), words("results.export"),
             ButtonKind::outlined, can)) {
    export_data(words, false);
  }
  if (button(ui, "publish", part_of_row(ui, row, 1, 2), words("results.publish"),
             ButtonKind::outlined, can)) {
    export_data(words, true);
  }
}

void ResultsPage::draw_stations(const Ui& ui, const study::Texts& words, Column& column) {
  draw_text(ui.look.fonts.title, column.take(36), ui.look.palette.text, words("results.merge"));
  column.words(ui.look.fonts.text, ui.look.palette.quiet, words("results.merge_says"), 8);
  text_box(ui, "station", column.take(40), other_station_,
           {.most = 500, .several = false, .hint = words("results.merge_hint").c_str()}, now_us_);
  const std::string other = other_station_.text.words();
  if (!button(ui, "merge", column.take(44), words("results.merge_start"), ButtonKind::outlined,
              !other.empty() && !services_.jobs.busy())) {
    return;
  }
  const study::StudyPlace& place = study_.place();
  std::vector<std::string> command{"merge", place.merged()};
  if (study::is_there(place.sessions())) command.emplace_back(place.sessions());
  command.push_back(other);
  services_.jobs.start(words("results.merging"), command, [this](const Job& job) {
    if (job.exit_code() == 0) other_station_ = {};
    people_.read();
  });
}

void ResultsPage::with_all_stations(const study::Texts& words,
                                    const std::function<void(const fs::path& database)>& then) {
  const study::StudyPlace& place = study_.place();
  if (!study::is_there(place.merged())) return then(place.sessions());
  if (!study::is_there(place.sessions())) return then(place.merged());
  services_.jobs.start(words("results.merging"), {"merge", place.merged(), place.sessions()},
                       [then, merged = place.merged()](const Job& job) {
                         if (job.exit_code() == 0) then(merged);
                       });
}

void ResultsPage::add_kinds(std::vector<std::string>& command) const {
  if (pilots_) command.emplace_back("--include-pilot");
  if (simulated_) command.emplace_back("--include-simulated");
}

void ResultsPage::report(const study::Texts& words) {
  with_all_stations(words, [this, &words](const fs::path& database) {
    const study::StudyPlace& place = study_.place();
    std::vector<std::string> command{"report", database, "--out", place.report()};
    add_kinds(command);
    if (study::is_there(place.exclusions())) {
      command.insert(command.end(), {"--exclude", place.exclusions()});
    }
    services_.jobs.start(words("results.reporting"), command,
                         [this, page = place.report() / "report.html"](const Job& job) {
                           if (job.exit_code() == 0) services_.show(page);
                         });
  });
}

void ResultsPage::export_data(const study::Texts& words, bool open) {
  with_all_stations(words, [this, &words, open](const fs::path& database) {
    const study::StudyPlace& place = study_.place();
    const fs::path folder = open ? place.public_data() : place.data();
    std::vector<std::string> command{"export", database, "--out", folder};
    if (open) command.emplace_back("--public");
    add_kinds(command);
    services_.jobs.start(words("results.exporting"), command, [this, folder](const Job& job) {
      if (job.exit_code() == 0) services_.show(folder);
    });
  });
}

}  // namespace

std::unique_ptr<DeskPage> make_results_page(DeskServices& services, OpenStudy& study) {
  return std::make_unique<ResultsPage>(services, study);
}

}  // namespace promenade::app
