#include "study/merge.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "motion/files.h"
#include "study/database_file.h"
#include "study/identity.h"
#include "study/merge_rows.h"
#include "study/migrate.h"
#include "study/schema.h"
#include "study/store_open.h"

namespace promenade::study {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> checked_tables = {"study",   "study_part", "amendment",
                                                 "session", "trial",      "event",
                                                 "sample",  "answer",     "frame_histogram"};

std::vector<std::string> texts_of(Database& database, const std::string& sql,
                                  const std::string& value = "") {
  Statement row(database, sql);
  if (!value.empty()) row.bind(1, value);
  std::vector<std::string> texts;
  while (row.step()) texts.push_back(row.text(0));
  return texts;
}

std::string text_of(Database& database, const std::string& sql, const std::string& value = "") {
  const std::vector<std::string> texts = texts_of(database, sql, value);
  return texts.empty() ? "" : texts.front();
}

std::set<std::string> hashes_of(Database& database) {
  const std::vector<std::string> hashes = texts_of(database, "SELECT study_sha256 FROM study");
  return {hashes.begin(), hashes.end()};
}

bool overlap(const std::set<std::string>& a, const std::set<std::string>& b) {
  return std::any_of(a.begin(), a.end(), [&b](const std::string& one) { return b.count(one) > 0; });
}

// All inputs into one database, in the transaction of whoever calls.
class Merger {
 public:
  Merger(Database& out, std::string out_file, std::vector<Database>& sources)
      : out_(out), out_file_(std::move(out_file)), sources_(sources) {}

  Merged run(const MergeProgress& progress) {
    refuse_other_studies();
    take_tombstones();
    for (const std::string& code : texts_of(out_, "SELECT code FROM participant")) {
      home_of_code_[code] = out_file_;
    }
    for (Database& source : sources_) take(source, progress);
    if (!problems_.empty()) throw InputError(problems_);
    warn_of_orders();
    Statement sessions(out_, "SELECT count(*) FROM session");
    sessions.step();
    merged_.sessions = sessions.integer(0);
    return std::move(merged_);
  }

 private:
  void problem(const Database& source, std::string message) {
    problems_.push_back({source.file(), 0, 0, std::move(message), Severity::error});
  }

  // Files that share a version of the study belong together, and those that share one with
  // them, whatever was amended in between.
  void refuse_other_studies() {
    std::set<std::string> family = hashes_of(out_);
    if (family.empty()) family = hashes_of(sources_.front());
    for (bool grows = true; grows;) {
      const std::size_t before = family.size();
      for (Database& source : sources_) {
        const std::set<std::string> hashes = hashes_of(source);
        if (overlap(family, hashes)) family.insert(hashes.begin(), hashes.end());
      }
      grows = family.size() > before;
    }
    const std::string first = hashes_of(out_).empty() ? sources_.front().file() : out_file_;
    for (Database& source : sources_) {
      const std::string name = text_of(source, "SELECT name FROM study");
      if (name.empty()) {
        problem(source, "holds no study");
      } else if (!overlap(family, hashes_of(source))) {
        problem(source, "holds another study, \"" + name + "\", or another version of it, than " +
                            first + "; merge them apart");
      }
    }
    if (!problems_.empty()) throw InputError(problems_);
  }

  void take_tombstones() {
    for (Database& source : sources_) {
      for (const std::string& person : texts_of(source, "SELECT participant FROM tombstone")) {
        if (is_withdrawn(person)) continue;
        copy_rows(source, out_, {"tombstone", "participant = ?", "participant"}, person);
        for (const auto& [table, rows] : remove_person(out_, person)) {
          if (rows > 0) merged_.removed[table] += rows;
        }
      }
    }
    if (!merged_.removed.empty()) mark_backups(out_);
  }

  bool is_withdrawn(const std::string& person) {
    return !text_of(out_, "SELECT participant FROM tombstone WHERE participant = ?", person)
                .empty();
  }

  void take(Database& source, const MergeProgress& progress) {
    merged_.inputs.push_back({source.file(), {}, 0, 0, 0});
    take_studies(source);
    refused_.clear();
    for (const std::string& person :
         texts_of(source, "SELECT uuid FROM participant ORDER BY rowid")) {
      if (!is_withdrawn(person)) take_person(source, person);
    }
    if (!running_session(source).empty()) {
      problem(source, "a session runs in it; merge when it has ended");
    }
    for (const std::string& session : texts_of(source, "SELECT uuid FROM session ORDER BY rowid")) {
      take_session(source, session);
      note_progress(progress);
    }
    take_roster(source);
    write_receipt(source);
  }

