#include "study/store.h"

#include <fcntl.h>
#include <unistd.h>

#include <cassert>

#include "motion/bytes.h"
#include "study/assignment.h"
#include "study/identity.h"
#include "study/process.h"
#include "study/store_open.h"
#include "study/versions.h"

namespace promenade::study {
namespace {

constexpr int simulated_per_checkpoint = 50;

std::string bytes_of(const Eigen::VectorXd& weights) {
  ByteWriter writer;
  writer.numbers(weights.data(), static_cast<std::size_t>(weights.size()));
  return writer.take();
}

template <typename T>
void bind_unless_empty(Statement& statement, int index, const T& text) {
  if (text.empty()) {
    statement.bind_null(index);
  } else {
    statement.bind(index, text);
  }
}

// Does the row of this statement, outcome, process and its start, hold its order? Whoever
// was killed does not.
bool holds_order(const Statement& row) {
  return row.text(0) == "finished" ||
         (row.text(0) == "running" && lives(row.integer(1), row.text(2)));
}

// The versions of the study whose orders are those of the newest (study/amend.h).
constexpr const char* of_counted_versions =
    "study IN (WITH RECURSIVE counted(study) AS (SELECT uuid FROM study WHERE study_sha256 = ? "
    "UNION SELECT previous FROM amendment JOIN counted ON amendment.study = counted.study "
    "WHERE same_orders = 1) SELECT study FROM counted)";

// The same row, with whether the person's data are to be removed.
GivenOrder::State state_of(const Statement& row) {
  using State = GivenOrder::State;
  const bool running = row.text(0) == "running";
  if (row.integer(4) != 0 || (!running && row.text(0) != "finished")) return State::gone;
  if (!running) return State::counts;
  return holds_order(row) ? State::runs : State::interrupted;
}

// A file that is closed with its owner; -1: none.
class FileHandle {
 public:
  FileHandle() = default;
  ~FileHandle() { reset(-1); }
  FileHandle(const FileHandle&) = delete;
  FileHandle& operator=(const FileHandle&) = delete;
  int get() const { return handle_; }
  void reset(int handle) {
    if (handle_ >= 0) ::close(handle_);
    handle_ = handle;
  }

 private:
  int handle_ = -1;
};

constexpr std::string_view when_words[] = {"start", "trial", "task", "block", "end"};

}  // namespace

struct Store::Implementation {
  Implementation(const std::filesystem::path& file, const StudyBundle& study_bundle)
      : bundle(&study_bundle), database(open_store(file, study_bundle)) {}

  const StudyBundle* bundle;
  Database database;
  Statement insert_trial{database,
                         "INSERT INTO trial(uuid, session, position, block, practice, task, "
                         "interface, target, limit_s, threshold_m, started_us, d_first, attempt) "
                         "VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?)"};
  Statement end_trial{database,
                      "UPDATE trial SET ended_us = ?, outcome = ?, d_best = ?, d_final = ?, "
                      "d_sum = ?, seconds_difference = ?, first_below_us = ?, paused_us = ?, "
                      "clicks = ?, changes = ?, late_frames = ?, d_area_m_s = ?, path_m = ?, "
                      "reversals = ?, drags = ?, controls_touched = ?, examples_visited = ?, "
                      "map_coverage = ?, idle_us = ?, camera_moves = ? WHERE uuid = ?"};
  Statement supersede_trial{database, "UPDATE trial SET superseded = 1 WHERE uuid = ?"};
  Statement set_alive{database, "UPDATE session SET alive_us = ? WHERE uuid = ?"};
  Statement savepoint{database, "SAVEPOINT step"};
  Statement release{database, "RELEASE step"};
  Statement insert_event{database, "INSERT INTO event VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?)"};
  Statement insert_sample{database, "INSERT INTO sample VALUES (?,?,?,?,?)"};
  Statement insert_answer{database, "INSERT INTO answer VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)"};

