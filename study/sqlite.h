// SQLite as values that clean up after themselves, under SQLite's own names.
// Failures throw DatabaseError with SQLite's message and the file.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "motion/problem.h"

struct sqlite3;
struct sqlite3_stmt;

namespace promenade::study {

class DatabaseError : public OutsideError {
 public:
  DatabaseError(int code, const std::string& message) : OutsideError(message), code_(code) {}
  int code() const { return code_; }  // SQLite's result code
  bool about_content() const;         // of the file, and not the disk, a lock or the rights

 private:
  int code_;
};

class Database {
 public:
  // memory: an empty one that is nowhere on the disk, under the name of a file.
  enum class Mode { read_only, read_write, create, memory };
  // ":memory:" in tests. `wait_ms`: for whoever holds a lock.
  Database(const std::string& file, Mode mode, int wait_ms = 2000);
  ~Database();
  Database(Database&& other) noexcept;
  Database& operator=(Database&&) = delete;
  Database(const Database&) = delete;

  void exec(const std::string& sql);  // one or several statements without results
  const std::string& file() const { return file_; }
  bool is_in_memory() const;
  sqlite3* handle() const { return handle_; }

 private:
  std::string file_;
  sqlite3* handle_ = nullptr;
};

// A prepared statement. bind(1, ...) counts from 1, column(0) from 0, as SQLite does.
class Statement {
 public:
  Statement(Database& database, std::string_view sql);
  ~Statement();
  Statement(Statement&& other) noexcept;
  Statement& operator=(Statement&&) = delete;
  Statement(const Statement&) = delete;

  Statement& bind(int index, std::int64_t value);
  Statement& bind(int index, int value) { return bind(index, std::int64_t{value}); }
  Statement& bind(int index, bool value) { return bind(index, std::int64_t{value}); }
  Statement& bind(int index, double value);
  Statement& bind(int index, std::string_view text);
  Statement& bind(int index, const char* text) { return bind(index, std::string_view(text)); }
  Statement& bind(int index, const std::string& text) {
    return bind(index, std::string_view(text));
  }
  Statement& bind_blob(int index, std::string_view bytes);
  Statement& bind_null(int index);
  Statement& bind_value(int index, const Statement& row, int column);  // of whatever type
  template <typename T>
  Statement& bind(int index, const std::optional<T>& value) {
    return value ? bind(index, *value) : bind_null(index);
  }

  bool step();  // true: a row is there
  void run();   // step to the end and reset, for statements without results
  void reset();

  enum class Type { null, integer, real, text, blob };

  int columns() const;
  Type type(int column) const;
  std::string column_name(int column) const;
  bool is_null(int column) const;
  std::int64_t integer(int column) const;
  double real(int column) const;
  std::optional<double> real_if_any(int column) const;  // nothing: null
  std::string text(int column) const;
  std::string_view text_view(int column) const;  // until the next step()
  std::string_view blob(int column) const;       // valid until the next step

 private:
  void check(int code) const;
  Database* database_;
  sqlite3_stmt* handle_ = nullptr;
};

// Rolls back unless committed.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& database_;
  bool open_ = true;
};

// All of one database into another, over what is there (sqlite3_backup). Inside a transaction
// of `from` it is as that sees it.
void backup(Database& from, Database& to);

}  // namespace promenade::study
