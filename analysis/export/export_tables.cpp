#include "analysis/export/export_tables.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <map>

#include "analysis/item.h"
#include "motion/problem.h"
#include "motion/set_file.h"
#include "study/csv.h"

namespace promenade::analysis {
namespace {

namespace fs = std::filesystem;
using study::Database;
using study::Statement;

// How the rows of one session are found in a table, and in which order they stand.
struct SessionTable {
  const char* table;
  const char* rows;  // FROM ... WHERE ..., ? is the session
  const char* order;
};

constexpr SessionTable session_tables[] = {
    {"session", "session WHERE session.uuid = ?", "1"},
    {"trial", "trial WHERE trial.session = ?", "trial.started_us, trial.position, trial.uuid"},
    {"event", "event WHERE event.session = ?", "event.seq"},
    {"sample", "trial JOIN sample ON sample.trial = trial.uuid WHERE trial.session = ?",
     "trial.started_us, trial.position, trial.uuid, sample.t_us"},
    {"answer", "answer WHERE answer.session = ?", "answer.t_us, answer.instrument, answer.item"},
    {"frame_histogram", "frame_histogram WHERE frame_histogram.session = ?",
     "frame_histogram.trial, frame_histogram.least_us"},
};

const SessionTable* session_table(std::string_view table) {
  for (const SessionTable& one : session_tables) {
    if (one.table == table) return &one;
  }
  return nullptr;
}

// A file that grows row by row.
class CsvFile {
 public:
  explicit CsvFile(const fs::path& path) : path_(path), out_(path, std::ios::binary) {}
  void add(const std::vector<std::string>& cells) {
    out_ << study::csv_line(cells);
    if (!out_) refuse();
  }
  void close() {
    out_.close();
    if (!out_) refuse();
  }

 private:
  [[noreturn]] void refuse() const {
    throw OutsideError("cannot write " + path_.string() + "; choose another place or make room");
  }
  fs::path path_;
  std::ofstream out_;
};

std::string cell_of(const Statement& row, int column) {
  switch (row.type(column)) {
    case Statement::Type::integer:
      return std::to_string(row.integer(column));
    case Statement::Type::real:
      return study::csv_number(row.real(column));
    case Statement::Type::text:
      return row.text(column);
    case Statement::Type::null:
    case Statement::Type::blob:
      break;
  }
  return "";
}

// The motions that the weights of samples are about: those of all sets, each name once.
class WeightColumns {
 public:
  explicit WeightColumns(Database& database) {
    Statement row(database, "SELECT sha256, content FROM main.motion_set ORDER BY uuid");
    while (row.step()) add_set(row.text(0), row.blob(1), database.file());
    if (names_.empty()) number_them(database);
    Statement study(database,
                    "SELECT study.uuid, motion_set.sha256 FROM study JOIN motion_set "
                    "ON motion_set.uuid = coalesce(" +
                        column_or(database, "study", "motion_set", "NULL") + ", motion_set.uuid)");
    while (study.step()) set_of_study_[study.text(0)] = study.text(1);
  }

  const std::vector<std::string>& names() const { return names_; }

  void add_cells(std::string_view weights, const std::string& study,
                 std::vector<std::string>& cells) const {
    const std::size_t first = cells.size();
    cells.resize(first + names_.size());
    const std::vector<int>& places = places_in(study);
    for (std::size_t i = 0; i < places.size() && (i + 1) * sizeof(double) <= weights.size(); ++i) {
      double weight = 0;
      std::memcpy(&weight, weights.data() + i * sizeof weight, sizeof weight);
      cells[first + static_cast<std::size_t>(places[i])] = study::csv_number(weight);
    }
  }

 private:
  void add_set(const std::string& sha256, std::string_view content, const std::string& file) {
    try {
      std::vector<int>& places = places_[sha256];
      for (const std::string& name : motion::names_of(motion::from_bytes(content, file))) {
        const auto found = std::find(names_.begin(), names_.end(), name);
        places.push_back(static_cast<int>(found - names_.begin()));
        if (found == names_.end()) names_.push_back(name);
      }
    } catch (const InputError&) {
      places_.erase(sha256);  // bytes that this program cannot read: numbers must do
    }
  }

  void number_them(Database& database) {
    Statement row(database, "SELECT coalesce(max(length(weights)), 0) / 8 FROM main.sample");
    row.step();
    std::vector<int>& places = places_[""];
    for (std::int64_t i = 0; i < row.integer(0); ++i) {
      places.push_back(static_cast<int>(i));
      names_.push_back(std::to_string(i + 1));
    }
  }

  const std::vector<int>& places_in(const std::string& study) const {
    const auto set = set_of_study_.find(study);
    const auto found = places_.find(set == set_of_study_.end() ? "" : set->second);
    return found == places_.end() ? places_.begin()->second : found->second;
  }

