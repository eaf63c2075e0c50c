// The bytes of a TOML edit: where the text is cut, and what is put in. Inside study/ only;
// edited_toml (study/toml_edit.h) compares what comes out.
#pragma once

#include "study/toml_edit.h"
#include "study/toml_spans.h"

namespace promenade::study {

class TomlSurgery {
 public:
  // Both outlive it.
  TomlSurgery(const std::string& file, const std::string& text);

  // Throws InputError.
  std::string edited(const TomlEdit& edit);
  // Is the list written as [[blocks]]?
  bool has_blocks(const TomlPath& list) const { return !blocks_of(list).empty(); }

 private:
  struct Change : Span {
    std::string text;
  };

  [[noreturn]] void refuse(const std::string& sentence) const;
  void replace(Span span, std::string text) { changes_.push_back({span, std::move(text)}); }
  void put(std::size_t at, std::string text) { replace({at, at}, std::move(text)); }
  void erase(Span span) { replace(span, ""); }
  std::string with_changes() const;
  std::string written(const TomlValue& value, const TomlHeld* before) const;
  std::string_view bytes(Span span) const {
    return std::string_view(text_).substr(span.begin, span.end - span.begin);
  }

  void set(const TomlPath& path, const TomlValue& value);
  void add(const TomlPath& table, const std::string& key, const TomlValue& value);
  bool add_below_header(const TomlPath& table, const std::string& line);
  bool add_dotted(const TomlPath& table, const std::string& key, const TomlValue& value);
  bool add_above_header(const TomlPath& table, const std::string& line);
  void add_section(const std::string& header, const std::string& lines);
  void put_line(std::size_t at, const std::string& line);
  void put_in_table(const TomlNode& node, const std::string& entry);

  void remove(const TomlPath& path);
  void remove_entry(const TomlNode& table, std::size_t place);
  void remove_parts(const TomlPath& path);

  // study/toml_surgery_lists.cpp
  void insert(const TomlPath& list, std::size_t at, const TomlValue& value);
  void insert_element(const TomlNode& list, std::size_t at, const std::string& value);
  void append_element(const TomlNode& list, const std::string& value);
  void remove_element(const TomlNode& list, std::size_t place);
  void move(const TomlPath& list, std::size_t from, std::size_t to);
  void move_elements(const TomlNode& list, std::size_t from, std::size_t to);
  void permute(const std::vector<Span>& slots, std::size_t from, std::size_t to);
  bool begins_line(std::size_t at) const;
  Span trail_of(const TomlNode& list, std::size_t place) const;

  // study/toml_surgery_blocks.cpp: a header, the lines below it, its sub-tables, and the remarks
  // that touch it.
  struct Block : Span {
    std::size_t first = 0, last = 0;  // statements; last: behind it
  };
  std::vector<Block> blocks_of(const TomlPath& list) const;
  std::optional<Block> block_of(const TomlPath& path) const;
  std::size_t remarks_before(std::size_t header) const;
  void insert_block(const TomlPath& list, const std::vector<Block>& blocks, std::size_t at,
                    const TomlValue& value);
  void remove_block(const Block& block);
  void refuse_scattered(const Block& block, const TomlPath& path) const;
  std::string header_of(const TomlPath& path, bool array) const;

  const std::string& file_;
  const std::string& text_;
  TomlSpans spans_;
  std::string line_end_;
  std::vector<Change> changes_;
};

}  // namespace promenade::study