  void note_progress(const MergeProgress& progress) {
    if (count_ == 0) {
      for (Database& source : sources_) {
        count_ += static_cast<int>(texts_of(source, "SELECT uuid FROM session").size());
      }
    }
    if (!progress || progress(++done_, count_)) return;
    throw OutsideError("stopped; " + out_file_ + " is as it was before");
  }

  // Rows of the source's studies that are new; stations know the same one by other uuids.
  void take_studies(Database& source) {
    for (const std::string& study : texts_of(source, "SELECT uuid FROM study ORDER BY rowid")) {
      const std::string hash =
          text_of(source, "SELECT study_sha256 FROM study WHERE uuid = ?", study);
      if (study_here(hash).empty()) {
        put_study(source, study);
      } else if (content_of_study(source, hash) != content_of_study(out_, hash)) {
        problem(source, "its study has the same hash as that of " + out_file_ +
                            ", but other motions or another text; one of them was changed by "
                            "hand: use an untouched copy");
      }
    }
    take_amendments(source);
  }

  std::string study_here(const std::string& hash) {
    return text_of(out_, "SELECT uuid FROM study WHERE study_sha256 = ?", hash);
  }

  static std::string content_of_study(Database& database, const std::string& hash) {
    return text_of(database,
                   "SELECT coalesce((SELECT sha256 FROM motion_set WHERE uuid = motion_set), '') "
                   "|| config_text FROM study WHERE study_sha256 = ?",
                   hash);
  }

  void put_study(Database& source, const std::string& study) {
    const std::string set = text_of(source, "SELECT motion_set FROM study WHERE uuid = ?", study);
    const std::string hash = text_of(source, "SELECT sha256 FROM motion_set WHERE uuid = ?", set);
    const std::string known = text_of(out_, "SELECT uuid FROM motion_set WHERE sha256 = ?", hash);
    if (known.empty()) count("motion_set", source, {"motion_set", "uuid = ?", "uuid"}, set);
    count("study", source, {"study", "uuid = ?", "uuid"}, study);
    count("study_part", source, {"study_part", "study = ?", "path"}, study);
    Statement here(out_, "UPDATE study SET motion_set = ? WHERE uuid = ?");
    here.bind(1, known.empty() ? set : known).bind(2, study).run();
  }

  void count(const std::string& table, Database& source, const RowsOf& rows,
             const std::string& value) {
    merged_.inputs.back().taken[table] += copy_rows(source, out_, rows, value);
  }

  void take_amendments(Database& source) {
    Statement row(source,
                  "SELECT study.study_sha256, previous.study_sha256, reason, amended_utc, "
                  "same_orders FROM "
                  "amendment JOIN study ON study.uuid = amendment.study "
                  "JOIN study AS previous ON previous.uuid = amendment.previous");
    Statement insert(out_,
                     "INSERT OR IGNORE INTO amendment(study, previous, reason, amended_utc, "
                     "same_orders) VALUES (?,?,?,?,?)");
    while (row.step()) {
      insert.bind(1, study_here(row.text(0))).bind(2, study_here(row.text(1)));
      insert.bind(3, row.text(2)).bind(4, row.text(3)).bind(5, row.integer(4)).run();
    }
  }

  static bool is_simulated(Database& database, const std::string& person) {
    return text_of(database,
                   "SELECT min(simulated) FROM session WHERE participant = ? HAVING count(*) > 0",
                   person) == "1";
  }

  void take_person(Database& source, const std::string& person) {
    const std::string code = text_of(source, "SELECT code FROM participant WHERE uuid = ?", person);
    const std::string here = text_of(out_, "SELECT code FROM participant WHERE uuid = ?", person);
    const bool simulated = is_simulated(source, person);
    if (!here.empty()) {
      if (here != code && !simulated) refuse_other_code(source, person, code, here);
      return;
    }
    const std::string other = text_of(out_, "SELECT uuid FROM participant WHERE code = ?", code);
    if (!other.empty() && !simulated) return refuse_other_person(source, person, code, other);
    const std::string free = other.empty() ? code : next_simulated_code();
    if (free != code) merged_.renamed[source.file() + ": " + code] = free;
    Statement insert(out_, "INSERT INTO participant(uuid, code) VALUES (?,?)");
    insert.bind(1, person).bind(2, free).run();
    ++merged_.inputs.back().taken["participant"];
    home_of_code_[free] = source.file();
  }

