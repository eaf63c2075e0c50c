#include "analysis/questionnaires.h"

#include <algorithm>
#include <array>

#include "analysis/columns.h"
#include "analysis/item.h"
#include "study/migrate.h"
#include "study/sqlite.h"
#include "study/stored_study.h"

namespace promenade::analysis {
namespace {

using study::Statement;

// Answers of one session, oldest first; what is about a trial that does not count is not
// among them.
std::string query_for(study::Database& database) {
  const auto answer = [&](std::string_view column) {
    return column_or(database, "answer", column, "NULL");
  };
  return "SELECT answer.instrument, answer.version, " + answer("asked") + ", coalesce(" +
         answer("block") + ", 0), coalesce(trial.task, " + answer("task") +
         ", ''), coalesce(trial.interface, " + answer("interface") +
         ", ''), coalesce(trial.target, ''), coalesce(answer.trial, ''), answer.item, "
         "answer.value, answer.text, answer.declined "
         "FROM answer LEFT JOIN trial ON trial.uuid = answer.trial "
         "WHERE answer.session = ? AND answer.touched = 1 AND coalesce(trial.practice, 0) = 0 "
         "AND coalesce(" +
         column_or(database, "trial", "superseded", "0") +
         ", 0) = 0 ORDER BY answer.t_us, answer.item";
}

study::ItemAnswer answer_in(const Statement& row) {
  study::ItemAnswer answer;
  if (!row.is_null(9)) answer.value = row.real(9);
  answer.text = row.text(10);
  answer.declined = row.integer(11) != 0;
  return answer;
}

}  // namespace

std::vector<FilledPage> filled_pages(study::Database& database, const Log& log,
                                     const Selection& selection, int file) {
  Statement row(database, query_for(database));
  std::vector<FilledPage> pages;
  int person = -1;
  for (const Person& one : selection.people) {
    if (one.disposition != Disposition::analysed) continue;
    ++person;
    if (item(log.sessions, one.session).file != file) continue;
    std::map<std::array<std::string, 7>, int> known;
    row.bind(1, item(log.sessions, one.session).uuid);
    while (row.step()) {
      const std::array key = {row.text(0), row.text(1), row.text(2), row.text(3),
                              row.text(4), row.text(5), row.text(7)};
      const auto [found, is_new] = known.emplace(key, size_of(pages));
      if (is_new) {
        pages.push_back({person,
                         row.text(0),
                         row.text(1),
                         row.text(2),
                         row.text(4),
                         row.text(5),
                         row.text(6),
                         {}});
      }
      item(pages, found->second).answers[row.text(8)] = answer_in(row);
    }
    row.reset();
  }
  return pages;
}

const study::Instrument* find_instrument(const std::vector<study::Instrument>& instruments,
                                         std::string_view name, std::string_view version) {
  const auto found = std::find_if(instruments.begin(), instruments.end(), [&](const auto& one) {
    return one.name == name && one.version == version;
  });
  return found == instruments.end() ? nullptr : &*found;
}

std::optional<double> score_of_page(const FilledPage& page, const study::Instrument& instrument,
                                    const study::Score& score) {
  std::vector<study::ItemAnswer> answers;
  for (const study::Item& one : instrument.items) {
    const auto found = page.answers.find(one.name);
    answers.push_back(found == page.answers.end() ? study::ItemAnswer{} : found->second);
  }
  return study::score_of(instrument, score, answers);
}

Questionnaires read_questionnaires(const Log& log, const Selection& selection) {
  Questionnaires all;
  for (int file = 0; file < size_of(log.files); ++file) {
    const std::string& name = item(log.files, file).file;
    try {
      study::Database database = study::open_log(name);
      for (FilledPage& page : filled_pages(database, log, selection, file)) {
        all.pages.push_back(std::move(page));
      }
      for (study::Instrument& one : study::stored_instruments(database)) {
        if (find_instrument(all.instruments, one.name, one.version)) continue;
        all.instruments.push_back(std::move(one));
      }
    } catch (const study::DatabaseError& error) {
      refuse_content(name, error);
    }
  }
  return all;
}

}  // namespace promenade::analysis
