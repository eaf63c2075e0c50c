#include "analysis/export/export_public.h"

#include <algorithm>
#include <map>
#include <set>

#include "analysis/export/export_published.h"
#include "analysis/item.h"
#include "study/identity.h"

namespace promenade::analysis {
namespace {

using study::Database;
using study::Statement;

// A column of a view: under its name, or an expression. `o` is the row of the table.
struct PublicColumn {
  const char* name;
  const char* sql = nullptr;  // null: as it is
};

struct PublicTable {
  const char* name;
  const char* joins;
  std::vector<PublicColumn> columns;
};

// Of the details of an event only numbers and yes or no: words might be somebody's.
constexpr const char* plain_detail =
    "CASE WHEN o.kind <> 'answer' AND o.actor <> 'experimenter' AND json_valid(o.detail) THEN "
    "(SELECT nullif(json_group_object(j.key, json(o.detail -> j.fullkey)), '{}') FROM "
    "json_each(o.detail) j WHERE j.type IN ('true', 'false', 'integer', 'real')) END";

const std::vector<PublicTable>& public_tables() {
  static const std::vector<PublicTable> tables = {
      {"study",
       "JOIN temp.public_study s ON s.old = o.uuid",
       {{"uuid", "s.new"},
        {"name"},
        {"version"},
        {"study_sha256"},
        {"program_version"},
        {"motion_set", "(SELECT new FROM temp.public_set WHERE old = o.motion_set)"}}},
      {"motion_set",
       "JOIN temp.public_set s ON s.old = o.uuid",
       {{"uuid", "s.new"}, {"name"}, {"sha256"}}},
      {"amendment",
       "JOIN temp.public_study s ON s.old = o.study JOIN temp.public_study p ON p.old = o.previous",
       {{"study", "s.new"}, {"previous", "p.new"}}},
      {"participant",
       "JOIN temp.public_person p ON p.old = o.uuid",
       {{"uuid", "p.new"}, {"code", "p.new"}}},
      {"session",
       "JOIN temp.public_session s ON s.old = o.uuid JOIN temp.public_study y ON y.old = o.study "
       "JOIN temp.public_person p ON p.old = o.participant",
       {{"uuid", "s.new"},
        {"study", "y.new"},
        {"participant", "p.new"},
        {"language", "CASE WHEN p.hidden THEN NULL ELSE o.language END"},
        {"outcome"},
        {"simulated"},
        {"pilot"},
        {"resumed"}}},
      {"trial",
       "JOIN temp.public_trial t ON t.old = o.uuid JOIN temp.public_session s ON s.old = o.session",
       {{"uuid", "t.new"},
        {"session", "s.new"},
        {"position"},
        {"block"},
        {"practice"},
        {"task"},
        {"interface"},
        {"target"},
        {"limit_s"},
        {"threshold_m"},
        {"started_us"},
        {"ended_us"},
        {"outcome"},
        {"d_first"},
        {"d_best"},
        {"d_final"},
        {"d_sum"},
        {"seconds_difference"},
        {"first_below_us"},
        {"paused_us"},
        {"clicks"},
        {"changes"},
        {"late_frames"},
        {"attempt"},
        {"superseded"},
        {"d_area_m_s"},
        {"path_m"},
        {"reversals"},
        {"drags"},
        {"controls_touched"},
        {"examples_visited"},
        {"map_coverage"},
        {"idle_us"},
        {"camera_moves"}}},
      {"event",
       "JOIN temp.public_session s ON s.old = o.session "
       "LEFT JOIN temp.public_trial t ON t.old = o.trial",
       {{"session", "s.new"},
        {"trial", "t.new"},
        {"seq"},
        {"t_us"},
        {"uncertainty_us"},
        {"frame_us"},
        {"actor"},
        {"kind"},
        {"target",
         "CASE WHEN o.kind <> 'language' AND o.actor <> 'experimenter' THEN o.target END"},
        {"value", "CASE WHEN o.kind <> 'answer' THEN o.value END"},
        {"x"},
        {"y"},
        {"detail", plain_detail}}},
      {"sample",
       "JOIN temp.public_trial t ON t.old = o.trial",
       {{"trial", "t.new"}, {"t_us"}, {"d"}, {"weights"}, {"after_seq"}}},
      {"answer",
       "JOIN temp.public_answer a ON a.id = o.rowid JOIN temp.public_session s ON s.old = "
       "o.session "
       "LEFT JOIN temp.public_trial t ON t.old = o.trial",
       {{"session", "s.new"},
        {"trial", "t.new"},
        {"instrument"},
        {"version"},
        {"item"},
        {"value", "a.value"},
        {"text", "a.text"},
        {"declined"},
        {"touched"},
        {"t_us"},
        {"asked"},
        {"block"},
        {"task"},
        {"interface"},
        {"place"}}},
      {"frame_histogram",
       "JOIN temp.public_session s ON s.old = o.session "
       "LEFT JOIN temp.public_trial t ON t.old = o.trial",
       {{"session", "s.new"}, {"trial", "t.new"}, {"least_us"}, {"count"}}},
  };
  return tables;
}

constexpr const char* maps_sql = R"sql(
CREATE TEMP TABLE public_study(old TEXT PRIMARY KEY, new TEXT UNIQUE);
CREATE TEMP TABLE public_set(old TEXT PRIMARY KEY, new TEXT UNIQUE);
CREATE TEMP TABLE public_person(old TEXT PRIMARY KEY, new TEXT UNIQUE, hidden INTEGER);
CREATE TEMP TABLE public_session(old TEXT PRIMARY KEY, new TEXT UNIQUE);
CREATE TEMP TABLE public_trial(old TEXT PRIMARY KEY, new TEXT UNIQUE);
CREATE TEMP TABLE public_answer(id INTEGER PRIMARY KEY, value REAL, text TEXT);
INSERT INTO public_study SELECT uuid, 'study-' || row_number() OVER (ORDER BY created_utc, uuid)
  FROM main.study;
INSERT INTO public_set SELECT uuid, 'set-' || row_number() OVER (ORDER BY name, sha256)
  FROM main.motion_set;
)sql";

// Six letters by chance; no vowels, so that they never make a word.
std::string random_code() {
  constexpr std::string_view letters = "BCDFGHJKMNQRTVWX";
  std::string code;
  for (const char c : study::random_uuid().substr(0, 6)) {
    code += letters[static_cast<std::size_t>(c <= '9' ? c - '0' : c - 'a' + 10)];
  }
  return code;
}

// Who said no, or withdrew in any session, is in no public file.
std::set<std::string> withdrawn_people(const Log& log) {
  std::set<std::string> people;
  for (const LoggedSession& session : log.sessions) {
    if (session.outcome == "withdrawn") people.insert(session.participant);
  }
  return people;
}

std::string padded(int number, std::size_t digits) {
  const std::string text = std::to_string(number);
  return std::string(digits > text.size() ? digits - text.size() : 0, '0') + text;
}

void put(Database& database, const char* table, const std::string& old_name,
         const std::string& new_name) {
  Statement row(database, std::string("INSERT INTO temp.") + table + "(old, new) VALUES (?,?)");
  row.bind(1, old_name).bind(2, new_name).run();
}

// New names for people, sessions and trials, in the database and in the log.
class Renaming {
 public:
  explicit Renaming(ExportSource& source)
      : database_(source.database), log_(source.log), withdrawn_(withdrawn_people(source.log)) {}

