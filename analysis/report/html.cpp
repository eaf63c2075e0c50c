#include "analysis/report/html.h"

#include <cstdint>

namespace promenade::analysis {
namespace {

std::string escaped(std::string_view plain) {
  std::string result;
  result.reserve(plain.size());
  for (const char letter : plain) {
    switch (letter) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        // Control characters are not allowed in HTML at all.
        result += static_cast<unsigned char>(letter) < 0x20 && letter != '\n' ? ' ' : letter;
    }
  }
  return result;
}

std::string opening(std::string_view name, const Attributes& attributes) {
  std::string result = "<" + std::string(name);
  for (const auto& [key, value] : attributes) {
    result += " " + std::string(key) + "=\"" + escaped(value) + "\"";
  }
  return result;
}

Html row_of(const HtmlTable& table, std::size_t row) {
  // A heading that stands above already is not repeated.
  const bool same = row > 0 && table.heads > 1 && table.rows[row][0] == table.rows[row - 1][0];
  Html cells;
  for (std::size_t column = 0; column < table.rows[row].size(); ++column) {
    const bool head = static_cast<int>(column) < table.heads;
    const Attributes scope = head ? Attributes{{"scope", "row"}} : Attributes{};
    const bool quiet = column == 0 && same;
    cells += element(head ? "th" : "td", scope, text(quiet ? "" : table.rows[row][column]));
  }
  const bool strong = row < table.strong.size() && table.strong[row];
  const std::string look = std::string(strong ? "strong" : "") + (same ? "" : " group");
  return element("tr", {{"class", look}}, cells) + trusted("\n");
}

}  // namespace

Html text(std::string_view plain) { return {escaped(plain)}; }

Html trusted(std::string_view markup) { return {std::string(markup)}; }

Html element(std::string_view name, const Attributes& attributes, const Html& content) {
  return {opening(name, attributes) + ">" + content.code + "</" + std::string(name) + ">"};
}

Html element(std::string_view name, const Html& content) { return element(name, {}, content); }

Html element(std::string_view name, std::string_view plain) {
  return element(name, {}, text(plain));
}

Html empty_element(std::string_view name, const Attributes& attributes) {
  return {opening(name, attributes) + "/>"};
}

Html render(const HtmlTable& table) {
  Html head;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    const bool left = static_cast<int>(column) < table.heads;
    head += element("th", {{"scope", "col"}, {"class", left ? "left" : "right"}},
                    text(table.columns[column]));
  }
  Html body;
  for (std::size_t row = 0; row < table.rows.size(); ++row) body += row_of(table, row);
  return element("table", element("caption", table.caption) +
                              element("thead", element("tr", head)) + trusted("\n") +
                              element("tbody", body)) +
         trusted("\n");
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t block = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      block = block << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const bool filled = i + k <= bytes.size();
      result += filled ? letters[block >> (18 - 6 * k) & 63] : '=';
    }
  }
  return result;
}

}  // namespace promenade::analysis
