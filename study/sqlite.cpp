#include "study/sqlite.h"

#include <sqlite3.h>

#include <filesystem>
#include <utility>

namespace promenade::study {
namespace {

// What to do about it; empty where only a programmer could.
const char* advice(int code) {
  switch (code & 0xFF) {  // the rest says more than is needed here
    case SQLITE_FULL:
      return "the disk is full; make room and start again, what was stored before is whole";
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "another program is writing to it; close that one and try again";
    case SQLITE_READONLY:
      return "it must not be written; allow writing to the file and its folder, or name another "
             "database";
    case SQLITE_CANTOPEN:
      return "it cannot be opened; check that the file and its folder are there and may be "
             "written";
    case SQLITE_IOERR:
      return "the disk failed to read or write it; check the disk and name a database on another";
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return "it is damaged or no database; keep it, and go on with another or with a copy of it";
    default:
      return "";
  }
}

[[noreturn]] void fail(const std::string& file, int code, const char* message) {
  const std::string said = message ? message : sqlite3_errstr(code);
  const std::string todo = advice(code);
  throw DatabaseError(code, file + ": " + (todo.empty() ? said : todo + " (" + said + ")"));
}

int open_flags(Database::Mode mode) {
  switch (mode) {
    case Database::Mode::read_only:
      return SQLITE_OPEN_READONLY;
    case Database::Mode::read_write:
      return SQLITE_OPEN_READWRITE;
    case Database::Mode::create:
    case Database::Mode::memory:
      return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  }
  return SQLITE_OPEN_READONLY;
}

// Reading a file in WAL mode leaves -wal and -shm files beside it, and fails where
// none can be made, unless SQLite is told that nobody writes: true without a -wal.
std::string resting_uri(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error) ||
      std::filesystem::exists(file + "-wal", error)) {
    return "";
  }
  std::string uri = "file:";
  for (const char letter : std::filesystem::absolute(file).string()) {
    if (letter == '%') {
      uri += "%25";
    } else if (letter == '?') {
      uri += "%3f";
    } else if (letter == '#') {
      uri += "%23";
    } else {
      uri += letter;
    }
  }
  return uri + "?immutable=1";
}

// What a session that was killed wrote last is in the -wal, and to read that SQLite may have
// to make a file beside it.
bool can_read_wal(sqlite3* handle) {
  const int code = sqlite3_exec(handle, "PRAGMA schema_version", nullptr, nullptr, nullptr) & 0xFF;
  return code != SQLITE_CANTOPEN && code != SQLITE_READONLY;
}

}  // namespace

bool DatabaseError::about_content() const {
  const int code = code_ & 0xFF;
  return code == SQLITE_CORRUPT || code == SQLITE_NOTADB || code == SQLITE_ERROR ||
         code == SQLITE_CONSTRAINT;
}

Database::Database(const std::string& file, Mode mode, int wait_ms) : file_(file) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(file, ignored);
  if (std::filesystem::is_fifo(status) || std::filesystem::is_character_file(status)) {
    fail(file, SQLITE_CANTOPEN, "it is a pipe or device");  // SQLite would wait for it
  }
  const std::string uri = mode == Mode::read_only ? resting_uri(file) : "";
  const char* place = mode == Mode::memory ? ":memory:" : file.c_str();
  const int code = uri.empty() ? sqlite3_open_v2(place, &handle_, open_flags(mode), nullptr)
                               : sqlite3_open_v2(uri.c_str(), &handle_,
                                                 open_flags(mode) | SQLITE_OPEN_URI, nullptr);
  if (code != SQLITE_OK) {
    const std::string message = handle_ ? sqlite3_errmsg(handle_) : sqlite3_errstr(code);
    sqlite3_close_v2(handle_);
    fail(file, code, message.c_str());
  }
  sqlite3_busy_timeout(handle_, wait_ms);
  const std::string wal = file + "-wal";
  if (mode != Mode::read_only || !std::filesystem::exists(wal, ignored)) return;
  if (can_read_wal(handle_)) return;
  sqlite3_close_v2(handle_);
  throw DatabaseError(SQLITE_CANTOPEN,
                      file + ": what was written last is in " + wal +
                          ", which can only be read where files may be made; copy both to a "
                          "folder that can be written, and name the copy");
}

Database::~Database() { sqlite3_close_v2(handle_); }

Database::Database(Database&& other) noexcept
    : file_(std::move(other.file_)), handle_(std::exchange(other.handle_, nullptr)) {}

bool Database::is_in_memory() const {
  const char* place = sqlite3_db_filename(handle_, "main");
  return place == nullptr || *place == '\0';
}

