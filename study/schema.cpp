#include "study/schema.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "study/sqlite.h"

namespace promenade::study {
namespace {

constexpr const char* tables_sql = R"sql(
CREATE TABLE study(
  uuid TEXT PRIMARY KEY, name TEXT NOT NULL, version TEXT NOT NULL, config_text TEXT NOT NULL,
  study_sha256 TEXT NOT NULL UNIQUE, program_version TEXT NOT NULL, created_utc TEXT NOT NULL
) STRICT;
CREATE TABLE motion_set(
  uuid TEXT PRIMARY KEY, name TEXT NOT NULL, sha256 TEXT NOT NULL UNIQUE, content BLOB NOT NULL
) STRICT;
CREATE TABLE participant(
  uuid TEXT PRIMARY KEY, code TEXT NOT NULL UNIQUE
) STRICT;
CREATE TABLE session(
  uuid TEXT PRIMARY KEY, study TEXT NOT NULL REFERENCES study(uuid),
  participant TEXT NOT NULL REFERENCES participant(uuid), station TEXT NOT NULL,
  seed INTEGER NOT NULL, sequence INTEGER NOT NULL, language TEXT NOT NULL,
  started_utc TEXT NOT NULL, ended_utc TEXT,
  outcome TEXT NOT NULL CHECK (outcome IN ('running','finished','declined','withdrawn','stopped')),
  simulated INTEGER NOT NULL CHECK (simulated IN (0,1)),
  pilot INTEGER NOT NULL CHECK (pilot IN (0,1)), process INTEGER, machine TEXT NOT NULL
) STRICT;
CREATE INDEX session_by_order ON session(simulated, pilot, sequence);
CREATE TABLE trial(
  uuid TEXT PRIMARY KEY, session TEXT NOT NULL REFERENCES session(uuid),
  position INTEGER NOT NULL, block INTEGER NOT NULL, practice INTEGER NOT NULL CHECK (practice IN (0,1)),
  task TEXT NOT NULL, interface TEXT NOT NULL, target TEXT NOT NULL, limit_s REAL,
  threshold_m REAL, started_us INTEGER NOT NULL, ended_us INTEGER,
  outcome TEXT CHECK (outcome IN ('success','timeout','done','skipped','aborted')),
  d_first REAL, d_best REAL, d_final REAL, d_sum REAL, seconds_difference REAL,
  first_below_us INTEGER, paused_us INTEGER, clicks INTEGER, changes INTEGER,
  late_frames INTEGER
) STRICT;
CREATE TABLE event(
  session TEXT NOT NULL REFERENCES session(uuid), trial TEXT REFERENCES trial(uuid),
  seq INTEGER NOT NULL, t_us INTEGER NOT NULL, uncertainty_us INTEGER NOT NULL,
  frame_us INTEGER, actor TEXT NOT NULL CHECK (actor IN ('participant','system','experimenter')),
  kind TEXT NOT NULL, target TEXT, value REAL, x REAL, y REAL, detail TEXT,
  PRIMARY KEY (session, seq)
) STRICT, WITHOUT ROWID;
CREATE TABLE sample(
  trial TEXT NOT NULL REFERENCES trial(uuid), t_us INTEGER NOT NULL, d REAL, weights BLOB NOT NULL
) STRICT;
CREATE INDEX sample_by_trial ON sample(trial, t_us);
CREATE TABLE answer(
  session TEXT NOT NULL REFERENCES session(uuid), trial TEXT REFERENCES trial(uuid),
  instrument TEXT NOT NULL, version TEXT NOT NULL, item TEXT NOT NULL, value REAL, text TEXT,
  declined INTEGER NOT NULL CHECK (declined IN (0,1)),
  touched INTEGER NOT NULL CHECK (touched IN (0,1)), t_us INTEGER NOT NULL
) STRICT;
CREATE TABLE dictionary(
  table_name TEXT NOT NULL, column_name TEXT NOT NULL, unit TEXT NOT NULL, meaning TEXT NOT NULL,
  PRIMARY KEY (table_name, column_name)
) STRICT, WITHOUT ROWID;
)sql";

struct Meaning {
  const char* table;
  const char* column;
  const char* unit;
  const char* meaning;
};

constexpr auto meanings = std::to_array<Meaning>({
    {"study", "uuid", "", "identifies this version of the study"},
    {"study", "name", "", "name in the study file"},
    {"study", "version", "", "version in the study file"},
    {"study", "config_text", "", "the study file, letter by letter"},
    {"study", "study_sha256", "", "hash over study, motion set, models, instruments and texts"},
    {"study", "program_version", "", "version of Promenade that made the row"},
    {"study", "created_utc", "ISO 8601", "when the row was made"},
    {"motion_set", "uuid", "", "identifies the motion set"},
    {"motion_set", "name", "", "name of the motion set"},
    {"motion_set", "sha256", "", "hash of the content"},
    {"motion_set", "content", "bytes",
     "the very motions that were shown, as `set build` writes them"},
    {"participant", "uuid", "", "identifies the person"},
    {"participant", "code", "", "code that the experimenter gave; never a name"},
    {"session", "uuid", "", "identifies the session"},
    {"session", "study", "", "study.uuid"},
    {"session", "participant", "", "participant.uuid"},
    {"session", "station", "", "where the session ran"},
    {"session", "seed", "", "seed of every random choice in the session"},
    {"session", "sequence", "", "which order of the plan was given, from 0"},
    {"session", "language", "", "language of the texts"},
    {"session", "started_utc", "ISO 8601", "when the session began"},
    {"session", "ended_utc", "ISO 8601", "when it ended; null: it did not end properly"},
    {"session", "outcome", "", "running, finished, declined, withdrawn or stopped"},
    {"session", "simulated", "0/1", "1: no person, a simulated participant"},
    {"session", "pilot", "0/1", "1: a trial run that does not count"},
    {"session", "process", "", "process id while running, to tell an interrupted session"},
    {"session", "machine", "JSON", "machine, display and program on which it ran"},
    {"trial", "uuid", "", "identifies the trial"},
    {"trial", "session", "", "session.uuid"},
    {"trial", "position", "", "place in the session, from 1, practice included"},
    {"trial", "block", "", "block of the plan, from 1"},
    {"trial", "practice", "0/1", "1: practice, left out of results"},
    {"trial", "task", "", "name of the task in the study file"},
    {"trial", "interface", "", "name of the interface in the study file"},
    {"trial", "target", "", "name of the target motion or asked quality"},
    {"trial", "limit_s", "s", "time limit; null: none"},
    {"trial", "threshold_m", "m", "D below which the trial succeeds; null: none"},
    {"trial", "started_us", "us", "when it began, since the session began"},
    {"trial", "ended_us", "us", "when it ended, since the session began"},
    {"trial", "outcome", "", "success, timeout, done, skipped or aborted; null: cut off"},
    {"trial", "d_first", "m", "D at the state in which the trial begins"},
    {"trial", "d_best", "m", "smallest D shown"},
    {"trial", "d_final", "m", "D when it ended"},
    {"trial", "d_sum", "m", "the bare sum of Eq. 8 at the end"},
    {"trial", "seconds_difference", "s",
     "duration of the created cycle minus the target's at the end"},
    {"trial", "first_below_us", "us",
     "first time D was below the threshold, since the session began"},
    {"trial", "paused_us", "us",
     "how long the trial stood still in pauses; part of ended_us - started_us, not of limit_s"},
    {"trial", "clicks", "", "presses of a mouse button during the trial"},
    {"trial", "changes", "", "changes of what is shown by the participant; a drag counts once"},
    {"trial", "late_frames", "", "frames shown more than half a frame late"},
    {"event", "session", "", "session.uuid"},
    {"event", "trial", "", "trial.uuid; null outside trials"},
    {"event", "seq", "", "order within the session, from 1"},
    {"event", "t_us", "us", "when it happened, since the session began"},
    {"event", "uncertainty_us", "us",
     "how much earlier it may have happened: time since the poll before"},
    {"event", "frame_us", "us", "when the frame on screen at that moment was shown; null: none"},
    {"event", "actor", "", "participant, system or experimenter"},
    {"event", "kind", "", "what happened"},
    {"event", "target", "", "to which control, page or item"},
    {"event", "value", "", "the value that was set, in the control's unit"},
    {"event", "x", "", "first coordinate, pixels or the control's unit"},
    {"event", "y", "", "second coordinate, pixels or the control's unit"},
    {"event", "detail", "JSON", "what else belongs to it"},
    {"sample", "trial", "", "trial.uuid"},
    {"sample", "t_us", "us", "when what is shown changed, since the session began"},
    {"sample", "d", "m", "D of what is shown; null in tasks without a target motion"},
    {"sample", "weights", "", "N little-endian doubles in the order of the motion set"},
    {"answer", "session", "", "session.uuid"},
    {"answer", "trial", "", "trial.uuid; null: about no single trial"},
    {"answer", "instrument", "", "name of the questionnaire"},
    {"answer", "version", "", "its version"},
    {"answer", "item", "", "the question"},
    {"answer", "value", "", "the answer as a number; null: none"},
    {"answer", "text", "", "the answer as text; null: none"},
    {"answer", "declined", "0/1", "1: the person chose not to answer"},
    {"answer", "touched", "0/1", "1: the person set it; 0: a standard left as it was"},
    {"answer", "t_us", "us", "when it was given, since the session began"},
    {"dictionary", "table_name", "", "a table"},
    {"dictionary", "column_name", "", "one of its columns"},
    {"dictionary", "unit", "", "its unit"},
    {"dictionary", "meaning", "", "what it holds"},
});

std::int64_t pragma(Database& database, const char* name) {
  Statement statement(database, std::string("PRAGMA ") + name);
  return statement.step() ? statement.integer(0) : 0;
}

std::uint64_t number_in(std::string_view bytes) {  // big-endian
  std::uint64_t number = 0;
  for (const char byte : bytes) number = number << 8U | static_cast<unsigned char>(byte);
  return number;
}

// A file of SQLite that is shorter than its first bytes say (https://sqlite.org/fileformat.html).
bool is_cut(const std::string& file) {
  constexpr std::string_view magic = "SQLite format 3";
  std::string head(100, '\0');
  std::ifstream(file, std::ios::binary)
      .read(head.data(), static_cast<std::streamsize>(head.size()));
  if (head.compare(0, magic.size(), magic) != 0) return false;
  const std::string_view bytes = head;
  const std::uint64_t page = number_in(bytes.substr(16, 2));  // 1: 65536
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  return error || size < 512 || size < (page == 1 ? 65536 : page) * number_in(bytes.substr(28, 4));
}

[[noreturn]] void refuse_stranger(const std::string& file, const char* reason) {
  throw InputError(file, is_cut(file) ? damaged_database : reason);
}

}  // namespace

void create_tables(Database& database) {
  database.exec(tables_sql);
  database.exec("PRAGMA application_id = " + std::to_string(application_id));
  database.exec("PRAGMA user_version = " + std::to_string(schema_version));
  Statement insert(database, "INSERT INTO dictionary VALUES (?,?,?,?)");
  for (const Meaning& row : meanings) {
    insert.bind(1, row.table).bind(2, row.column).bind(3, row.unit).bind(4, row.meaning).run();
  }
}

void check_database(Database& database) {
  std::int64_t id = 0;
  std::int64_t version = 0;
  try {
    id = pragma(database, "application_id");
    version = pragma(database, "user_version");
  } catch (const DatabaseError&) {
    refuse_stranger(database.file(), "is not a database; name the .db file of a study");
  }
  if (id != application_id) {
    refuse_stranger(database.file(),
                    "is not a database of Promenade; name the .db file of a study");
  }
  if (version > schema_version) {
    throw InputError(database.file(), "was made by a newer Promenade (its tables are version " +
                                          std::to_string(version) + ", this program knows " +
                                          std::to_string(schema_version) + "); use that one");
  }
}

}  // namespace promenade::study
