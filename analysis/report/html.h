// HTML put together from small pieces. Text becomes Html by escaping only, so a
// code or a name that a person chose can never become markup.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace promenade::analysis {

struct Html {
  std::string code;
  Html& operator+=(const Html& more) {
    code += more.code;
    return *this;
  }
  friend Html operator+(Html a, const Html& b) { return a += b; }
};

using Attributes = std::vector<std::pair<std::string_view, std::string>>;

Html text(std::string_view plain);
Html trusted(std::string_view markup);  // our own constants
Html element(std::string_view name, const Attributes& attributes, const Html& content);
Html element(std::string_view name, const Html& content);
Html element(std::string_view name, std::string_view plain);
Html empty_element(std::string_view name, const Attributes& attributes);  // <img ...>, SVG shapes

// Rows of escaped text; the first `heads` columns are row headings. Where there are
// several, rows with the same first one make a group.
struct HtmlTable {
  std::string caption;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  std::vector<bool> strong;  // rows that stand out; empty: none
  int heads = 1;
};
Html render(const HtmlTable& table);

std::string base64(std::string_view bytes);

}  // namespace promenade::analysis