void Database::exec(const std::string& sql) {
  char* message = nullptr;
  const int code = sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, &message);
  if (code == SQLITE_OK) return;
  const std::string text = message ? message : sqlite3_errstr(code);
  sqlite3_free(message);
  fail(file_, code, text.c_str());
}

Statement::Statement(Database& database, std::string_view sql) : database_(&database) {
  check(sqlite3_prepare_v2(database.handle(), sql.data(), static_cast<int>(sql.size()), &handle_,
                           nullptr));
}

Statement::~Statement() { sqlite3_finalize(handle_); }

Statement::Statement(Statement&& other) noexcept
    : database_(other.database_), handle_(std::exchange(other.handle_, nullptr)) {}

void Statement::check(int code) const {
  if (code != SQLITE_OK) fail(database_->file(), code, sqlite3_errmsg(database_->handle()));
}

Statement& Statement::bind(int index, std::int64_t value) {
  check(sqlite3_bind_int64(handle_, index, value));
  return *this;
}

Statement& Statement::bind(int index, double value) {
  check(sqlite3_bind_double(handle_, index, value));
  return *this;
}

Statement& Statement::bind(int index, std::string_view text) {
  check(
      sqlite3_bind_text64(handle_, index, text.data(), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8));
  return *this;
}

Statement& Statement::bind_blob(int index, std::string_view bytes) {
  check(sqlite3_bind_blob64(handle_, index, bytes.data(), bytes.size(), SQLITE_TRANSIENT));
  return *this;
}

Statement& Statement::bind_null(int index) {
  check(sqlite3_bind_null(handle_, index));
  return *this;
}

Statement& Statement::bind_value(int index, const Statement& row, int column) {
  check(sqlite3_bind_value(handle_, index, sqlite3_column_value(row.handle_, column)));
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(handle_);
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  const std::string message = sqlite3_errmsg(database_->handle());
  sqlite3_reset(handle_);
  fail(database_->file(), code, message.c_str());
}

void Statement::run() {
  while (step()) {
  }
  reset();
}

void Statement::reset() { sqlite3_reset(handle_); }

int Statement::columns() const { return sqlite3_column_count(handle_); }

Statement::Type Statement::type(int column) const {
  switch (sqlite3_column_type(handle_, column)) {
    case SQLITE_INTEGER:
      return Type::integer;
    case SQLITE_FLOAT:
      return Type::real;
    case SQLITE_TEXT:
      return Type::text;
    case SQLITE_BLOB:
      return Type::blob;
    default:
      return Type::null;
  }
}

std::string Statement::column_name(int column) const {
  return sqlite3_column_name(handle_, column);
}

bool Statement::is_null(int column) const {
  return sqlite3_column_type(handle_, column) == SQLITE_NULL;
}

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(handle_, column); }

double Statement::real(int column) const { return sqlite3_column_double(handle_, column); }

std::optional<double> Statement::real_if_any(int column) const {
  return is_null(column) ? std::nullopt : std::optional(real(column));
}

std::string Statement::text(int column) const {
  const unsigned char* text = sqlite3_column_text(handle_, column);
  return text ? reinterpret_cast<const char*>(text) : "";
}

std::string_view Statement::text_view(int column) const {
  const unsigned char* text = sqlite3_column_text(handle_, column);
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(handle_, column));
  return text ? std::string_view(reinterpret_cast<const char*>(text), size) : std::string_view();
}

std::string_view Statement::blob(int column) const {
  const void* bytes = sqlite3_column_blob(handle_, column);
  return {static_cast<const char*>(bytes),
          static_cast<std::size_t>(sqlite3_column_bytes(handle_, column))};
}

Transaction::Transaction(Database& database) : database_(database) {
  database_.exec("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (open_) sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit() {
  database_.exec("COMMIT");
  open_ = false;
}

void backup(Database& from, Database& to) {
  sqlite3_backup* work = sqlite3_backup_init(to.handle(), "main", from.handle(), "main");
  int code = work ? sqlite3_backup_step(work, -1) : SQLITE_ERROR;
  // Locked by another program: wait as long as SQLite does for a statement.
  for (int tries = 0; (code == SQLITE_BUSY || code == SQLITE_LOCKED) && tries < 400; ++tries) {
    sqlite3_sleep(5);
    code = sqlite3_backup_step(work, -1);
  }
  if (work) sqlite3_backup_finish(work);
  if (code == SQLITE_DONE) return;
  // An error of the side that is read is known by its code only.
  const bool reading = code == SQLITE_CORRUPT || code == SQLITE_NOTADB;
  fail(reading ? from.file() : to.file(), code, work ? nullptr : sqlite3_errmsg(to.handle()));
}

}  // namespace promenade::study
