#include "app/desk/results/results_people.h"

#include <algorithm>
#include <filesystem>

#include "app/desk/table.h"
#include "motion/files.h"
#include "study/identity.h"
#include "study/migrate.h"

namespace promenade::app {
namespace {

constexpr TableColumn columns[] = {
    {"results.person", 0.02f, 0.26f}, {"results.kind", 0.26f, 0.4f},
    {"results.ended", 0.4f, 0.56f},   {"results.trials", 0.56f, 0.66f},
    {"results.date", 0.66f, 0.82f},   {"results.report", 0.82f, 1},
};

}  // namespace

// Of all stations, once they were joined.
std::filesystem::path ResultsPeople::database() const {
  return study::is_there(place_.merged()) ? place_.merged() : place_.sessions();
}

void ResultsPeople::read_exclusions() {
  exclusions_.clear();
  exclusions_trouble_.clear();
  if (!study::is_there(place_.exclusions())) return;
  try {
    exclusions_ = analysis::parse_exclusions(place_.exclusions(), read_file(place_.exclusions()));
  } catch (const std::exception& error) {
    exclusions_trouble_ = error.what();
  }
}

void ResultsPeople::read() {
  sessions_.clear();
  trouble_.clear();
  try {
    if (study::is_there(database())) {
      study::Database log = study::open_log(database());
      sessions_ = study::list_sessions(log);
    }
  } catch (const std::exception& error) {
    trouble_ = error.what();
  }
  read_exclusions();
  shown_ = {trouble_, exclusions_trouble_};
  for (const study::ListedSession& one : sessions_) shown_.push_back(one.participant);
  for (const analysis::Exclusion& one : exclusions_) shown_.push_back(one.reason);
}

bool ResultsPeople::has_simulated() const {
  return std::any_of(sessions_.begin(), sessions_.end(),
                     [](const study::ListedSession& one) { return one.simulated; });
}

const study::ListedSession* ResultsPeople::chosen() const {
  for (const study::ListedSession& one : sessions_) {
    if (one.uuid == chosen_) return &one;
  }
  return nullptr;
}

const analysis::Exclusion* ResultsPeople::exclusion_of(const std::string& code) const {
  for (const analysis::Exclusion& one : exclusions_) {
    if (one.code == code) return &one;
  }
  return nullptr;
}

// As they are in the file now: another desk, or a person, may have written there. A file that
// cannot be read is not written over.
void ResultsPeople::change_exclusions(
    const std::function<void(std::vector<analysis::Exclusion>& all)>& change) {
  read_exclusions();
  if (!exclusions_trouble_.empty()) return;
  change(exclusions_);
  try {
    write_file(place_.exclusions(), analysis::exclusions_csv(exclusions_));
  } catch (const OutsideError& error) {
    exclusions_trouble_ = error.what();
  }
}

void ResultsPeople::draw_row(const Ui& ui, const study::Texts& words,
                             const study::ListedSession& one, const Box& box) {
  const Palette& palette = ui.look.palette;
  const bool marked = one.uuid == chosen_;
  fill(box, marked ? palette.known : palette.panel);
  if (tile(ui, "person", one.participant, box) && !marked) {
    chosen_ = one.uuid;
    reason_ = code_again_ = {};
  }
  const auto cell = [&](std::size_t column, const Rgb& colour, std::string_view text) {
    draw_line(ui.look.fonts.text, cell_of(box, columns[column]), colour, text);
  };
  cell(0, palette.text, one.participant);
  cell(1, one.pilot ? palette.pilot : palette.quiet,
       words(one.simulated ? "results.simulated"
             : one.pilot   ? "results.pilot"
                           : "results.counts"));
  cell(2, palette.text, words("results.outcome." + one.outcome));
  cell(3, palette.quiet, std::to_string(one.trials));
  cell(4, palette.quiet, one.started_utc.substr(0, 10));
  if (exclusion_of(one.participant) != nullptr) {
    cell(5, palette.alarm, words("results.excluded"));
  }
}

void ResultsPeople::draw_list(const Ui& ui, const study::Texts& words, const Box& box) {
  const Palette& palette = ui.look.palette;
  if (sessions_.empty()) {
    Column column(ui, inside(ui, box, 32));
    column.skip(80);
    column.words(ui.look.fonts.reading, trouble_.empty() ? palette.quiet : palette.alarm,
                 trouble_.empty() ? words("results.nobody") : trouble_);
    return;
  }
  draw_table(ui, words, "people", box, columns, ui.layout.size(40), sessions_.size(),
             [&](std::size_t i, const Box& row) { draw_row(ui, words, sessions_[i], row); });
}

void ResultsPeople::draw_chosen(const Ui& ui, const study::Texts& words, Column& column,
                                std::int64_t now_us) {
  const study::ListedSession* const one = chosen();
  if (one == nullptr) {
    return column.words(ui.look.fonts.text, ui.look.palette.quiet, words("results.choose"));
  }
  draw_line(ui.look.fonts.title, column.take(36), ui.look.palette.text, one->participant);
  draw_exclusion(ui, words, column, now_us);
  draw_withdrawal(ui, words, column, now_us);
  if (!trouble_.empty()) column.words(ui.look.fonts.text, ui.look.palette.alarm, trouble_);
}

void ResultsPeople::draw_exclusion(const Ui& ui, const study::Texts& words, Column& column,
                                   std::int64_t now_us) {
  const std::string code = chosen()->participant;
  if (!exclusions_trouble_.empty()) {
    return column.words(ui.look.fonts.text, ui.look.palette.alarm, exclusions_trouble_, 20);
  }
  if (const analysis::Exclusion* const exclusion = exclusion_of(code)) {
    column.words(ui.look.fonts.text, ui.look.palette.text,
                 words.with("results.excluded_says",
                            {{"reason", exclusion->reason}, {"date", exclusion->date}}),
                 8);
    if (button(ui, "include", column.take(40, 20), words("results.include"),
               ButtonKind::outlined)) {
      change_exclusions([&](std::vector<analysis::Exclusion>& all) {
        std::erase_if(all, [&](const analysis::Exclusion& one) { return one.code == code; });
      });
    }
    return;
  }
  column.words(ui.look.fonts.text, ui.look.palette.text, words("results.exclude_says"), 8);
  text_box(ui, "exclude.reason", column.take(40), reason_,
           {.most = 200, .several = false, .hint = words("results.reason").c_str()}, now_us);
  const std::string reason = reason_.text.words();
  const bool pressed = button(ui, "exclude", column.take(40, 20), words("results.exclude"),
                              ButtonKind::outlined, !reason.empty());
  if (reason.empty() || !(pressed || reason_.entered)) return;
  analysis::Exclusion exclusion;
  exclusion.code = code;
  exclusion.reason = reason;
  exclusion.date = study::utc_now().substr(0, 10);
  change_exclusions([&](std::vector<analysis::Exclusion>& all) { all.push_back(exclusion); });
  if (exclusions_trouble_.empty()) reason_ = {};
}

void ResultsPeople::draw_withdrawal(const Ui& ui, const study::Texts& words, Column& column,
                                    std::int64_t now_us) {
  const std::string code = chosen()->participant;
  column.words(ui.look.fonts.text, ui.look.palette.text, words("results.withdraw_says"), 8);
  text_box(ui, "withdraw.code", column.take(40), code_again_,
           {.most = 64, .several = false, .hint = words("results.code_again").c_str()}, now_us);
  if (button(ui, "withdraw", column.take(40, 20), words("results.withdraw"), ButtonKind::outlined,
             code_again_.text.words() == code && !services_.jobs.busy())) {
    code_again_ = {};
    withdraw(words, code);
  }
}

// Also from what was joined of it: there it would come back otherwise.
void ResultsPeople::withdraw(const study::Texts& words, const std::string& code) {
  const std::string& name = words("results.withdrawing");
  const auto from_merged = [this, name, code] {
    if (!study::is_there(place_.merged())) return read();
    services_.jobs.start(name, {"withdraw", place_.merged(), code}, [this](const Job&) { read(); });
  };
  if (!study::is_there(place_.sessions())) return from_merged();
  services_.jobs.start(name, {"withdraw", place_.sessions(), code},
                       [this, from_merged](const Job& job) {
                         if (job.exit_code() == 0) return from_merged();
                         read();
                       });
}

}  // namespace promenade::app
