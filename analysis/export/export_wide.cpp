#include "analysis/export/export_wide.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "analysis/item.h"
#include "study/csv.h"

namespace promenade::analysis {
namespace {

using study::Statement;

// Columns of `trial` that a report does not compare but an analysis may want.
constexpr std::array bare_columns = {"d_sum", "late_frames"};

// Adds those that the data set does not have yet.
class BareColumns {
 public:
  BareColumns(const ExportSource& source, Dataset& data) : source_(source), data_(data) {
    for (const char* column : bare_columns) {
      if (data.measure(column) >= 0 || !has_column(source.database, "trial", column)) continue;
      names_.emplace_back(column);
    }
  }

  void add() {
    if (names_.empty()) return;
    const std::size_t first = data_.measures.size();
    for (const std::string& name : names_) {
      const std::string unit = described(source_.database, "trial", name).unit;
      data_.measures.push_back({name, name, unit, unit, 1, 1});
    }
    for (Trial& trial : data_.trials) trial.values.resize(data_.measures.size());
    read(first);
  }

 private:
  void read(std::size_t first) {
    std::map<std::pair<int, int>, Trial*> trial_at;
    for (Trial& trial : data_.trials) trial_at[{trial.person, trial.position}] = &trial;
    Statement row(source_.database, query());
    int person = 0;
    for (const Person& one : source_.selection.people) {
      if (one.disposition != Disposition::analysed) continue;
      row.bind(1, item(source_.log.sessions, one.session).uuid);
      while (row.step()) {
        const auto found = trial_at.find({person, static_cast<int>(row.integer(0))});
        if (found != trial_at.end()) put(row, first, *found->second);
      }
      row.reset();
      ++person;
    }
  }

  std::string query() const {
    std::string sql = "SELECT position";
    for (const std::string& name : names_) sql += ", " + name;
    return sql + " FROM trial WHERE session = ? AND practice = 0 AND " +
           column_or(source_.database, "trial", "superseded", "0") + " = 0";
  }

  void put(const Statement& row, std::size_t first, Trial& trial) const {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const int column = static_cast<int>(i) + 1;
      if (!row.is_null(column)) trial.values[first + i] = row.real(column);
    }
  }

  const ExportSource& source_;
  Dataset& data_;
  std::vector<std::string> names_;
};

// What is said of a column stands in the order in which it is wanted.
std::string joined(const std::vector<std::string>& parts) {
  std::string name;
  for (const std::string& part : parts) {
    if (!part.empty()) name += (name.empty() ? "" : ".") + part;
  }
  return name;
}

std::string about(const WideColumn& column) {
  std::string text;
  const auto add = [&](const char* what, const std::string& name) {
    if (!name.empty()) text += std::string("; ") + what + " " + name;
  };
  add("task", column.task);
  add("interface", column.interface);
  add("target", column.target);
  return text;
}

std::string meaning_of(const ExportSource& source, const Measure& measure) {
  if (measure.name == "time_s") {
    return "time from the start of the trial to its end without pauses, restricted to the limit";
  }
  const std::string meaning = described(source.database, "trial", measure.name).meaning;
  return meaning.empty() ? "answer to " + measure.label : meaning;
}

// Columns of numbers that are averaged, or of words.
class Columns {
 public:
  explicit Columns(std::size_t people) : people_(people) {}

  // `order`: where the column stands among the others.
  void add(const std::vector<int>& order, const WideColumn& column, int person, double value) {
    Values& values = at(order, column).values[static_cast<std::size_t>(person)];
    values.sum += value;
    ++values.count;
  }
  void add(const std::vector<int>& order, const WideColumn& column, int person,
           const std::string& words) {
    at(order, column).values[static_cast<std::size_t>(person)].words = words;
  }

  std::vector<WideColumn> take() {
    std::vector<WideColumn> columns;
    for (auto& [key, one] : columns_) {
      for (const Values& values : one.values) one.column.cells.push_back(cell(values));
      columns.push_back(std::move(one.column));
    }
    return columns;
  }

 private:
  struct Values {
    double sum = 0;
    int count = 0;
    std::string words;
  };
  struct Column {
    WideColumn column;
    std::vector<Values> values;
  };

