#include "study/toml_spans.h"

#include <algorithm>
#include <map>

#include "study/utf8.h"

namespace promenade::study {
namespace {

constexpr int deepest = 64;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

struct NoToml {};  // thrown: what follows in this line is not understood

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {
    if (text_.starts_with(byte_order_mark)) at_ = byte_order_mark.size();
  }

  TomlSpans run() {
    TomlSpans spans;
    while (at_ < text_.size()) spans.push_back(statement());
    return spans;
  }

 private:
  char now() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool ended() const { return at_ >= text_.size(); }
  bool at_line_end() const { return ended() || now() == '\n' || text_.substr(at_, 2) == "\r\n"; }
  void skip(std::size_t letters) { at_ = std::min(at_ + letters, text_.size()); }
  bool takes(std::string_view word) {
    if (!text_.substr(at_).starts_with(word)) return false;
    at_ += word.size();
    return true;
  }
  void need(std::string_view word) {
    if (!takes(word)) throw NoToml{};
  }
  void skip_blanks() {
    while (now() == ' ' || now() == '\t') ++at_;
  }
  void skip_remark() {
    if (now() != '#') return;
    while (!ended() && now() != '\n') ++at_;
  }
  void skip_line() {
    at_ = std::min(text_.find('\n', at_), text_.size());
    if (!ended()) ++at_;
  }
  // Within lists, where remarks and line ends are blanks.
  void skip_lines() {
    while (!ended()) {
      skip_remark();
      if (now() != ' ' && now() != '\t' && now() != '\n' && now() != '\r') return;
      ++at_;
    }
  }

  TomlStatement statement() {
    TomlStatement statement;
    statement.begin = at_;
    const std::size_t start = at_;
    try {
      read(statement);
      skip_blanks();
      skip_remark();
      if (!at_line_end()) throw NoToml{};
    } catch (const NoToml&) {
      at_ = start;
      statement = {};
      statement.begin = start;
      statement.kind = TomlStatement::Kind::broken;
    }
    if (statement.is_header()) open(statement);
    statement.section = section_;
    if (statement.kind == TomlStatement::Kind::entry) {
      statement.path = section_;
      for (const std::string& key : statement.entry.keys) statement.path.emplace_back(key);
    }
    skip_line();
    statement.end = at_;
    return statement;
  }

  void read(TomlStatement& statement) {
    using Kind = TomlStatement::Kind;
    skip_blanks();
    if (at_line_end()) return;
    if (now() == '#') {
      statement.kind = Kind::remark;
    } else if (now() == '[') {
      const bool array = text_.substr(at_, 2) == "[[";
      at_ += array ? 2 : 1;
      for (const std::string& key : keys()) statement.path.emplace_back(key);
      need(array ? "]]" : "]");
      statement.kind = array ? Kind::array_header : Kind::header;
    } else {
      statement.entry = entry(0);
      statement.kind = Kind::entry;
    }
  }

  // Fills in which tables of [[lists]] are meant: always the last ones.
  void open(TomlStatement& statement) {
    TomlPath full;
    for (std::size_t i = 0; i < statement.path.size(); ++i) {
      full.push_back(statement.path[i]);
      const bool last = i + 1 == statement.path.size();
      const auto known = counts_.find(to_text(full));
      if (last && statement.kind == TomlStatement::Kind::array_header) {
        full.emplace_back(counts_[to_text(full)]++);
      } else if (known != counts_.end()) {
        full.emplace_back(known->second - 1);
      }
    }
    statement.path = section_ = full;
  }

  std::vector<std::string> keys() {
    std::vector<std::string> keys;
    do {
      skip_blanks();
      keys.push_back(key());
      skip_blanks();
    } while (takes("."));
    return keys;
  }

  std::string key() {
    const std::size_t start = at_;
    if (now() == '"' || now() == '\'') {
      string();
      const std::string_view inside = text_.substr(start + 1, at_ - start - 2);
      return text_[start] == '"' ? unescaped(inside) : std::string(inside);
    }
    while (!ended() && is_bare_key(text_.substr(at_, 1))) ++at_;
    if (at_ == start) throw NoToml{};
    return std::string(text_.substr(start, at_ - start));
  }

