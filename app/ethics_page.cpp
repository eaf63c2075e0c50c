#include "app/ethics_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/document.h"
#include "study/identity.h"
#include "study/schema.h"
#include "study/sqlite.h"

namespace promenade::app {
namespace {

using study::Instrument;
using study::Item;
using study::ItemKind;
using study::LocalText;
using study::Questionnaire;
using study::Study;
using study::Task;
using study::TaskKind;

const std::string& english(const LocalText& text, const std::string& otherwise) {
  const std::string& words = study::text_in(text, "en");
  return words.empty() ? otherwise : words;
}

const std::string& title_of(const Study& study) { return english(study.title, study.name); }

void tell_study(Document& page, const study::StudyBundle& bundle) {
  const Study& study = bundle.study;
  page.heading(1, title_of(study));
  page.paragraph(
      "What this study asks of people, what is stored of them, where and how long, and "
      "how a person is taken out again. Made from the study file itself by Promenade " +
      std::string(study::program_version()) + ".");
  std::vector<Cells> rows = {
      {"study", study.name},
      {"version", study.version},
      {"SHA-256 of all that it shows", bundle.sha256},
      {"planned to take at most", fmt::format("{} minutes", study.most_minutes)}};
  if (study.participants > 0)
    rows.push_back({"people planned", std::to_string(study.participants)});
  page.table({"", ""}, rows);
}

void tell_consent(Document& page, const Study& study) {
  page.heading(2, "What people read and agree to");
  for (const std::string& language : study.languages) {
    const study::Texts texts = study::load_texts(language);
    const std::string& own = study::text_in(study.consent, language);
    page.heading(3, language);
    page.paragraph(own.empty() ? texts("consent.text") : own);
  }
  page.paragraph(
      "Who declines sees the last page at once; that, under the code, is all that is stored.");
}

std::string sentence_of(const Task& task) {
  std::string sentence = task.name + ": ";
  switch (task.kind) {
    case TaskKind::match:
      sentence += "make a walking figure walk like another one";
      break;
    case TaskKind::find:
      sentence += "find a walk with an asked quality";
      break;
    case TaskKind::guess:
      sentence += "guess the settings of a walk without seeing the result";
      break;
    case TaskKind::rate:
      sentence += "answer questions about a walk that is shown";
      break;
  }
  const std::size_t targets = task.targets.size();
  sentence += fmt::format("; {} {}", targets, targets == 1 ? "target" : "targets");
  if (task.limit_s) sentence += fmt::format(", at most {} s each", *task.limit_s);
  return sentence;
}

std::string answers_of(const Item& item) {
  switch (item.kind) {
    case ItemKind::scale:
      return fmt::format("a scale from {} to {}", item.least, item.most);
    case ItemKind::number:
      return fmt::format("a number from {} to {}", item.least, item.most);
    case ItemKind::text:
      return fmt::format("own words, up to {} characters", item.longest);
    case ItemKind::agree:
      return "a box to tick";
    case ItemKind::ranking:
    case ItemKind::choice:
      break;
  }
  std::string choices = item.kind == ItemKind::choice ? "one of: " : "an order of: ";
  for (std::size_t i = 0; i < item.choices.size(); ++i) {
    choices += (i > 0 ? ", " : "") + english(item.choices[i].text, item.choices[i].name);
  }
  return item.interfaces ? choices + "the interfaces" : choices;
}

std::string question_of(const Item& item) {
  if (!study::text_in(item.question, "en").empty()) return study::text_in(item.question, "en");
  if (item.low.empty()) return item.name;
  return english(item.low, "") + " - " + english(item.high, "");
}

std::string freedom_of(const Item& item) {
  if (item.can_decline) return "may be declined";
  return item.needed ? "needed to go on" : "may be left out";
}

constexpr const char* when_asked(Questionnaire::When when) {
  switch (when) {
    case Questionnaire::When::start:
      return "at the start";
    case Questionnaire::When::trial:
      return "after each trial";
    case Questionnaire::When::task:
      return "after each task";
    case Questionnaire::When::block:
      return "after each block";
    case Questionnaire::When::end:
      return "at the end";
  }
  return "";
}

// "at the start", "in the task rating": everywhere it is asked.
std::string times_of(const Study& study, int instrument) {
  std::string times;
  const auto add = [&times](const std::string& time) {
    times += (times.empty() ? "" : ", ") + time;
  };
  for (const Questionnaire& one : study.questionnaires) {
    if (one.instrument == instrument) add(when_asked(one.when));
  }
  for (const Task& task : study.tasks) {
    if (task.instrument == instrument) add("in the task " + task.name);
  }
  return times;
}

void tell_instrument(Document& page, const Study& study, int index) {
  const Instrument& instrument = study.instruments[static_cast<std::size_t>(index)];
  page.heading(3, english(instrument.title, instrument.name));
  std::string source = "Asked " + times_of(study, index) + ".";
  if (!instrument.citation.empty()) source += " Source: " + instrument.citation + ".";
  if (!instrument.terms.empty()) source += " Terms: " + instrument.terms + ".";
  page.paragraph(source);
  std::vector<Cells> rows;
  for (const Item& item : instrument.items) {
    rows.push_back({item.name, question_of(item), answers_of(item), freedom_of(item)});
  }
  page.table({"item", "question", "answer", ""}, rows);
}

void tell_questions(Document& page, const Study& study) {
  page.heading(2, "What people do and are asked");
  std::vector<std::string> tasks;
  for (const Task& task : study.tasks) tasks.push_back(sentence_of(task));
  page.list(tasks);
  for (std::size_t i = 0; i < study.instruments.size(); ++i) {
    tell_instrument(page, study, static_cast<int>(i));
  }
}

bool asks_own_words(const Study& study) {
  const auto is_free = [](const Item& item) { return item.kind == ItemKind::text; };
  return std::any_of(
      study.instruments.begin(), study.instruments.end(), [&](const Instrument& instrument) {
        return std::any_of(instrument.items.begin(), instrument.items.end(), is_free);
      });
}

void tell_never_asked(Document& page, const Study& study) {
  page.heading(2, "What the program never asks or records");
  page.list(
      {"name, address, e-mail, telephone, date of birth: people are known by a code that the "
       "experimenter gives",
       "picture, voice, or what else is on the screen",
       "anything about other programs or files of the computer",
       "it sends nothing over a network"});
  if (!asks_own_words(study)) return;
  page.paragraph(
      "Some questions above take own words, in which people may tell who they are. Read "
      "those answers before they are passed on.");
}

std::vector<Cells> rows_of(study::Database& database, const std::string& table) {
  study::Statement row(database,
                       "SELECT name, coalesce(unit, ''), coalesce(meaning, '') FROM "
                       "pragma_table_info(?1) LEFT JOIN dictionary ON table_name = ?1 AND "
                       "column_name = name ORDER BY cid");
  row.bind(1, table);
  std::vector<Cells> rows;
  while (row.step()) rows.push_back({row.text(0), row.text(1), row.text(2)});
  return rows;
}

void tell_tables(Document& page) {
  page.heading(2, "Everything that is stored");
  page.paragraph(
      "Every table and column of the database. Times within a session are counted from "
      "its begin; only columns with the unit ISO 8601 hold a date.");
  study::Database database(":memory:", study::Database::Mode::create);
  study::create_tables(database);
  study::Statement table(database,
                         "SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY rowid");
  while (table.step()) {
    page.heading(3, table.text(0));
    page.table({"column", "unit", "meaning"}, rows_of(database, table.text(0)));
  }
}

void tell_place(Document& page, const Study& study) {
  page.heading(2, "Where, and how long");
  std::vector<std::string> places = {
      "one file on the computer on which the session runs: results/" + study.name +
          ".db, or where the experimenter says (--db)",
      "only the account that runs the program may read or write it (rights 0600); it is not "
      "encrypted: encrypt the disk, or keep the computer locked"};
  places.push_back(
      study.safety.copy_to.empty()
          ? "no second copy is made"
          : "after each session a second copy with the same rights goes to the folder " +
                study.safety.copy_to + " ([safety] copy_to)");
  places.emplace_back(
      "a newer version of the program that changes the tables keeps a copy of the "
      "file beside it, FILE.v1.backup");
  page.list(places);
  if (study.safety.keep.empty()) {
    page.paragraph(
        "How long the data are kept: the study file does not say. State it there, as keep = "
        "\"10 years after publication\" under [safety], and make this page again.");
  } else {
    page.paragraph("How long the data are kept: " + study.safety.keep + " ([safety] keep).");
  }
  page.paragraph(
      "The program deletes nothing on its own: the researchers delete these files when that "
      "time is over. Who may see them until then is for the researchers to say here.");
}

void tell_withdrawal(Document& page, const Study& study) {
  page.heading(2, "How people withdraw");
  page.paragraph(
      "During the session at any time: Esc, or the button, opens a pause from which the "
      "session can be ended. Afterwards the person tells the code, and the experimenter "
      "calls `promenade withdraw FILE CODE`.");
  const bool keeps = study.safety.withdrawal == study::Withdrawal::link;
  page.paragraph(
      keeps ? "Answers and trials stay, without anything that tells whose they are: the code and "
              "all identifiers are replaced by new random ones, the outcome says withdrawn, and "
              "the dates, the station and the machine are cleared ([safety] withdraw = \"link\")."
            : "Every row of the person is deleted: sessions, trials, events, samples, answers "
              "([safety] withdraw = \"everything\").");
  page.list(
      {"the file is written anew, so that nothing of it can be recovered from the file or "
       "its journal",
       "the second copy and copies of before an update are cleaned as well; the program "
       "remembers those that are out of reach and says so until it is done",
       "a random number without any other content stays (table tombstone), so that the "
       "person does not come back when files of several stations are joined",
       "reports, tables and exports that were made before are files of their own: make them "
       "again"});
}

}  // namespace

std::string ethics_page(const study::StudyBundle& bundle, PageFormat format) {
  std::unique_ptr<Document> page;
  if (format == PageFormat::html) {
    page = std::make_unique<HtmlDocument>();
  } else {
    page = std::make_unique<MarkdownDocument>();
  }
  tell_study(*page, bundle);
  tell_consent(*page, bundle.study);
  tell_questions(*page, bundle.study);
  tell_never_asked(*page, bundle.study);
  tell_place(*page, bundle.study);
  tell_withdrawal(*page, bundle.study);
  tell_tables(*page);
  return page->take(title_of(bundle.study));
}

}  // namespace promenade::app