  Column& at(const std::vector<int>& order, const WideColumn& column) {
    Column& one = columns_[{order, column.name}];
    if (one.values.empty()) {
      one.column = column;
      one.values.resize(people_);
    }
    return one;
  }
  static std::string cell(const Values& values) {
    if (!values.words.empty()) return values.words;
    return values.count > 0 ? study::csv_number(values.sum / values.count) : "";
  }

  std::size_t people_;
  std::map<std::pair<std::vector<int>, std::string>, Column> columns_;
};

int place_of(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}

class WideMaker {
 public:
  explicit WideMaker(const ExportSource& source)
      : source_(source), data_(make_dataset(source.log, source.selection)) {
    BareColumns(source, data_).add();
    table_.people = data_.people;
    for (const Person& person : source.selection.people) {
      if (person.disposition != Disposition::analysed) continue;
      table_.simulated.push_back(person.simulated);
      table_.pilot.push_back(person.pilot);
    }
  }

  WideTable make() {
    add_measures();
    add_answers();
    name_apart();
    return std::move(table_);
  }

 private:
  void add_measures() {
    for (int task = 0; task < size_of(data_.tasks); ++task) {
      for (int measure = 0; measure < size_of(data_.measures); ++measure) {
        for (int interface = 0; interface < size_of(data_.interfaces); ++interface) {
          add_means(measure, interface, task);
        }
      }
    }
  }

  void add_means(int measure, int interface, int task) {
    add_mean(measure, interface, task, -1);
    for (int target = 0; target < size_of(item(data_.tasks, task).targets); ++target) {
      add_mean(measure, interface, task, target);
    }
  }

  void add_mean(int measure, int interface, int task, int target) {
    WideColumn column;
    column.measure = item(data_.measures, measure).name;
    column.task = item(data_.tasks, task).name;
    column.interface = item(data_.interfaces, interface);
    if (target >= 0) column.target = item(item(data_.tasks, task).targets, target);
    column.unit = item(data_.measures, measure).unit;
    column.meaning = meaning_of(source_, item(data_.measures, measure)) + about(column) +
                     (target < 0 ? "; mean over targets" : "");
    column.name = joined({column.measure, column.task, column.interface, column.target});
    bool any = false;
    for (const auto& mean : mean_per_person(data_, measure, interface, task, target)) {
      column.cells.push_back(mean ? study::csv_number(*mean) : "");
      any = any || mean;
    }
    if (any) table_.columns.push_back(std::move(column));
  }

  void add_answers() {
    const std::vector<FilledPage> pages = filled_pages(source_.database, source_.log, source_.selection);
    std::map<std::string, std::set<std::string>> moments;
    for (const FilledPage& page : pages) moments[page.instrument].insert(page.asked);
    Columns columns(data_.people.size());
    for (const FilledPage& page : pages) {
      const bool several = moments[page.instrument].size() > 1;
      if (page.target.empty()) add_items(page, several ? page.asked : "", columns);
      add_scores(page, several ? page.asked : "", columns);
    }
    for (WideColumn& column : columns.take()) table_.columns.push_back(std::move(column));
  }

  WideColumn column_for(const FilledPage& page, const std::string& what,
                        const std::string& moment) const {
    WideColumn column;
    column.measure = joined({page.instrument, what, moment});
    column.task = page.task;
    column.interface = page.interface;
    column.name = joined({column.measure, column.task, column.interface});
    return column;
  }

  std::vector<int> order_of(const FilledPage& page, int kind, int place) const {
    int instrument = 0;
    while (instrument < size_of(source_.instruments) &&
           item(source_.instruments, instrument).name != page.instrument) {
      ++instrument;
    }
    std::vector<std::string> tasks;
    for (const Task& task : data_.tasks) tasks.push_back(task.name);
    return {instrument, kind, place, place_of(tasks, page.task),
            place_of(data_.interfaces, page.interface)};
  }

