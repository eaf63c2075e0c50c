// Where everything stands in a TOML text, to the byte: what is needed to change one value and
// leave the rest alone. The library that reads TOML says only where values begin. It asks no more
// than an editor needs to know, so that a text which is no TOML has spans too; whoever edits by
// them reads the result with parse_toml and compares (study/toml_edit.h).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/place.h"
#include "study/toml_path.h"

namespace promenade::study {

struct Span {  // bytes
  std::size_t begin = 0, end = 0;
};

struct TomlEntrySpan;

// A value as it is written.
struct TomlNode : Span {
  enum class Form { scalar, array, table };  // table: { a = 1 }
  Form form = Form::scalar;
  std::vector<TomlNode> elements;
  std::vector<TomlEntrySpan> entries;
};

// `key = value`, or `a.b = value`.
struct TomlEntrySpan {
  std::vector<std::string> keys;
  std::size_t begin = 0;  // of the keys
  TomlNode value;
};

// A line of the file, or several where a value takes them.
struct TomlStatement : Span {  // with its line end
  enum class Kind { blank, remark, header, array_header, entry, broken };
  Kind kind = Kind::blank;
  TomlPath path;     // of the table that a header opens, or of the value of an entry
  TomlPath section;  // the table below whose header it stands
  TomlEntrySpan entry;

  bool is_header() const { return kind == Kind::header || kind == Kind::array_header; }
  bool has_content() const { return is_header() || kind == Kind::entry; }
};

using TomlSpans = std::vector<TomlStatement>;

TomlSpans scan_toml(std::string_view text);

// A value, and what holds it.
struct TomlHeld {
  const TomlStatement* statement = nullptr;
  const TomlNode* parent = nullptr;  // a list or { }; null: it is the value of the statement
  std::size_t place = 0;             // in the parent
  const TomlNode* node = nullptr;
};
// Nothing: no single value is written there (but perhaps a table with a header).
std::optional<TomlHeld> find_node(const TomlSpans& spans, const TomlPath& path);

// Of the value at a path, or of the table with all that stands below its header; nothing where
// there is none.
std::optional<Span> span_of(const TomlSpans& spans, const TomlPath& path);

// The path of the innermost value, or of the table, that is written at a byte.
TomlPath path_at(const TomlSpans& spans, std::size_t at);

// Lines and columns (characters) from 1, as problems name them.
std::size_t byte_at(std::string_view text, Place place);
int line_at(std::string_view text, std::size_t byte);

}  // namespace promenade::study