  // The session that runs.
  std::string session;
  Plan plan;
  std::vector<std::string> trials;  // uuids by index into Plan::trials; empty: not begun
  std::int64_t seq = 0;
  bool durable = true;  // a simulated participant can be asked again
  bool open = false;    // a transaction
  bool due = false;     // what it holds is to be durable
  FileHandle trace;
  std::vector<std::string> ended;  // trials that this step ended
  std::int64_t alive_us = 0;
  int unchecked = 0;  // simulated sessions since the last checkpoint

  void say(const std::string& line) const;  // to the trace
  void begin();
  void commit();
  void commit_durably();
  const std::string& trial_uuid(int index) const;
  static const std::string& interface_name(const Study& study, const PlannedTrial& trial);
  void bind_trial(Statement& statement, int column, int trial) const;
  std::string participant_uuid(const std::string& code);
  void refuse_amended();
  void refuse_taken(const SessionHeader& header, int sequence);

  void put_whole(const std::vector<Record>& step);
  void put(const TrialStarted& record);
  void put(const TrialSuperseded& record);
  void put(const Event& record);
  void put(const Sample& record);
  void put(const Answer& record);
  void put(const TrialEnded& record);
  void put(const SessionDecided& record);
  void put(const SessionEnded& record);
};

void Store::Implementation::say(const std::string& line) const {
  if (trace.get() < 0) return;
  // A reader that went away is no reason to stop.
  [[maybe_unused]] const ssize_t written = ::write(trace.get(), line.data(), line.size());
}

void Store::Implementation::begin() {
  if (open) return;
  database.exec("BEGIN IMMEDIATE");
  open = true;
}

void Store::Implementation::commit() {
  if (!open) return;
  database.exec("COMMIT");
  open = false;
}

// With FULL, a commit waits until the journal with everything before is on the disk.
void Store::Implementation::commit_durably() {
  if (!durable) return commit();
  commit();
  database.exec("PRAGMA synchronous = FULL");
  // A commit without a change would write nothing, and so wait for nothing.
  database.exec("BEGIN IMMEDIATE; UPDATE session SET process = process WHERE uuid = '" + session +
                "'; COMMIT");
  database.exec("PRAGMA synchronous = NORMAL");
  database.exec("PRAGMA wal_checkpoint(PASSIVE)");
}

const std::string& Store::Implementation::interface_name(const Study& study,
                                                         const PlannedTrial& trial) {
  static const std::string none;
  if (trial.interface < 0) return none;
  return study.interfaces[static_cast<std::size_t>(trial.interface)].name;
}

const std::string& Store::Implementation::trial_uuid(int index) const {
  const std::string& uuid = trials[static_cast<std::size_t>(index)];
  assert(!uuid.empty() && "a trial is logged after it started");
  return uuid;
}

void Store::Implementation::bind_trial(Statement& statement, int column, int trial) const {
  if (trial < 0) {
    statement.bind_null(column);
  } else {
    statement.bind(column, trial_uuid(trial));
  }
}

std::string Store::Implementation::participant_uuid(const std::string& code) {
  Statement known(database, "SELECT uuid FROM participant WHERE code = ?");
  if (known.bind(1, code).step()) return known.text(0);
  std::string uuid = random_uuid();
  Statement insert(database, "INSERT INTO participant VALUES (?,?)");
  insert.bind(1, uuid).bind(2, code).run();
  return uuid;
}

// Another process may have changed the study since the database was opened.
void Store::Implementation::refuse_amended() {
  const std::string problem = study_problem(database, *bundle);
  if (!problem.empty()) throw OutsideError(database.file() + " " + problem);
}

// Only inside the transaction that inserts the session: outside, it may be taken after.
void Store::Implementation::refuse_taken(const SessionHeader& header, int sequence) {
  Statement rows(database,
                 std::string("SELECT outcome, process, coalesce(process_start, '') FROM session "
                             "WHERE simulated = ? AND pilot = ? AND sequence = ? AND ") +
                     of_counted_versions);
  rows.bind(1, header.simulated).bind(2, header.pilot).bind(3, sequence).bind(4, bundle->sha256);
  while (rows.step()) {
    if (!holds_order(rows)) continue;
    throw TakenError(TakenError::What::sequence, database.file() + ": order " +
                                                     std::to_string(sequence) +
                                                     " was taken by another session; start again");
  }
  Statement known(database, "SELECT 1 FROM participant WHERE code = ?");
  if (!header.new_participant || !known.bind(1, header.participant).step()) return;
  throw TakenError(TakenError::What::code, database.file() + ": the code \"" + header.participant +
                                               "\" is already used; choose another one");
}

// Or nothing of it.
void Store::Implementation::put_whole(const std::vector<Record>& step) {
  savepoint.run();
  try {
    for (const Record& record : step) {
      std::visit([this](const auto& one) { put(one); }, record);
    }
  } catch (...) {
    // A full disk has rolled back all of the transaction already.
    try {
      database.exec("ROLLBACK TO step; RELEASE step");
    } catch (const DatabaseError&) {
      open = false;
    }
    throw;
  }
  release.run();
}

void Store::Implementation::put(const TrialStarted& record) {
  const auto index = static_cast<std::size_t>(record.trial);
  const Study& study = bundle->study;
  const PlannedTrial& planned = plan.trials[index];
  const Task& task = task_of(study, planned);
  trials[index] = random_uuid();
  insert_trial.bind(1, trials[index]).bind(2, session).bind(3, planned.position);
  insert_trial.bind(4, planned.block).bind(5, planned.practice).bind(6, task.name);
  insert_trial.bind(7, interface_name(study, planned)).bind(13, record.attempt);
  insert_trial.bind(8, target_of(study, planned).name).bind(9, task.limit_s);
  insert_trial.bind(10, task.threshold_m).bind(11, record.t_us).bind(12, record.d_first).run();
}

void Store::Implementation::put(const Event& record) {
  insert_event.bind(1, session).bind(3, ++seq).bind(4, record.t_us).bind(5, record.uncertainty_us);
  bind_trial(insert_event, 2, record.trial);
  if (record.frame_us < 0) {
    insert_event.bind_null(6);
  } else {
    insert_event.bind(6, record.frame_us);
  }
  insert_event.bind(7, to_text(record.actor)).bind(8, record.kind);
  bind_unless_empty(insert_event, 9, record.target);
  insert_event.bind(10, record.value).bind(11, record.x).bind(12, record.y);
  bind_unless_empty(insert_event, 13, record.detail);
  insert_event.run();
  if (trace.get() >= 0) say("event " + session + " " + std::to_string(seq) + "\n");
}

void Store::Implementation::put(const Sample& record) {
  insert_sample.bind(1, trial_uuid(record.trial)).bind(2, record.t_us).bind(3, record.d);
  insert_sample.bind_blob(4, bytes_of(record.weights)).bind(5, seq).run();
}

void Store::Implementation::put(const Answer& record) {
  insert_answer.bind(1, session).bind(3, record.instrument).bind(4, record.version);
  bind_trial(insert_answer, 2, record.trial);
  insert_answer.bind(5, record.item).bind(6, record.value);
  bind_unless_empty(insert_answer, 7, record.text);
  insert_answer.bind(8, record.declined).bind(9, record.touched).bind(10, record.t_us);
  insert_answer.bind(11, when_words[static_cast<std::size_t>(record.when)]);
  insert_answer.bind(16, record.place);
  const int about = record.trial >= 0 ? record.trial : record.about;
  bind_trial(insert_answer, 12, about);
  for (const int column : {13, 14, 15}) insert_answer.bind_null(column);
  if (about >= 0) {
    // A block that is one turn of another loop is about all that stands in it.
    const Study& study = bundle->study;
    const PlannedTrial& planned = plan.trials[static_cast<std::size_t>(about)];
    const bool block = record.when == Questionnaire::When::block;
    insert_answer.bind(13, planned.block);
    if (!block || study.nesting[0] == Factor::task) {
      insert_answer.bind(14, task_of(study, planned).name);
    }
    if (!block || study.nesting[0] == Factor::interface) {
      insert_answer.bind(15, interface_name(study, planned));
    }
  }
  insert_answer.run();
}

void Store::Implementation::put(const TrialSuperseded& record) {
  supersede_trial.bind(1, trial_uuid(record.trial)).run();
}

void Store::Implementation::put(const TrialEnded& record) {
  end_trial.bind(1, record.t_us).bind(2, to_text(record.outcome)).bind(3, record.d_best);
  end_trial.bind(4, record.d_final).bind(5, record.d_sum).bind(6, record.seconds_difference);
  end_trial.bind(7, record.first_below_us).bind(8, record.paused_us).bind(9, record.clicks);
  end_trial.bind(10, record.changes).bind(11, record.late_frames);
  const ProcessMeasures& process = record.process;
  end_trial.bind(12, process.d_area_m_s).bind(13, process.path_m).bind(14, process.reversals);
  end_trial.bind(15, process.drags).bind(16, process.controls_touched);
  end_trial.bind(17, process.examples_visited).bind(18, process.map_coverage);
  end_trial.bind(19, process.idle_us).bind(20, process.camera_moves);
  end_trial.bind(21, trial_uuid(record.trial)).run();
  ended.push_back(trial_uuid(record.trial));
  due = true;
}

// Its process stays: it still has it.
void Store::Implementation::put(const SessionDecided& record) {
  Statement decide(database, "UPDATE session SET outcome = ?, ended_utc = ? WHERE uuid = ?");
  decide.bind(1, to_text(record.outcome)).bind(3, session);
  if (record.outcome == Outcome::running) {
    decide.bind_null(2);
  } else {
    decide.bind(2, utc_now());
  }
  decide.run();
  due = true;
}

void Store::Implementation::put(const SessionEnded& record) {
  Statement end(database, "UPDATE session SET outcome = ? WHERE uuid = ?");
  end.bind(1, to_text(record.outcome)).bind(2, session).run();
  due = true;
}

Store::Store(const std::filesystem::path& file, const StudyBundle& bundle)
    : implementation_(std::make_unique<Implementation>(file, bundle)) {}

Store::~Store() {
  try {
    implementation_->commit();
  } catch (const DatabaseError&) {
    // What could not be written was reported when it was tried before.
  }
}

int Store::next_sequence(bool simulated, bool pilot) {
  return next_sequences(simulated, pilot, 1).front();
}

std::vector<int> Store::next_sequences(bool simulated, bool pilot, int count) {
  Statement rows(implementation_->database,
                 std::string("SELECT outcome, process, coalesce(process_start, ''), sequence, "
                             "participant IN (SELECT participant FROM tombstone WHERE removed = "
                             "'everything') FROM session WHERE simulated = ? AND pilot = ? AND ") +
                     of_counted_versions);
  rows.bind(1, simulated).bind(2, pilot).bind(3, implementation_->bundle->sha256);
  std::vector<GivenOrder> given;
  while (rows.step()) given.push_back({static_cast<int>(rows.integer(3)), state_of(rows)});
  return next_orders(given, round_of(implementation_->bundle->study), count);
}

bool Store::knows_participant(const std::string& code) {
  Statement known(implementation_->database, "SELECT 1 FROM participant WHERE code = ?");
  return known.bind(1, code).step();
}

int Store::next_simulated_number() {
  Statement last(implementation_->database,
                 "SELECT max(CAST(substr(code, 2) AS INTEGER)) FROM participant "
                 "WHERE code GLOB 'S[0-9]*'");
  last.step();
  return static_cast<int>(last.integer(0)) + 1;
}

std::string Store::next_simulated_code() {
  const std::string digits = std::to_string(next_simulated_number());
  return "S" + std::string(digits.size() < 3 ? 3 - digits.size() : 0, '0') + digits;
}

void Store::begin_session(const SessionHeader& header, const Plan& plan,
                          const std::vector<Record>& first) {
  Implementation& own = *implementation_;
  own.commit();
  Transaction transaction(own.database);
  own.refuse_amended();
  own.refuse_taken(header, plan.sequence);
  own.session = random_uuid();
  own.plan = plan;
  own.trials.assign(plan.trials.size(), "");
  own.seq = 0;
  own.durable = !header.simulated;
  const std::string participant = own.participant_uuid(header.participant);
  Statement study(own.database, "SELECT uuid FROM study WHERE study_sha256 = ?");
  study.bind(1, own.bundle->sha256).step();
  Statement insert(own.database,
                   "INSERT INTO session(uuid, study, participant, station, seed, sequence, "
                   "language, started_utc, outcome, simulated, pilot, process, machine, "
                   "process_start) VALUES (?,?,?,?,?,?,?,?,'running',?,?,?,?,?)");
  insert.bind(1, own.session).bind(2, study.text(0)).bind(3, participant).bind(4, header.station);
  insert.bind(5, static_cast<std::int64_t>(plan.seed)).bind(6, plan.sequence);
  insert.bind(7, header.language).bind(8, header.started_utc).bind(9, header.simulated);
  insert.bind(10, header.pilot).bind(11, std::int64_t{::getpid()}).bind(12, header.machine);
  insert.bind(13, process_start(::getpid())).run();
  study.reset();
  own.alive_us = 0;
  own.put_whole(first);
  transaction.commit();
  own.commit_durably();
}

namespace {

// To leave for another day is no interruption.
bool was_left(const LoggedSession& session) {
  bool left = false;
  for (const LoggedStep& step : session.steps) {
    if (step.sample) continue;
    if (step.event.kind == "leave") left = true;
    if (step.event.kind == "return") left = false;
  }
  return left;
}

}  // namespace

void Store::resume_session(const LoggedSession& session, const Plan& plan) {
  Implementation& own = *implementation_;
  own.commit();
  Transaction transaction(own.database);
  own.refuse_amended();
  Statement row(own.database,
                "SELECT outcome, process, coalesce(process_start, '') FROM session WHERE uuid = ?");
  if (!row.bind(1, session.uuid).step() || row.text(0) != "running" || holds_order(row)) {
    throw TakenError(TakenError::What::session, own.database.file() + ": the session of \"" +
                                                    session.participant +
                                                    "\" is not interrupted any more; start again");
  }
  row.reset();
  // Somebody else may have gone on with it, and died, since it was read.
  Statement last(own.database, "SELECT coalesce(max(seq), 0) FROM event WHERE session = ?");
  last.bind(1, session.uuid).step();
  if (last.integer(0) != session.last_seq) {
    throw TakenError(TakenError::What::session, own.database.file() + ": the session of \"" +
                                                    session.participant +
                                                    "\" has gone on meanwhile; start again");
  }
  last.reset();
  own.session = session.uuid;
  own.plan = plan;
  own.trials.assign(plan.trials.size(), "");
  for (const LoggedTrial& trial : session.trials) {
    own.trials.at(static_cast<std::size_t>(trial.position - 1)) = trial.uuid;  // the latest attempt
  }
  own.alive_us = session.last_us;
  own.seq = session.last_seq;
  own.durable = !session.simulated;
  Statement update(own.database,
                   "UPDATE session SET process = ?, process_start = ?, resumed = resumed + ? "
                   "WHERE uuid = ?");
  update.bind(1, std::int64_t{::getpid()}).bind(2, process_start(::getpid()));
  update.bind(3, std::int64_t{was_left(session) ? 0 : 1}).bind(4, session.uuid).run();
  transaction.commit();
}

std::vector<InterruptedSession> Store::interrupted_sessions(bool simulated, bool pilot) {
  Statement rows(implementation_->database,
                 "SELECT session.uuid, participant.code, session.station, session.started_utc, "
                 "process, coalesce(process_start, ''), "
                 "(SELECT position FROM trial WHERE session = session.uuid "
                 "ORDER BY started_us DESC, rowid DESC LIMIT 1), "
                 "(SELECT t_us FROM event WHERE session = session.uuid ORDER BY seq DESC LIMIT 1), "
                 "(SELECT kind FROM event WHERE session = session.uuid AND kind IN ('leave', "
                 "'return') ORDER BY seq DESC LIMIT 1) "
                 "FROM session JOIN study ON study.uuid = session.study "
                 "JOIN participant ON participant.uuid = session.participant "
                 "WHERE session.outcome = 'running' AND simulated = ? AND pilot = ? AND "
                 "study_sha256 = ? ORDER BY started_utc DESC, session.rowid DESC");
  rows.bind(1, simulated).bind(2, pilot).bind(3, implementation_->bundle->sha256);
  std::vector<InterruptedSession> sessions;
  while (rows.step()) {
    if (lives(rows.integer(4), rows.text(5))) continue;
    sessions.push_back({rows.text(0), rows.text(1), rows.text(2), rows.text(3),
                        static_cast<int>(rows.integer(6)), rows.integer(7),
                        rows.text(8) == "leave"});
  }
  return sessions;
}

LoggedSession Store::read_session(const std::string& uuid) {
  return study::read_session(implementation_->database, uuid);
}

void Store::trace_to(const std::string& file) {
  implementation_->trace.reset(
      ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600));
  if (implementation_->trace.get() < 0) throw OutsideError("cannot write the trace " + file);
}