  // Answers about single trials are among the measures.
  void add_items(const FilledPage& page, const std::string& moment, Columns& columns) const {
    const study::Instrument* instrument =
        find_instrument(source_.instruments, page.instrument, page.version);
    for (const auto& [name, answer] : page.answers) {
      const std::string base = name.substr(0, name.find(':'));
      const study::Item* asked = instrument ? study::find_item(*instrument, base) : nullptr;
      WideColumn column = column_for(page, name, moment);
      column.meaning = (asked && !asked->question.empty() ? study::text_in(asked->question, "en")
                                                          : "answer to " + name) +
                       about(column);
      const int place = asked ? static_cast<int>(asked - instrument->items.data()) : 0;
      const std::vector<int> order = order_of(page, 0, place);
      if (!answer.text.empty()) {
        columns.add(order, column, page.person, answer.text);
      } else if (answer.value) {
        columns.add(order, column, page.person, *answer.value);
      }
    }
  }

  void add_scores(const FilledPage& page, const std::string& moment, Columns& columns) const {
    const study::Instrument* instrument =
        find_instrument(source_.instruments, page.instrument, page.version);
    if (!instrument) return;
    for (int i = 0; i < size_of(instrument->scores); ++i) {
      const study::Score& score = item(instrument->scores, i);
      const auto value = score_of_page(page, *instrument, score);
      if (!value) continue;
      WideColumn column = column_for(page, score.name, moment);
      column.meaning = "score " + score.name + " of " + page.instrument + about(column);
      columns.add(order_of(page, 1, i), column, page.person, *value);
      if (page.target.empty()) continue;
      column.target = page.target;
      column.name = joined({column.name, page.target});
      columns.add(order_of(page, 2, i), column, page.person, *value);
    }
  }

  // Names with dots in them may meet.
  void name_apart() {
    std::map<std::string, int> times;
    for (WideColumn& column : table_.columns) {
      const int time = ++times[column.name];
      if (time > 1) column.name += "_" + std::to_string(time);
    }
  }

  const ExportSource& source_;
  Dataset data_;
  WideTable table_;
};

std::string flag(bool value) { return value ? "1" : "0"; }

}  // namespace

WideTable make_wide(const ExportSource& source) { return WideMaker(source).make(); }

std::string wide_csv(const WideTable& table) {
  std::vector<std::string> cells = {"participant_code", "simulated", "pilot"};
  for (const WideColumn& column : table.columns) cells.push_back(column.name);
  std::string csv = study::csv_line(cells);
  for (std::size_t i = 0; i < table.people.size(); ++i) {
    cells = {table.people[i], flag(table.simulated[i]), flag(table.pilot[i])};
    for (const WideColumn& column : table.columns) cells.push_back(column.cells[i]);
    csv += study::csv_line(cells);
  }
  return csv;
}

std::string long_csv(const WideTable& table) {
  std::string csv = study::csv_line({"participant_code", "simulated", "pilot", "measure", "task",
                                     "interface", "target", "unit", "value"});
  for (std::size_t i = 0; i < table.people.size(); ++i) {
    for (const WideColumn& column : table.columns) {
      if (column.cells[i].empty()) continue;
      csv += study::csv_line({table.people[i], flag(table.simulated[i]), flag(table.pilot[i]),
                              column.measure, column.task, column.interface, column.target,
                              column.unit, column.cells[i]});
    }
  }
  return csv;
}

std::vector<ExportColumn> wide_codebook(const WideTable& table, const std::string& wide_file,
                                        const std::string& long_file) {
  std::vector<ExportColumn> rows;
  for (const std::string& file : {wide_file, long_file}) {
    rows.push_back({file, "participant_code", "", "code of the person"});
    rows.push_back({file, "simulated", "0/1", "1: no person, a simulated participant"});
    rows.push_back({file, "pilot", "0/1", "1: a trial run"});
  }
  rows.push_back({long_file, "measure", "", "what was measured or asked"});
  rows.push_back({long_file, "task", "", "in which task; empty: none alone"});
  rows.push_back({long_file, "interface", "", "with which interface; empty: none alone"});
  rows.push_back({long_file, "target", "", "for which target; empty: the mean over targets"});
  rows.push_back({long_file, "unit", "", "of the value"});
  rows.push_back({long_file, "value", "", "the value, in that unit"});
  for (const WideColumn& column : table.columns) {
    rows.push_back({wide_file, column.name, column.unit, column.meaning});
  }
  return rows;
}

}  // namespace promenade::analysis
