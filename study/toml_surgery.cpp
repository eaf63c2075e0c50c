#include "study/toml_surgery.h"

#include <algorithm>

#include "motion/problem.h"

namespace promenade::study {
namespace {

using Kind = TomlStatement::Kind;

std::string dotted(const TomlPath& keys) {
  std::string text;
  for (const TomlStep& step : keys) {
    const auto* key = std::get_if<std::string>(&step);
    if (key != nullptr) text += (text.empty() ? "" : ".") + written_key(*key);
  }
  return text;
}

bool is_over_lines(std::string_view written) {
  return written.starts_with(R"(""")") || written.starts_with("'''");
}

}  // namespace

TomlSurgery::TomlSurgery(const std::string& file, const std::string& text)
    : file_(file),
      text_(text),
      spans_(scan_toml(text)),
      line_end_(text.find("\r\n") != std::string::npos ? "\r\n" : "\n") {}

void TomlSurgery::refuse(const std::string& sentence) const { throw InputError(file_, sentence); }

std::string TomlSurgery::edited(const TomlEdit& edit) {
  switch (edit.kind) {
    case TomlEdit::Kind::set:
      set(edit.path, edit.value);
      break;
    case TomlEdit::Kind::remove:
      remove(edit.path);
      break;
    case TomlEdit::Kind::insert:
      insert(edit.path, edit.at, edit.value);
      break;
    case TomlEdit::Kind::move:
      move(edit.path, edit.at, edit.to);
      break;
  }
  return with_changes();
}

// Changes do not overlap; those at one place stay in their order.
std::string TomlSurgery::with_changes() const {
  std::vector<Change> changes = changes_;
  std::stable_sort(changes.begin(), changes.end(),
                   [](const Change& a, const Change& b) { return a.begin < b.begin; });
  std::string result;
  std::size_t at = 0;
  for (const Change& change : changes) {
    result += text_.substr(at, change.begin - at) + change.text;
    at = change.end;
  }
  return result + text_.substr(at);
}

// `before`: the value that it takes the place of, whose manner it keeps; null: none.
std::string TomlSurgery::written(const TomlValue& value, const TomlHeld* before) const {
  const bool lines = value.kind == TomlValue::Kind::text &&
                     (before == nullptr ? value.text.find('\n') != std::string::npos
                                        : is_over_lines(bytes(*before->node)));
  return lines ? written_lines(value.text, line_end_) : written_value(value);
}

void TomlSurgery::set(const TomlPath& path, const TomlValue& value) {
  if (path.empty()) refuse("the file as a whole is no value");
  if (const auto held = find_node(spans_, path)) {
    return replace(*held->node, written(value, &*held));
  }
  if (span_of(spans_, path)) {
    refuse("\"" + to_text(path) + "\" has a section of its own in the file; change what is in it");
  }
  if (!std::holds_alternative<std::string>(path.back())) {
    refuse("there is no \"" + to_text(path) + "\" in the file");
  }
  add(parent_of(path), std::get<std::string>(path.back()), value);
}

void TomlSurgery::add(const TomlPath& table, const std::string& key, const TomlValue& value) {
  if (const auto held = find_node(spans_, table)) {
    if (held->node->form != TomlNode::Form::table) {
      refuse("\"" + to_text(table) + "\" is no table, so that it has no \"" + key + "\"");
    }
    return put_in_table(*held->node, written_key(key) + " = " + written_value(value));
  }
  const std::string line = written_key(key) + " = " + written(value, nullptr);
  if (add_below_header(table, line) || add_dotted(table, key, value) ||
      add_above_header(table, line)) {
    return;
  }
  if (table.size() == 1) return add_section(header_of(table, false), line + line_end_);
  if (!std::holds_alternative<std::string>(table.back())) {
    refuse("there is no \"" + to_text(table) + "\" in the file");
  }
  add(parent_of(table), std::get<std::string>(table.back()), toml_table({{key, value}}));
}

// After the last line of the section; the root's section is what stands above all headers.
bool TomlSurgery::add_below_header(const TomlPath& table, const std::string& line) {
  std::size_t at = 0;
  bool found = table.empty();
  std::string indent;
  for (const TomlStatement& statement : spans_) {
    const bool here = statement.section == table;
    if (here && statement.is_header()) {
      found = true;
      at = statement.end;
    } else if (here && statement.kind == Kind::entry) {
      at = statement.end;
      indent = text_.substr(statement.begin,
                            text_.find_first_not_of(" \t", statement.begin) - statement.begin);
    }
  }
  if (!found) return false;
  if (!table.empty() || at > 0) {
    put_line(at, indent + line);
    return true;
  }
  const auto header = std::find_if(spans_.begin(), spans_.end(),
                                   [](const TomlStatement& one) { return one.is_header(); });
  if (header == spans_.end()) {
    put_line(text_.size(), line);
  } else {
    const auto place = static_cast<std::size_t>(header - spans_.begin());
    put(spans_[remarks_before(place)].begin, line + line_end_ + line_end_);
  }
  return true;
}

// Of a table that is made by keys with dots, `table.other = 1`.
bool TomlSurgery::add_dotted(const TomlPath& table, const std::string& key,
                             const TomlValue& value) {
  const TomlStatement* last = nullptr;
  for (const TomlStatement& statement : spans_) {
    if (statement.kind == Kind::entry && statement.path.size() > table.size() &&
        begins_with(statement.path, table) && !begins_with(statement.section, table)) {
      last = &statement;
    }
  }
  if (last == nullptr) return false;
  const TomlPath keys(table.begin() + static_cast<std::ptrdiff_t>(last->section.size()),
                      table.end());
  put_line(last->end, dotted(joined(keys, key)) + " = " + written(value, nullptr));
  return true;
}

// Of a table that has sub-tables in the file and no header.
bool TomlSurgery::add_above_header(const TomlPath& table, const std::string& line) {
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    if (!spans_[i].is_header() || !begins_with(spans_[i].path, table)) continue;
    put(spans_[remarks_before(i)].begin,
        header_of(table, false) + line_end_ + line + line_end_ + line_end_);
    return true;
  }
  return false;
}

// At the end of the file, behind an empty line.
void TomlSurgery::add_section(const std::string& header, const std::string& lines) {
  const bool whole_line = text_.empty() || text_.back() == '\n';
  const bool gap = text_.empty() || (!spans_.empty() && spans_.back().kind == Kind::blank);
  put(text_.size(), (whole_line ? "" : line_end_) + (gap && whole_line ? "" : line_end_) + header +
                        line_end_ + lines);
}

void TomlSurgery::put_line(std::size_t at, const std::string& line) {
  const bool behind_line = at == 0 || text_[at - 1] == '\n';
  put(at, behind_line ? line + line_end_ : line_end_ + line);
}

void TomlSurgery::put_in_table(const TomlNode& node, const std::string& entry) {
  if (node.entries.empty()) return replace(node, "{ " + entry + " }");
  put(node.entries.back().value.end, ", " + entry);
}

void TomlSurgery::remove(const TomlPath& path) {
  if (path.empty()) refuse("the file as a whole cannot be removed");
  const auto held = find_node(spans_, path);
  if (!held) return remove_parts(path);
  if (held->parent == nullptr) return erase(*held->statement);
  if (held->parent->form == TomlNode::Form::array) {
    return remove_element(*held->parent, held->place);
  }
  remove_entry(*held->parent, held->place);
}

void TomlSurgery::remove_entry(const TomlNode& table, std::size_t place) {
  const auto& entries = table.entries;
  if (entries.size() == 1) return replace(table, "{}");
  if (place + 1 < entries.size()) {
    return erase({entries[place].begin, entries[place + 1].begin});
  }
  erase({entries[place - 1].value.end, entries[place].value.end});
}

// A table or a list that is made of headers, or of keys with dots.
void TomlSurgery::remove_parts(const TomlPath& path) {
  if (const auto block = block_of(path)) {
    refuse_scattered(*block, path);
    return remove_block(*block);
  }
  const std::vector<Block> blocks = blocks_of(path);
  for (const Block& block : blocks) remove_block(block);
  if (!blocks.empty()) return;
  for (const TomlStatement& statement : spans_) {
    if (!statement.has_content() || !begins_with(statement.path, path)) continue;
    if (statement.is_header()) refuse("remove the parts of \"" + to_text(path) + "\" one by one");
    erase(statement);
  }
  if (changes_.empty()) refuse("there is no \"" + to_text(path) + "\" in the file");
}

std::string TomlSurgery::header_of(const TomlPath& path, bool array) const {
  return (array ? "[[" : "[") + dotted(path) + (array ? "]]" : "]");
}

}  // namespace promenade::study