  void refuse_other_code(const Database& source, const std::string& person, const std::string& code,
                         const std::string& here) {
    refused_.insert(person);
    problem(source, "the person with the uuid " + person + " has the code \"" + code +
                        "\" here and \"" + here + "\" in " + home_of_code_[here] +
                        "; say which one is right by changing participant.code in one of them");
  }

  void refuse_other_person(const Database& source, const std::string& person,
                           const std::string& code, const std::string& other) {
    refused_.insert(person);
    problem(source, "the code \"" + code + "\" is somebody else's in " + home_of_code_[code] +
                        " (uuid " + person + " here, " + other +
                        " there): two people with one code, or one at two stations; change "
                        "participant.code or participant.uuid in one of the files");
  }

  // As Store gives them out.
  std::string next_simulated_code() {
    const std::string digits =
        text_of(out_,
                "SELECT coalesce(max(CAST(substr(code, 2) AS INTEGER)), 0) + 1 FROM participant "
                "WHERE code GLOB 'S[0-9]*'");
    return "S" + std::string(digits.size() < 3 ? 3 - digits.size() : 0, '0') + digits;
  }

  void take_session(Database& source, const std::string& session) {
    MergedInput& input = merged_.inputs.back();
    const std::string person =
        text_of(source, "SELECT participant FROM session WHERE uuid = ?", session);
    if (refused_.count(person) > 0) return;
    if (is_withdrawn(person)) {
      ++input.withdrawn;
      return;
    }
    if (!is_here(session)) return put_session(source, session);
    if (session_digest(source, session) == session_digest(out_, session) ||
        has_gone_on(source, out_, session)) {
      ++input.known;
    } else if (has_gone_on(out_, source, session)) {
      RowCounts replaced;
      remove_session(out_, session, replaced);
      put_session(source, session);
      ++input.gone_on;
    } else {
      problem(source, "its session " + session + " of \"" +
                          text_of(source, "SELECT code FROM participant WHERE uuid = ?", person) +
                          "\" is not the same as in " + home_of_session(session) +
                          "; one of them was changed: use an untouched copy");
    }
  }

  bool is_here(const std::string& session) {
    return !text_of(out_, "SELECT uuid FROM session WHERE uuid = ?", session).empty();
  }

  std::string home_of_session(const std::string& session) const {
    const auto found = home_of_session_.find(session);
    return found == home_of_session_.end() ? out_file_ : found->second;
  }

  void put_session(Database& source, const std::string& session) {
    const std::string hash =
        text_of(source,
                "SELECT study_sha256 FROM study JOIN session ON session.study = study.uuid "
                "WHERE session.uuid = ?",
                session);
    for (const auto& [table, rows] : copy_session(source, out_, session, study_here(hash))) {
      merged_.inputs.back().taken[table] += rows;
    }
    home_of_session_[session] = source.file();
  }

  // Of two states of one code the later one counts.
  void take_roster(Database& source) {
    const std::string row_sql =
        "SELECT quote(station) || sequence || quote(replaces), changed_utc, state FROM roster "
        "WHERE code = ?";
    for (const std::string& code : texts_of(source, "SELECT code FROM roster")) {
      if (is_of_withdrawn(source, code)) continue;
      const RowsOf rows = {"roster", "code = ?", "code"};
      Statement theirs(source, row_sql);
      Statement ours(out_, row_sql);
      theirs.bind(1, code).step();
      if (!ours.bind(1, code).step()) {
        count("roster", source, rows, code);
      } else if (theirs.text(0) != ours.text(0) ||
                 (theirs.text(1) == ours.text(1) && theirs.text(2) != ours.text(2))) {
        problem(source, "its roster says something else about \"" + code + "\" than " + out_file_ +
                            " or an input before; correct one of them");
      } else if (theirs.text(1) > ours.text(1)) {
        Statement update(out_, "UPDATE roster SET state = ?, changed_utc = ? WHERE code = ?");
        update.bind(1, theirs.text(2)).bind(2, theirs.text(1)).bind(3, code).run();
      }
    }
  }

  bool is_of_withdrawn(Database& source, const std::string& code) {
    const std::string person = text_of(source, "SELECT uuid FROM participant WHERE code = ?", code);
    return !person.empty() && is_withdrawn(person);
  }

