// [[rating]] and [[questionnaire]]: what is asked, and where in the session.
#include "study/study_parts.h"

namespace promenade::study {
namespace {

Item read_rating(const TomlTable& table, const Study& study) {
  Item item;
  item.name = table.required_text("item");
  table.require("question");
  item.question = read_local_text(table, "question", study);
  item.low = read_local_text(table, "low", study);
  item.high = read_local_text(table, "high", study);
  item.most = static_cast<double>(table.integer("points", 2, 11).value_or(7));
  return item;
}

// All [[rating]] together are one instrument, after each trial that counts.
void read_ratings(const TomlTable& root, Study& study) {
  Instrument instrument;
  instrument.name = "rating";
  instrument.version = study.version;
  std::vector<std::string> names;
  const std::vector<TomlTable> tables = root.tables("rating");
  for (const TomlTable& table : tables) {
    instrument.items.push_back(read_rating(table, study));
    names.push_back(instrument.items.back().name);
  }
  refuse_doubles(tables, names, "rating");
  if (tables.empty()) return;
  study.questionnaires.push_back(
      {static_cast<int>(study.instruments.size()), Questionnaire::When::trial, {}});
  study.instruments.push_back(std::move(instrument));
}

}  // namespace

int InstrumentShelf::find(const TomlTable& table, std::string_view key) {
  const auto name = table.text(key);
  if (!name) return -1;
  table.error(key, "there is no instrument \"" + *name + "\"");
  return -1;
}

void read_questionnaires(const TomlTable& root, InstrumentShelf&, Study& study) {
  read_ratings(root, study);
}

}  // namespace promenade::study
