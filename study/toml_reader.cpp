#include "study/toml_reader.h"

#include <algorithm>

#include "motion/did_you_mean.h"
#include "study/toml_parse.h"

namespace promenade::study {

const char* kind_name(TomlValue::Kind kind) {
  switch (kind) {
    case TomlValue::Kind::table:
      return "a table";
    case TomlValue::Kind::array:
      return "a list";
    case TomlValue::Kind::text:
      return "a text";
    case TomlValue::Kind::integer:
      return "a whole number";
    case TomlValue::Kind::number:
      return "a number";
    case TomlValue::Kind::boolean:
      return "true or false";
    case TomlValue::Kind::date:
      return "a date or time";
  }
  return "something else";
}

TomlReader::TomlReader(std::string file, std::string_view text) : file_(std::move(file)) {
  ParsedToml parsed = parse_lines_of_toml(file_, text);
  root_ = std::move(parsed.root);
  parsed_ = parsed.usable;
  problems_ = std::move(parsed.problems);
  whole_ = problems_.empty();
}

void TomlReader::add(Place place, const std::string& message, Severity severity) {
  // What a broken file lacks is not worth a word, and what was said is not said again.
  const bool known = std::any_of(problems_.begin(), problems_.end(), [&](const Problem& problem) {
    return problem.line == place.line && problem.column == place.column &&
           problem.message == message && problem.file == file_;
  });
  if (parsed_ && !known) {
    problems_.push_back({file_, place.line, place.column, message, severity});
  }
}

void TomlReader::add(const std::vector<Problem>& problems) {
  problems_.insert(problems_.end(), problems.begin(), problems.end());
}

void TomlReader::report_unknown_keys(const TomlValue& table) {
  const auto asked = asked_.find(&table);
  if (asked != asked_.end()) {
    const std::vector<std::string> known(asked->second.begin(), asked->second.end());
    for (const TomlValue::Entry& entry : table.entries) {
      if (asked->second.count(entry.key) > 0) continue;
      add(entry.place, "unknown key \"" + entry.key + "\"" + did_you_mean(entry.key, known));
    }
  }
  for (const TomlValue::Entry& entry : table.entries) report_unknown_keys(entry.value);
  for (const TomlValue& element : table.elements) report_unknown_keys(element);
}

std::vector<Problem> TomlReader::finish() {
  report_unknown_keys(root_);
  std::stable_sort(problems_.begin(), problems_.end(), [this](const Problem& a, const Problem& b) {
    if (a.file != b.file) return a.file == file_;
    return a.line != b.line ? a.line < b.line : a.column < b.column;
  });
  if (has_error(problems_)) throw InputError(problems_);
  return problems_;
}

}  // namespace promenade::study
