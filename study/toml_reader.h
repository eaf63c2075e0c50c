// Reads a TOML file by what is wanted from it: typed values, every problem with
// its place, all problems of a file in one run. A key that nobody asked for is
// unknown, and finish() says so with the name that was probably meant.
//
//   TomlReader reader(file, text);
//   const TomlTable set = reader.root().table("set").value_or(reader.empty());
//   recipe.name = set.required_text("name");
//   recipe.fps = set.number("fps", 1, 1000).value_or(30);
//   reader.finish();  // throws InputError with all problems
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "motion/place.h"
#include "motion/problem.h"

namespace promenade::study {

// A value of the file, whatever its type.
struct TomlValue {
  enum class Kind { table, array, text, integer, number, boolean, date };
  struct Entry;
  Kind kind = Kind::table;
  Place place;
  std::string text;
  double number = 0;  // integers too
  std::int64_t integer = 0;
  bool truth = false;
  std::vector<Entry> entries;       // of a table, in the order of the file
  std::vector<TomlValue> elements;  // of an array
};
struct TomlValue::Entry {
  std::string key;
  Place place;  // of the key
  TomlValue value;
};

struct TomlText {
  std::string text;
  Place place;
};
using TomlScalar = std::variant<bool, double, std::string>;

class TomlReader;

// A table of the file, to be asked for its keys. A key that is not there gives
// nothing; one of the wrong type or out of range is a problem and gives nothing.
class TomlTable {
 public:
  Place place() const { return value_->place; }
  Place place(std::string_view key) const;  // of its value; of the table if it is missing
  bool has(std::string_view key) const;     // does not count as asking for it

  std::optional<std::string> text(std::string_view key) const;
  std::string required_text(std::string_view key) const;  // not empty; "" after a problem
  std::optional<std::string> choice(std::string_view key,
                                    const std::vector<std::string>& choices) const;
  std::optional<double> number(std::string_view key, double least, double most) const;
  std::optional<std::int64_t> integer(std::string_view key, std::int64_t least,
                                      std::int64_t most) const;
  std::optional<bool> boolean(std::string_view key) const;
  std::optional<TomlScalar> scalar(std::string_view key) const;  // text, number or boolean
  std::optional<TomlTable> table(std::string_view key) const;

  std::vector<TomlText> texts(std::string_view key) const;    // an array of texts
  std::vector<double> numbers(std::string_view key) const;    // an array of numbers
  std::vector<TomlTable> tables(std::string_view key) const;  // [[key]] or an array of {}
  std::vector<std::string> keys() const;  // in the order of the file; asks for none

  // Is the value of this key a text (true), where a text or something else may stand?
  bool is(std::string_view key, TomlValue::Kind kind) const;
  void require(std::string_view key) const;  // a problem if it is missing
  void error(std::string_view key, const std::string& message) const;
  // About the table as a whole: what it lacks, or how it fits to others.
  void error(const std::string& message) const;
  void warning(std::string_view key, const std::string& message) const;
  TomlReader& reader() const { return *reader_; }

 private:
  friend class TomlReader;
  TomlTable(TomlReader& reader, const TomlValue& value) : reader_(&reader), value_(&value) {}
  const TomlValue* find(std::string_view key) const;
  const TomlValue* ask(std::string_view key) const;
  // The value if it has this kind; else a problem that names `wanted`.
  const TomlValue* ask(std::string_view key, TomlValue::Kind kind, const char* wanted) const;
  // Elements of an array that `take` accepts (it gives an optional); the others are problems.
  template <class Element, class Take>
  std::vector<Element> list(std::string_view key, const char* wanted, Take take) const;
  TomlReader* reader_;
  const TomlValue* value_;
};

class TomlReader {
 public:
  // Lines that are no TOML are problems and left out; if that cannot be, root() is an
  // empty table. What such a file lacks is no problem any more: it may have stood there.
  TomlReader(std::string file, std::string_view text);
  TomlReader(const TomlReader&) = delete;
  TomlReader& operator=(const TomlReader&) = delete;

  TomlTable root() { return {*this, root_}; }
  TomlTable empty() { return {*this, empty_}; }  // to go on with after a missing table
  const std::string& file() const { return file_; }

  void add(Place place, const std::string& message, Severity severity = Severity::error);
  // Problems found elsewhere while reading what this file names.
  void add(const std::vector<Problem>& problems);
  bool ok() const { return !has_error(problems_); }
  bool parsed() const { return parsed_; }  // there is something to ask
  bool whole() const { return whole_; }    // no line was left out

  // Names the unknown keys of every table that was asked for anything, then throws
  // InputError with all problems by their places if one is an error. Returns the
  // warnings otherwise.
  std::vector<Problem> finish();

 private:
  friend class TomlTable;
  void report_unknown_keys(const TomlValue& table);
  std::string file_;
  TomlValue root_, empty_;
  std::map<const TomlValue*, std::set<std::string, std::less<>>> asked_;
  bool parsed_ = false, whole_ = false;
  std::vector<Problem> problems_;
};

// "a text", "a table" and so on, for messages.
const char* kind_name(TomlValue::Kind kind);

}  // namespace promenade::study