  static std::string unescaped(std::string_view text) {
    std::string key;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] != '\\' || i + 1 == text.size()) {
        key += text[i];
        continue;
      }
      const char letter = text[++i];
      const std::size_t digits = letter == 'u' ? 4 : letter == 'U' ? 8 : 0;
      if (digits > 0) {
        const std::string code(text.substr(i + 1, digits));
        append_character(key, static_cast<unsigned int>(std::strtoul(code.c_str(), nullptr, 16)));
        i += digits;
      } else {
        key += letter == 'n' ? '\n' : letter == 't' ? '\t' : letter == 'r' ? '\r' : letter;
      }
    }
    return key;
  }

  TomlEntrySpan entry(int depth) {
    TomlEntrySpan entry;
    entry.begin = at_;
    entry.keys = keys();
    need("=");
    skip_blanks();
    entry.value = value(depth);
    return entry;
  }

  TomlNode value(int depth) {
    if (depth > deepest) throw NoToml{};
    TomlNode node;
    node.begin = at_;
    if (now() == '[') {
      array(node, depth);
    } else if (now() == '{') {
      table(node, depth);
    } else if (now() == '"' || now() == '\'') {
      string();
    } else {
      word();
    }
    node.end = at_;
    return node;
  }

  void array(TomlNode& node, int depth) {
    node.form = TomlNode::Form::array;
    ++at_;
    skip_lines();
    while (!takes("]")) {
      node.elements.push_back(value(depth + 1));
      skip_lines();
      if (now() != ']') need(",");
      skip_lines();
    }
  }

  void table(TomlNode& node, int depth) {
    node.form = TomlNode::Form::table;
    ++at_;
    skip_blanks();
    while (!takes("}")) {
      node.entries.push_back(entry(depth + 1));
      skip_blanks();
      if (now() != '}') need(",");
      skip_blanks();
    }
  }

  void string() {
    const char quote = now();
    const std::string three(3, quote);
    if (text_.substr(at_, 3) != three) {
      ++at_;
      while (now() != quote) {
        if (at_line_end()) throw NoToml{};
        skip(now() == '\\' && quote == '"' ? 2 : 1);
      }
      ++at_;
      return;
    }
    at_ += 3;
    while (text_.substr(at_, 3) != three) {
      if (ended()) throw NoToml{};
      skip(now() == '\\' && quote == '"' ? 2 : 1);
    }
    at_ += 3;
    // Up to two more belong to the text.
    for (int i = 0; i < 2 && now() == quote; ++i) ++at_;
  }

  // A number, a date, true or false; a date may have a blank inside.
  void word() {
    const std::size_t start = at_;
    at_ = std::min(text_.find_first_of(",]}#\r\n", at_), text_.size());
    while (at_ > start && (text_[at_ - 1] == ' ' || text_[at_ - 1] == '\t')) --at_;
    if (at_ == start) throw NoToml{};
  }

  std::string_view text_;
  std::size_t at_ = 0;
  TomlPath section_;
  std::map<std::string, std::size_t> counts_;  // of [[lists]], by their paths
};

// Into { } and [ ], from the step `from` on; false: there is nothing.
bool descend(TomlHeld& held, const TomlPath& path, std::size_t from) {
  if (from == path.size()) return true;
  const TomlNode& node = *held.node;
  held.parent = &node;
  if (const auto* place = std::get_if<std::size_t>(&path[from])) {
    if (*place >= node.elements.size()) return false;
    held.place = *place;
    held.node = &node.elements[*place];
    return descend(held, path, from + 1);
  }
  for (std::size_t i = 0; i < node.entries.size(); ++i) {
    const TomlPath keys(node.entries[i].keys.begin(), node.entries[i].keys.end());
    const TomlPath here(path.begin() + static_cast<std::ptrdiff_t>(from), path.end());
    if (!begins_with(here, keys)) continue;
    held.place = i;
    held.node = &node.entries[i].value;
    return descend(held, path, from + keys.size());
  }
  return false;
}

// The innermost value within a node that holds the byte.
void follow(const TomlNode& node, std::size_t at, TomlPath& path) {
  for (std::size_t i = 0; i < node.elements.size(); ++i) {
    if (at < node.elements[i].begin || at >= node.elements[i].end) continue;
    path.emplace_back(i);
    return follow(node.elements[i], at, path);
  }
  for (const TomlEntrySpan& entry : node.entries) {
    if (at < entry.begin || at >= entry.value.end) continue;
    path.insert(path.end(), entry.keys.begin(), entry.keys.end());
    return follow(entry.value, at, path);
  }
}

}  // namespace

TomlSpans scan_toml(std::string_view text) { return Scanner(text).run(); }

std::optional<TomlHeld> find_node(const TomlSpans& spans, const TomlPath& path) {
  for (const TomlStatement& statement : spans) {
    if (statement.kind != TomlStatement::Kind::entry) continue;
    if (!begins_with(path, statement.path)) continue;
    TomlHeld held{&statement, nullptr, 0, &statement.entry.value};
    if (descend(held, path, statement.path.size())) return held;
  }
  return std::nullopt;
}

std::optional<Span> span_of(const TomlSpans& spans, const TomlPath& path) {
  if (const auto held = find_node(spans, path)) return *held->node;
  std::optional<Span> whole;
  for (const TomlStatement& statement : spans) {
    if (!statement.has_content() || !begins_with(statement.path, path)) continue;
    if (!whole) whole = statement;
    whole->end = statement.end;
  }
  return whole;
}

TomlPath path_at(const TomlSpans& spans, std::size_t at) {
  for (const TomlStatement& statement : spans) {
    if (at < statement.begin || at >= statement.end) continue;
    if (statement.kind != TomlStatement::Kind::entry) return statement.section;
    TomlPath path = statement.path;
    follow(statement.entry.value, at, path);
    return path;
  }
  return {};
}

std::size_t byte_at(std::string_view text, Place place) {
  std::size_t at = 0;
  for (int line = 1; line < place.line && at < text.size(); ++line) {
    at = std::min(text.find('\n', at), text.size() - 1) + 1;
  }
  if (at == 0 && text.starts_with(byte_order_mark)) at = byte_order_mark.size();
  for (int column = 1; column < place.column && at < text.size() && text[at] != '\n'; ++column) {
    do {
      ++at;
    } while (at < text.size() && !begins_character(text[at]));
  }
  return at;
}

int line_at(std::string_view text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
}

}  // namespace promenade::study