  std::vector<std::string> names_;
  std::map<std::string, std::vector<int>> places_;  // by hash of the set: places of its motions
  std::map<std::string, std::string> set_of_study_;
};

// The tables, in the order of the schema; the views of a public export hide the rest.
std::vector<std::string> tables_of(const ExportSource& source) {
  Statement row(source.database,
                source.is_public ? "SELECT name FROM temp.sqlite_schema WHERE type = 'view'"
                                 : "SELECT name FROM main.sqlite_schema WHERE type = 'table' AND "
                                   "name NOT LIKE 'sqlite_%' AND name <> 'dictionary'");
  std::vector<std::string> tables;
  while (row.step()) tables.push_back(row.text(0));
  return tables;
}

std::string counts_sql(Database& database, std::string_view table) {
  if (table == "session") return "1";
  if (table != "trial") return "";
  return "trial.practice = 0 AND " + column_or(database, "trial", "superseded", "0") +
         " = 0 AND coalesce(trial.outcome, '') IN ('success', 'timeout', 'done')";
}

std::string select_list(std::string_view table, const std::vector<std::string>& columns) {
  std::string list;
  for (const std::string& column : columns) {
    list += (list.empty() ? "" : ", ") + std::string(table) + ".\"" + column + "\"";
  }
  return list;
}

// Writes one table after the other.
class TableWriter {
 public:
  TableWriter(const ExportSource& source, const fs::path& folder)
      : source_(source),
        folder_(folder),
        order_(session_order(source.log)),
        counts_(counting_sessions(source)),
        weights_(source.database) {
    Statement row(source.database, "SELECT uuid, study FROM session");
    while (row.step()) study_of_[row.text(0)] = row.text(1);
  }

  void write(const std::string& table) {
    const SessionTable* by_session = session_table(table);
    columns_ = columns_of(source_.database, table);
    describe(table, by_session != nullptr);
    CsvFile file(folder_ / data_file(table));
    file.add(header(table, by_session != nullptr));
    if (by_session) {
      write_sessions(*by_session, file);
    } else {
      write_plain(table, file);
    }
    file.close();
  }

  std::vector<ExportColumn> take() { return std::move(described_); }

 private:
  bool has_counts(std::string_view table) const {
    return !counts_sql(source_.database, table).empty();
  }

  std::vector<std::string> header(const std::string& table, bool of_people) const {
    std::vector<std::string> names;
    if (of_people) names.emplace_back("participant_code");
    for (const std::string& column : columns_) {
      if (column != "weights") {
        names.push_back(column);
        continue;
      }
      for (const std::string& motion : weights_.names()) names.push_back("weight." + motion);
    }
    if (has_counts(table)) names.emplace_back("counts");
    return names;
  }

  void describe(const std::string& table, bool of_people) {
    for (const std::string& name : header(table, of_people)) {
      ExportColumn column = described(source_.database, table, name);
      if (name == "participant_code") {
        column = described(source_.database, "participant", "code");
      } else if (name == "counts") {
        column = {"", "", "0/1", "1: people_wide.csv is made from it"};
      } else if (name.rfind("weight.", 0) == 0) {
        column = {"", "", "", "weight of the motion " + name.substr(7) + " in what is shown"};
      }
      column.file = data_file(table);
      column.column = name;
      described_.push_back(std::move(column));
    }
  }

  void write_plain(const std::string& table, CsvFile& file) const {
    Statement row(source_.database,
                  "SELECT " + select_list(table, columns_) + " FROM " + table + " ORDER BY 1, 2");
    while (row.step()) {
      std::vector<std::string> cells;
      for (int i = 0; i < row.columns(); ++i) cells.push_back(cell_of(row, i));
      file.add(cells);
    }
  }

  void write_sessions(const SessionTable& by_session, CsvFile& file) const {
    const std::string counts = counts_sql(source_.database, by_session.table);
    Statement row(source_.database, "SELECT " + select_list(by_session.table, columns_) +
                                        (counts.empty() ? "" : ", " + counts) + " FROM " +
                                        by_session.rows + " ORDER BY " + by_session.order);
    for (const int session : order_) {
      row.bind(1, item(source_.log.sessions, session).uuid);
      while (row.step()) file.add(cells_of(row, session, !counts.empty()));
      row.reset();
    }
  }

  std::vector<std::string> cells_of(const Statement& row, int session, bool counts) const {
    const LoggedSession& logged = item(source_.log.sessions, session);
    std::vector<std::string> cells = {logged.code};
    for (int i = 0; i < size_of(columns_); ++i) {
      if (item(columns_, i) == "weights") {
        weights_.add_cells(row.blob(i), study_of_.at(logged.uuid), cells);
      } else {
        cells.push_back(cell_of(row, i));
      }
    }
    if (counts) {
      const bool all = counts_[static_cast<std::size_t>(session)];
      cells.emplace_back(all && row.integer(size_of(columns_)) != 0 ? "1" : "0");
    }
    return cells;
  }

  const ExportSource& source_;
  const fs::path& folder_;
  std::vector<int> order_;
  std::vector<bool> counts_;
  WeightColumns weights_;
  std::map<std::string, std::string> study_of_;  // of a session
  std::vector<std::string> columns_;             // of the table that is written
  std::vector<ExportColumn> described_;
};

}  // namespace

std::string data_file(std::string_view table) {
  std::string name;
  bool upper = false;
  for (const char c : table) {
    if (c != '_') name += upper ? static_cast<char>(c - 'a' + 'A') : c;
    upper = c == '_';
  }
  return "data/description-" + name + "_data.csv";
}

std::vector<ExportColumn> export_tables(const ExportSource& source, const fs::path& folder,
                                        const Progress& progress) {
  const std::vector<std::string> tables = tables_of(source);
  TableWriter writer(source, folder);
  for (int i = 0; i < size_of(tables); ++i) {
    report_progress(progress, "tables written:", i, size_of(tables));
    writer.write(item(tables, i));
  }
  report_progress(progress, "tables written:", size_of(tables), size_of(tables));
  return writer.take();
}

}  // namespace promenade::analysis
