#include "analysis/export/export_codebook.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "analysis/item.h"
#include "analysis/report/html.h"
#include "analysis/report/page_parts.h"
#include "study/csv.h"

namespace promenade::analysis {
namespace {

using Json = nlohmann::ordered_json;
using Row = std::vector<std::string>;

std::string in_all_languages(const study::LocalText& text) {
  if (text.size() == 1) return text.begin()->second;
  std::string all;
  for (const auto& [language, words] : text) {
    all += (all.empty() ? "" : "; ") + language + ": " + words;
  }
  return all;
}

std::string choices_of(const study::Item& item) {
  std::string all;
  for (int i = 0; i < size_of(item.choices); ++i) {
    const study::Choice& choice = analysis::item(item.choices, i);
    all += (all.empty() ? "" : " | ") + std::to_string(i + 1) + " = " + choice.name;
    const std::string words = in_all_languages(choice.text);
    if (!words.empty() && words != choice.name) all += " (" + words + ")";
  }
  return all;
}

std::string kind_of(const study::Item& item) { return std::string(study::to_text(item.kind)); }

bool has_range(const study::Item& item) {
  return item.kind == study::ItemKind::scale || item.kind == study::ItemKind::number;
}

const Row item_columns = {"instrument", "version", "item", "kind",    "question", "low",
                          "high",       "least",   "most", "choices", "citation", "terms"};

Row item_row(const study::Instrument& instrument, const study::Item& item) {
  return {instrument.name,
          instrument.version,
          item.name,
          kind_of(item),
          in_all_languages(item.question),
          in_all_languages(item.low),
          in_all_languages(item.high),
          has_range(item) ? study::csv_number(item.least) : "",
          has_range(item) ? study::csv_number(item.most) : "",
          choices_of(item),
          instrument.citation,
          instrument.terms};
}

std::string formula_of(const study::Score& score) {
  std::string items;
  for (const study::ScoreItem& one : score.items) {
    items += (items.empty() ? "" : ", ") + one.item + (one.reversed ? " (reversed)" : "") +
             (one.weight.empty() ? "" : " (weight: times " + one.weight + " was chosen)");
  }
  return (score.mean ? "mean of " : "sum of ") + items;
}

Row score_row(const study::Instrument& instrument, const study::Score& score) {
  const study::ValueRange range = study::score_range(instrument, score);
  return {instrument.name,
          instrument.version,
          score.name,
          "score",
          formula_of(score),
          "",
          "",
          study::csv_number(range.least),
          study::csv_number(range.most),
          "",
          instrument.citation,
          instrument.terms};
}

std::vector<Row> rows_of(const study::Instrument& instrument) {
  std::vector<Row> rows;
  for (const study::Item& item : instrument.items) rows.push_back(item_row(instrument, item));
  for (const study::Score& score : instrument.scores) rows.push_back(score_row(instrument, score));
  return rows;
}

// Text between empty cells, so that all rows of the codebook are equally long.
Row padded(std::size_t before, const Row& row, std::size_t after) {
  Row all(before);
  all.insert(all.end(), row.begin(), row.end());
  all.resize(all.size() + after);
  return all;
}

Html file_section(const std::string& file, const std::vector<ExportColumn>& columns) {
  HtmlTable table{file, {"column", "unit", "meaning"}, {}, {}, 1};
  for (const ExportColumn& column : columns) {
    if (column.file == file) table.rows.push_back({column.column, column.unit, column.meaning});
  }
  return element("h2", file) + render(table);
}

Html instrument_section(const study::Instrument& instrument) {
  HtmlTable table{in_all_languages(instrument.title),
                  {"item", "kind", "question", "low", "high", "least", "most", "choices"},
                  {},
                  {},
                  1};
  for (const Row& row : rows_of(instrument)) {
    table.rows.emplace_back(row.begin() + 2, row.begin() + 10);
  }
  Html section = element("h2", instrument.name + ", version " + instrument.version) + render(table);
  if (!instrument.citation.empty()) section += element("p", instrument.citation);
  if (!instrument.terms.empty()) section += element("p", instrument.terms);
  return section;
}

std::vector<std::string> files_of(const std::vector<ExportColumn>& columns) {
  std::vector<std::string> files;
  for (const ExportColumn& column : columns) {
    if (std::find(files.begin(), files.end(), column.file) == files.end()) {
      files.push_back(column.file);
    }
  }
  return files;
}

// A name may mean something else in each file.
struct Variable {
  std::string name, unit, description;
  bool one_unit = true;
};

std::vector<Variable> variables_of(const std::vector<ExportColumn>& columns) {
  std::vector<Variable> variables;
  for (const ExportColumn& column : columns) {
    if (column.file.rfind("data/", 0) != 0) continue;
    const std::string meaning = column.meaning + " (" + column.file.substr(5) + ")";
    const auto found = std::find_if(variables.begin(), variables.end(),
                                    [&](const Variable& v) { return v.name == column.column; });
    if (found == variables.end()) {
      variables.push_back({column.column, column.unit, meaning, true});
      continue;
    }
    found->description += "; " + meaning;
    found->one_unit = found->one_unit && found->unit == column.unit;
  }
  return variables;
}

Json property_of(const Variable& variable) {
  Json property = {
      {"@type", "PropertyValue"}, {"name", variable.name}, {"description", variable.description}};
  if (variable.one_unit && !variable.unit.empty()) property["unitText"] = variable.unit;
  return property;
}

}  // namespace

std::string codebook_csv(const std::vector<ExportColumn>& columns,
                         const std::vector<study::Instrument>& instruments) {
  Row head = {"file", "column", "unit", "meaning"};
  head.insert(head.end(), item_columns.begin(), item_columns.end());
  std::string csv = study::csv_line(head);
  for (const ExportColumn& one : columns) {
    csv += study::csv_line(
        padded(0, {one.file, one.column, one.unit, one.meaning}, item_columns.size()));
  }
  for (const study::Instrument& instrument : instruments) {
    for (const Row& row : rows_of(instrument)) csv += study::csv_line(padded(4, row, 0));
  }
  return csv;
}

std::string codebook_html(const std::string& title, const std::vector<ExportColumn>& columns,
                          const std::vector<study::Instrument>& instruments) {
  const Html head = trusted("<meta charset=\"utf-8\"/>\n") + element("title", title) +
                    element("style", trusted(page_css()));
  Html body = element("h1", title);
  for (const std::string& file : files_of(columns)) body += file_section(file, columns);
  for (const study::Instrument& instrument : instruments) body += instrument_section(instrument);
  return "<!DOCTYPE html>\n" +
         element("html", {{"lang", "en"}},
                 element("head", head) + element("body", element("main", body)))
             .code +
         "\n";
}

std::string dataset_description(const std::string& name, const std::string& description,
                                const std::string& version,
                                const std::vector<ExportColumn>& columns) {
  Json variables = Json::array();
  for (const Variable& variable : variables_of(columns)) variables.push_back(property_of(variable));
  const Json document = {
      {"@context", "https://schema.org"}, {"@type", "Dataset"}, {"name", name},
      {"description", description},       {"version", version}, {"variableMeasured", variables}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace promenade::analysis
