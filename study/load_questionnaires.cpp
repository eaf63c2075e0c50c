// [[rating]] and [[questionnaire]]: what is asked, and where in the session.
#include <algorithm>

#include "motion/did_you_mean.h"
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

// What participants call the interfaces: their titles, with the name of the condition where
// two have one.
std::vector<Choice> interface_choices(const Study& study, const StudyTexts& all_texts) {
  std::vector<Choice> choices;
  for (const InterfaceUse& use : study.interfaces) {
    Choice choice{use.name, {}};
    const auto alike = std::count_if(study.interfaces.begin(), study.interfaces.end(),
                                     [&use](auto& other) { return other.type == use.type; });
    for (const std::string& language : study.languages) {
      const Texts texts = texts_in(all_texts, language);
      const std::string* title = texts.find("interface." + use.type + ".title");
      choice.text[language] = title == nullptr ? use.name : *title;
      if (title != nullptr && alike > 1) choice.text[language] += " (" + use.name + ")";
    }
    choices.push_back(std::move(choice));
  }
  return choices;
}

Questionnaire::When when_of(const std::optional<std::string>& word) {
  using When = Questionnaire::When;
  if (word == "start") return When::start;
  if (word == "trial") return When::trial;
  if (word == "task") return When::task;
  return word == "block" ? When::block : When::end;
}

std::vector<int> read_tasks_of(const TomlTable& table, const Study& study) {
  std::vector<std::string> names;
  for (const Task& task : study.tasks) names.push_back(task.name);
  std::vector<int> tasks;
  for (const TomlText& entry : table.texts("tasks")) {
    const auto found = std::find(names.begin(), names.end(), entry.text);
    if (found == names.end()) {
      table.reader().add(entry.place, "there is no [[task]] with the name \"" + entry.text + "\"" +
                                          did_you_mean(entry.text, names));
    } else {
      tasks.push_back(static_cast<int>(found - names.begin()));
    }
  }
  return tasks;
}

void read_questionnaire(const TomlTable& table, InstrumentShelf& instruments, Study& study) {
  Questionnaire questionnaire;
  table.require("instrument");
  questionnaire.instrument = instruments.find(table, "instrument");
  table.require("when");
  const auto when = table.choice("when", {"start", "trial", "task", "block", "end"});
  questionnaire.when = when_of(when);
  questionnaire.tasks = read_tasks_of(table, study);
  const bool by_task = questionnaire.when == Questionnaire::When::trial ||
                       questionnaire.when == Questionnaire::When::task;
  if (when && !by_task && table.has("tasks")) {
    table.error("tasks", R"("tasks" goes with when = "trial" or when = "task")");
  }
  if (questionnaire.instrument >= 0) study.questionnaires.push_back(std::move(questionnaire));
}

// A file of the study's own; else a name that the program knows.
bool is_own(const std::string& name) {
  return name.size() >= 5 && name.compare(name.size() - 5, 5, ".toml") == 0;
}

}  // namespace

int InstrumentShelf::add(Instrument instrument) {
  study_.instruments.push_back(std::move(instrument));
  return static_cast<int>(study_.instruments.size()) - 1;
}

int InstrumentShelf::find(const TomlTable& table, std::string_view key) {
  const auto name = table.text(key);
  if (!name) return -1;
  const auto known = known_.find(*name);
  if (known != known_.end()) return known->second;
  try {
    InstrumentFile read = is_own(*name) ? read_own(*name) : read_builtin(*name);
    table.reader().add(read.warnings);
    return known_[*name] =
               add(with_interfaces(std::move(read.instrument), interface_choices(study_, texts_)));
  } catch (const InputError& error) {
    add_file_problems(table, key, "the instrument \"" + *name + "\"", error);
  }
  return known_[*name] = -1;
}

InstrumentFile InstrumentShelf::read_own(const std::string& name) {
  return read_instrument(files_.full_path(name), files_.read(name), study_.languages);
}

InstrumentFile InstrumentShelf::read_builtin(const std::string& name) {
  const std::string path = "instruments/" + name + ".toml";
  const std::string* text = nullptr;
  try {
    text = &files_.read_builtin(path);
  } catch (const InputError&) {
    return load_instrument(name, "", study_.languages);  // says which there are
  }
  return read_instrument("configs/" + path, *text, study_.languages);
}

void read_questionnaires(const TomlTable& root, InstrumentShelf& instruments, Study& study) {
  read_ratings(root, study);
  for (const TomlTable& table : root.tables("questionnaire")) {
    read_questionnaire(table, instruments, study);
  }
}

}  // namespace promenade::study