void Store::write(const std::vector<Record>& step) {
  if (step.empty()) return;
  Implementation& own = *implementation_;
  own.begin();
  own.put_whole(step);
  if (!own.due) return;
  own.due = false;
  own.commit_durably();
  for (const std::string& trial : own.ended) own.say("trial " + trial + "\n");
  own.ended.clear();
}

bool Store::alive(std::int64_t t_us) {
  constexpr std::int64_t beat_us = 1'000'000;
  Implementation& own = *implementation_;
  if (t_us - own.alive_us < beat_us) return false;
  own.alive_us = t_us;
  own.begin();
  own.set_alive.bind(1, t_us).bind(2, own.session).run();
  return true;
}

void Store::write_frames(int trial, const FrameHistogram& frames) {
  Implementation& own = *implementation_;
  own.begin();
  Statement insert(own.database, "INSERT INTO frame_histogram VALUES (?,?,?,?,?)");
  const auto put = [&](const char* measure, const TimeHistogram& times) {
    for (const TimeHistogram::Row& row : times.rows()) {
      insert.bind(1, own.session).bind(3, measure).bind(4, row.least_us).bind(5, row.count);
      own.bind_trial(insert, 2, trial);
      insert.run();
    }
  };
  put("interval", frames.interval);
  put("work", frames.work);
}

Database& Store::database() { return implementation_->database; }

const std::string& Store::session() const { return implementation_->session; }

void Store::flush() { implementation_->commit(); }

void Store::end_session(const std::string& ended_utc) {
  Implementation& own = *implementation_;
  own.begin();
  Statement end(own.database, "UPDATE session SET ended_utc = ?, process = NULL WHERE uuid = ?");
  end.bind(1, ended_utc).bind(2, own.session).run();
  own.commit_durably();
  // Emptying the journal waits for the disk; a cohort does it now and then.
  if (!own.durable && ++own.unchecked < simulated_per_checkpoint) return;
  own.unchecked = 0;
  own.database.exec("PRAGMA wal_checkpoint(TRUNCATE)");
}

}  // namespace promenade::study
