// [[blocks]] and [sections] as a whole.
#include "study/toml_surgery.h"

namespace promenade::study {

using Kind = TomlStatement::Kind;

// The first of the remarks that touch a header from above; the header itself where there are none.
std::size_t TomlSurgery::remarks_before(std::size_t header) const {
  while (header > 0 && spans_[header - 1].kind == Kind::remark) --header;
  return header;
}

std::optional<TomlSurgery::Block> TomlSurgery::block_of(const TomlPath& path) const {
  std::size_t header = 0;
  while (header < spans_.size() && !(spans_[header].is_header() && spans_[header].path == path)) {
    ++header;
  }
  if (header == spans_.size()) return std::nullopt;
  std::size_t next = header + 1, last = header;
  for (; next < spans_.size(); ++next) {
    if (spans_[next].is_header() && !begins_with(spans_[next].path, path)) break;
    if (spans_[next].has_content() || spans_[next].kind == Kind::broken) last = next;
  }
  // Remarks that touch its last line are its own, unless they touch what follows as well.
  std::size_t end = last + 1;
  while (end < next && spans_[end].kind == Kind::remark) ++end;
  if (end == next && next < spans_.size()) end = last + 1;
  Block block;
  block.first = remarks_before(header);
  block.last = end;
  block.begin = spans_[block.first].begin;
  block.end = spans_[end - 1].end;
  return block;
}

std::vector<TomlSurgery::Block> TomlSurgery::blocks_of(const TomlPath& list) const {
  std::vector<Block> blocks;
  while (const auto block = block_of(joined(list, blocks.size()))) blocks.push_back(*block);
  return blocks;
}

void TomlSurgery::refuse_scattered(const Block& block, const TomlPath& path) const {
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    if (i >= block.first && i < block.last) continue;
    if (!spans_[i].has_content() || !begins_with(spans_[i].path, path)) continue;
    refuse("the parts of \"" + to_text(path) + "\" stand in several places of the file");
  }
}

void TomlSurgery::insert_block(const TomlPath& list, const std::vector<Block>& blocks,
                               std::size_t at, const TomlValue& value) {
  std::string lines;
  for (const TomlValue::Entry& entry : value.entries) {
    lines += written_key(entry.key) + " = " + written(entry.value, nullptr) + line_end_;
  }
  const std::string header = header_of(list, true);
  if (blocks.empty()) return add_section(header, lines);
  if (at < blocks.size()) {
    return put(blocks[at].begin, header + line_end_ + lines + line_end_);
  }
  const std::size_t end = blocks.back().end;
  const bool whole_line = text_[end - 1] == '\n';
  const bool gap =
      blocks.back().last == spans_.size() || spans_[blocks.back().last].kind == Kind::blank;
  put(end, (whole_line ? "" : line_end_) + line_end_ + header + line_end_ + lines +
               (gap ? "" : line_end_));
}

// With the empty lines behind it; at the end of the file with those before it.
void TomlSurgery::remove_block(const Block& block) {
  std::size_t first = block.first, last = block.last;
  while (last < spans_.size() && spans_[last].kind == Kind::blank) ++last;
  if (last == spans_.size()) {
    while (first > 0 && spans_[first - 1].kind == Kind::blank) --first;
  }
  erase({spans_[first].begin, spans_[last - 1].end});
}

}  // namespace promenade::study
