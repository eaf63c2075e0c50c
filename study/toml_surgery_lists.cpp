// Elements of lists, between [ and ] on one line or over several, or as [[blocks]].
#include <algorithm>
#include <numeric>

#include "study/toml_surgery.h"

namespace promenade::study {
namespace {

// The order after one element was moved.
std::vector<std::size_t> moved_order(std::size_t count, std::size_t from, std::size_t to) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto at = [&](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
  if (from < to) {
    std::rotate(at(from), at(from + 1), at(to + 1));
  } else {
    std::rotate(at(to), at(from), at(from + 1));
  }
  return order;
}

}  // namespace

void TomlSurgery::insert(const TomlPath& list, std::size_t at, const TomlValue& value) {
  const auto held = find_node(spans_, list);
  if (held && held->node->form == TomlNode::Form::array) {
    if (at > held->node->elements.size()) refuse("\"" + to_text(list) + "\" is not that long");
    return insert_element(*held->node, at, written_value(value));
  }
  if (held || list.empty()) refuse("\"" + to_text(list) + "\" is no list");
  const std::vector<Block> blocks = blocks_of(list);
  const bool table = value.kind == TomlValue::Kind::table;
  if (at > blocks.size()) refuse("\"" + to_text(list) + "\" is not that long");
  if (!blocks.empty() || (list.size() == 1 && table)) {
    if (!table) refuse("\"" + to_text(list) + "\" is a list of sections");
    return insert_block(list, blocks, at, value);
  }
  set(list, toml_array({value}));
}

void TomlSurgery::insert_element(const TomlNode& list, std::size_t at, const std::string& value) {
  if (at == list.elements.size()) return append_element(list, value);
  const std::size_t begin = list.elements[at].begin;
  if (!begins_line(begin)) return put(begin, value + ", ");
  const std::size_t line = text_.rfind('\n', begin) + 1;
  put(begin, value + "," + line_end_ + text_.substr(line, begin - line));
}

void TomlSurgery::append_element(const TomlNode& list, const std::string& value) {
  if (list.elements.empty()) return put(list.begin + 1, value);
  const std::size_t place = list.elements.size() - 1;
  const TomlNode& last = list.elements[place];
  const Span trail = trail_of(list, place);
  const bool comma = text_.substr(last.end, trail.begin - last.end).find(',') != std::string::npos;
  if (!begins_line(last.begin)) {
    // Behind a comma, if there is one, which then stands between.
    return put(comma ? trail.begin : last.end, (comma ? " " : ", ") + value + (comma ? "," : ""));
  }
  const std::size_t line = text_.rfind('\n', last.begin) + 1;
  const std::string indent = text_.substr(line, last.begin - line);
  if (!comma) put(last.end, ",");
  put(trail.end, line_end_ + indent + value + (comma ? "," : ""));
}

void TomlSurgery::remove_element(const TomlNode& list, std::size_t place) {
  const auto& elements = list.elements;
  const Span trail = trail_of(list, place);
  const bool line_behind =
      trail.end < text_.size() && text_.find_first_of("\r\n", trail.end) == trail.end;
  if (begins_line(elements[place].begin) && line_behind) {
    const std::size_t line = text_.rfind('\n', elements[place].begin) + 1;
    return erase({line, text_.find('\n', trail.end) + 1});
  }
  if (place + 1 < elements.size()) return erase({elements[place].begin, elements[place + 1].begin});
  if (place > 0) return erase({elements[place - 1].end, elements[place].end});
  erase({elements[place].begin, trail.begin});
}

// From behind the comma of an element (or the element, if there is none) over blanks and a remark
// to the end of its line.
Span TomlSurgery::trail_of(const TomlNode& list, std::size_t place) const {
  const bool last = place + 1 == list.elements.size();
  const std::size_t most = last ? list.end - 1 : list.elements[place + 1].begin;
  std::size_t begin = list.elements[place].end;
  const std::size_t comma = text_.find_first_not_of(" \t", begin);
  if (comma < most && text_[comma] == ',') begin = comma + 1;
  std::size_t end = text_.find_first_not_of(" \t", begin);
  if (end < most && text_[end] == '#') end = text_.find_first_of("\r\n", end);
  const bool to_line_end = end < most && (text_[end] == '\n' || text_[end] == '\r');
  return {begin, to_line_end ? end : begin};
}

bool TomlSurgery::begins_line(std::size_t at) const {
  const std::size_t before = text_.find_last_not_of(" \t", at - 1);
  return before != std::string::npos && text_[before] == '\n';
}

void TomlSurgery::move(const TomlPath& list, std::size_t from, std::size_t to) {
  const auto held = find_node(spans_, list);
  if (held && std::max(from, to) < held->node->elements.size()) {
    return move_elements(*held->node, from, to);
  }
  const std::vector<Block> blocks = blocks_of(list);
  if (std::max(from, to) >= blocks.size()) refuse("\"" + to_text(list) + "\" is not that long");
  std::vector<Span> slots;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    refuse_scattered(blocks[i], joined(list, i));
    // Without the last line end, which the end of the file may lack.
    std::size_t end = blocks[i].end;
    while (end > blocks[i].begin && (text_[end - 1] == '\n' || text_[end - 1] == '\r')) --end;
    slots.push_back({blocks[i].begin, end});
  }
  permute(slots, from, to);
}

// Where every element has a line of its own, the remark behind it goes along.
void TomlSurgery::move_elements(const TomlNode& list, std::size_t from, std::size_t to) {
  std::vector<Span> slots, trails;
  bool own_lines = true;
  for (std::size_t i = 0; i < list.elements.size(); ++i) {
    slots.push_back(list.elements[i]);
    trails.push_back(trail_of(list, i));
    const std::size_t end = trails.back().end;
    own_lines =
        own_lines && begins_line(slots.back().begin) && (text_[end] == '\n' || text_[end] == '\r');
  }
  permute(slots, from, to);
  if (own_lines) permute(trails, from, to);
}

void TomlSurgery::permute(const std::vector<Span>& slots, std::size_t from, std::size_t to) {
  const std::vector<std::size_t> order = moved_order(slots.size(), from, to);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (order[i] != i) replace(slots[i], std::string(bytes(slots[order[i]])));
  }
}

}  // namespace promenade::study