  void write_receipt(const Database& source) {
    nlohmann::ordered_json taken = nlohmann::ordered_json::object();
    for (const auto& [table, rows] : merged_.inputs.back().taken) {
      if (rows > 0) taken[table] = rows;
    }
    Statement insert(out_,
                     "INSERT INTO receipt(source, sha256, merged_utc, rows_taken) "
                     "VALUES (?,?,?,?)");
    insert.bind(1, source.file()).bind(2, sha256_hex(read_file(source.file())));
    insert.bind(3, utc_now()).bind(4, taken.dump()).run();
  }

  // Stations that dealt orders without a roster gave the same ones.
  void warn_of_orders() {
    const std::vector<std::string> twice =
        texts_of(out_,
                 "SELECT sequence FROM session WHERE outcome = 'finished' AND simulated = 0 AND "
                 "pilot = 0 GROUP BY sequence HAVING count(*) > 1 ORDER BY sequence");
    if (twice.empty()) return;
    std::string orders;
    for (const std::string& order : twice) orders += (orders.empty() ? "" : ", ") + order;
    merged_.warnings.push_back({out_file_, 0, 0,
                                "more than one person finished each of the orders " + orders +
                                    "; deal orders to stations with `promenade roster`",
                                Severity::warning});
  }

  Database& out_;
  std::string out_file_;
  std::vector<Database>& sources_;
  Merged merged_;
  std::vector<Problem> problems_;
  std::map<std::string, std::string> home_of_code_, home_of_session_;  // the file it came from
  std::set<std::string> refused_;  // people of the source that stay out
  int done_ = 0, count_ = 0;
};

Database open_input(const std::string& file, const std::string& out) {
  std::error_code ignored;
  if (fs::equivalent(file, out, ignored)) {
    throw InputError(file, "is the database that is merged into; name the others only");
  }
  Database database = open_log(file);
  if (is_damaged(database, checked_tables)) throw InputError(file, damaged_database);
  database.exec("BEGIN");  // seen as it is now, whatever others write
  return database;
}

std::vector<Database> open_inputs(const std::vector<std::string>& files, const std::string& out) {
  std::vector<Database> databases;
  std::vector<Problem> problems;
  for (const std::string& file : files) {
    try {
      databases.push_back(open_input(file, out));
    } catch (const InputError& error) {
      problems.insert(problems.end(), error.problems().begin(), error.problems().end());
    } catch (const DatabaseError& error) {
      if (!error.about_content()) throw;
      problems.push_back({file, 0, 0, damaged_database, Severity::error});
    }
  }
  if (!problems.empty()) throw InputError(problems);
  return databases;
}

void make_new(const std::string& file) {
  std::error_code ignored;
  const fs::path folder = fs::path(file).parent_path();
  if (!folder.empty()) fs::create_directories(folder, ignored);
  remove_database(file);
  make_private_file(file);
  Database database(file, Database::Mode::read_write);
  Transaction transaction(database);
  create_tables(database);
  transaction.commit();
}

Merged merge_into(const std::string& file, const std::string& name, std::vector<Database>& sources,
                  const MergeProgress& progress) {
  Database database = open_existing_store(file);
  if (!running_session(database).empty()) {
    throw OutsideError(name + ": a session runs in it; merge when it has ended");
  }
  database.exec("PRAGMA foreign_keys = OFF");  // each session comes with all that it refers to
  Transaction transaction(database);
  Merged merged = Merger(database, name, sources).run(progress);
  transaction.commit();
  if (!merged.removed.empty()) {
    scrub(database);
    merged.backups = clean_backups(database);
  }
  return merged;
}

// Before an older file is migrated it must be known that nothing is wrong.
void rehearse(const std::string& out, std::vector<Database>& sources) {
  Database memory = open_log(out);
  if (memory.is_in_memory()) Merger(memory, out, sources).run({});
}

Merged merge_into_new(const std::string& out, std::vector<Database>& sources,
                      const MergeProgress& progress) {
  const std::string part = out + ".part";
  try {
    make_new(part);
    Merged merged = merge_into(part, out, sources, progress);
    rename_durably(part, out);
    return merged;
  } catch (const std::exception&) {
    remove_database(part);
    throw;
  }
}

}  // namespace

Merged merge(const std::string& out, const std::vector<std::string>& inputs,
             const MergeProgress& progress) {
  std::vector<Database> sources = open_inputs(inputs, out);
  std::error_code ignored;
  if (!fs::exists(out, ignored)) return merge_into_new(out, sources, progress);
  rehearse(out, sources);
  return merge_into(out, out, sources, progress);
}

}  // namespace promenade::study
