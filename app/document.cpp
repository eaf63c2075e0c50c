#include "app/document.h"

#include "analysis/prereg/sealed_plan.h"
#include "analysis/report/html.h"

namespace promenade::app {
namespace {

using analysis::element;
using analysis::Html;
using analysis::text;
using analysis::trusted;

constexpr std::string_view css =
    "body{font:16px/1.5 sans-serif;max-width:50em;margin:2em auto;padding:0 1em;color:#222}"
    "table{border-collapse:collapse;width:100%;margin:1em 0}"
    "pre{background:#f4f4f4;padding:1em;white-space:pre-wrap;overflow-wrap:anywhere}"
    "td,th{border-bottom:1px solid #ccc;padding:.3em .6em;text-align:left;vertical-align:top}";

std::vector<std::string> paragraphs_of(std::string_view text) {
  std::vector<std::string> paragraphs;
  while (!text.empty()) {
    const std::size_t end = text.find("\n\n");
    if (end != 0) paragraphs.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 2);
  }
  return paragraphs;
}

Html row_of(std::string_view cell, const Cells& cells) {
  Html row;
  for (const std::string& one : cells) row += element(cell, one);
  return element("tr", row) + trusted("\n");
}

// These are markup anywhere; a list, a heading or a quotation only begins with its first word, as
// "-", "##" or "12.".
bool is_markup(std::string_view text, std::size_t at) {
  if (std::string_view("\\`*_[]|~").find(text[at]) != std::string_view::npos) return true;
  if (std::string_view("#+-.)>=!").find(text[at]) == std::string_view::npos) return false;
  return text.substr(0, at).find_first_not_of("0123456789#+->=! ") == std::string_view::npos;
}

// On one line, and no letter of it markup.
std::string plain(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char letter = text[at];
    if (letter == '<') {
      result += "&lt;";
    } else if (letter == '&') {
      result += "&amp;";
    } else if (static_cast<unsigned char>(letter) < 0x20) {
      result += ' ';
    } else {
      if (is_markup(text, at)) result += '\\';
      result += letter;
    }
  }
  return result;
}

std::string row_text(const Cells& cells) {
  std::string row = "|";
  for (const std::string& cell : cells) row += " " + plain(cell) + " |";
  return row + "\n";
}

}  // namespace

void HtmlDocument::heading(int level, std::string_view words) {
  body_ += element("h" + std::to_string(level), words).code + "\n";
}

void HtmlDocument::paragraph(std::string_view words) {
  for (const std::string& one : paragraphs_of(words)) body_ += element("p", one).code + "\n";
}

void HtmlDocument::list(const std::vector<std::string>& points) {
  Html items;
  for (const std::string& point : points) items += element("li", point) + trusted("\n");
  body_ += element("ul", items).code + "\n";
}

void HtmlDocument::table(const Cells& columns, const std::vector<Cells>& rows) {
  Html lines = row_of("th", columns);
  for (const Cells& row : rows) lines += row_of("td", row);
  body_ += element("table", lines).code + "\n";
}

void HtmlDocument::verbatim(std::string_view words) { body_ += element("pre", words).code + "\n"; }

std::string HtmlDocument::take(const std::string& title) {
  const Html head = trusted("<meta charset=\"utf-8\">\n") + element("title", title) +
                    element("style", trusted(css));
  return "<!DOCTYPE html>\n" +
         element("html", {{"lang", "en"}},
                 element("head", head) + element("body", trusted("\n") + trusted(body_)))
             .code +
         "\n";
}

void MarkdownDocument::heading(int level, std::string_view words) {
  body_ += std::string(static_cast<std::size_t>(level), '#') + " " + plain(words) + "\n\n";
}

void MarkdownDocument::paragraph(std::string_view words) {
  for (const std::string& one : paragraphs_of(words)) body_ += plain(one) + "\n\n";
}

void MarkdownDocument::list(const std::vector<std::string>& points) {
  for (const std::string& point : points) body_ += "- " + plain(point) + "\n";
  body_ += "\n";
}

void MarkdownDocument::table(const Cells& columns, const std::vector<Cells>& rows) {
  body_ += row_text(columns) + "|";
  for (std::size_t i = 0; i < columns.size(); ++i) body_ += " --- |";
  body_ += "\n";
  for (const Cells& row : rows) body_ += row_text(row);
  body_ += "\n";
}

void MarkdownDocument::verbatim(std::string_view words) {
  const std::string fence = analysis::fence_for(words);
  const bool ends = !words.empty() && words.back() == '\n';
  body_ += fence + "\n" + std::string(words) + (ends ? "" : "\n") + fence + "\n\n";
}

std::string MarkdownDocument::take(const std::string&) { return body_; }

}  // namespace promenade::app