  int rename() {
    for (LoggedSession& session : log_.sessions) rename(session);
    std::set<std::string> left_out = std::move(left_out_);
    for (const auto& [person, code] : codes_) left_out.erase(person);
    return size_of(left_out);
  }

 private:
  void rename(LoggedSession& session) {
    const std::string person = session.participant;
    if (session.outcome == "declined" || withdrawn_.count(person) > 0) {
      left_out_.insert(person);
      session.outcome = "withdrawn";
      session.uuid = session.participant = session.code = "";
      return;
    }
    const auto [found, is_new] = codes_.emplace(person, "");
    if (is_new) {
      found->second = unused_code();
      put(database_, "public_person", person, found->second);
    }
    const std::string name = found->second + "-" + padded(++sessions_[person], 2);
    put(database_, "public_session", session.uuid, name);
    rename_trials(session.uuid, name);
    session.uuid = name;
    session.participant = session.code = found->second;
  }

  std::string unused_code() {
    for (;;) {
      std::string code = random_code();
      if (used_.insert(code).second) return code;
    }
  }

  void rename_trials(const std::string& session, const std::string& name) {
    Statement row(
        database_,
        "SELECT uuid FROM main.trial WHERE session = ? ORDER BY started_us, position, uuid");
    row.bind(1, session);
    for (int number = 1; row.step(); ++number) {
      put(database_, "public_trial", row.text(0), name + "-" + padded(number, 3));
    }
  }

  Database& database_;
  Log& log_;
  std::set<std::string> withdrawn_, left_out_, used_;
  std::map<std::string, std::string> codes_;  // of a person by uuid
  std::map<std::string, int> sessions_;
};

void make_view(Database& database, const PublicTable& table) {
  if (!has_column(database, table.name, table.columns.front().name)) return;  // an old file
  std::string list;
  for (const PublicColumn& column : table.columns) {
    if (!has_column(database, table.name, column.name)) continue;
    list += list.empty() ? "" : ", ";
    list += column.sql ? column.sql : "o." + std::string(column.name);
    list += " AS " + std::string(column.name);
  }
  database.exec("CREATE TEMP VIEW " + std::string(table.name) + " AS SELECT " + list +
                " FROM main." + table.name + " o " + table.joins);
}

}  // namespace

PublicData make_public(ExportSource& source, const ReviewedAnswers& reviewed) {
  PublicData data;
  source.is_public = true;
  source.database.exec(maps_sql);
  data.left_out_people = Renaming(source).rename();
  PublishedAnswers published = publish_answers(source.database, source.instruments, reviewed);
  data.questions = std::move(published.questions);
  data.cells = std::move(published.cells);
  data.withheld_texts = published.withheld_texts;
  for (const PublicTable& table : public_tables()) make_view(source.database, table);
  return data;
}

}  // namespace promenade::analysis
