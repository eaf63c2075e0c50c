// What the paper printed of the study that this one repeats, beside this run.
#include <fmt/format.h>

#include "analysis/format.h"
#include "analysis/report/cells.h"
#include "analysis/report/report_sections.h"

namespace promenade::analysis {
namespace {

std::string answer(const std::optional<bool>& yes) {
  if (!yes) return dash;
  return *yes ? "yes" : "no";
}

std::string short_number(const std::optional<double>& value) {
  return value ? fmt::format("{:.4g}", *value) : dash;
}

// A run's words, or why there are none.
std::string words_of_run(const PublishedRow& row) {
  if (row.kind == "claim" && row.n > 0) return fmt::format("{}, n = {}", row.run_words, row.n);
  if (!row.run_words.empty()) return row.run_words;
  return row.note.empty() ? short_number(row.run) : row.note;
}

HtmlTable statements(const Published& published) {
  HtmlTable table;
  table.caption =
      "The design and the statements of the paper. Same: equal numbers; of statements and "
      "preferences the same direction, and significant at .05 in both or in neither.";
  table.columns = {"what", "in", "printed", "this run", "same"};
  for (const PublishedRow& row : published.rows) {
    if (row.kind == "test") continue;
    const std::string what = row.target.empty() ? row.what : row.what + ", " + row.target;
    table.rows.push_back({what, row.place,
                          row.printed_words.empty() ? short_number(row.printed) : row.printed_words,
                          words_of_run(row), answer(row.agrees)});
  }
  return table;
}

HtmlTable tests(const Published& published) {
  HtmlTable table;
  table.caption =
      "The printed p, and this run's by the same test: signed-rank, normal approximation without "
      "continuity correction; “all” takes each participant and target as a pair. Exact p beside "
      "it; of “all” with one value per participant. Same: significant at .05 in both or in "
      "neither. Bold: significant in this run.";
  table.columns = {"what",    "target", "printed p", "this run’s p",
                   "exact p", "n",      "smaller",   "same"};
  table.heads = 2;
  for (const PublishedRow& row : published.rows) {
    if (row.kind != "test") continue;
    table.rows.push_back({row.what, row.target, p_cell(row.printed), p_cell(row.run),
                          p_cell(row.p_exact), row.n > 0 ? std::to_string(row.n) : dash,
                          row.direction.empty() ? dash : row.direction, answer(row.agrees)});
    table.strong.push_back(row.run && *row.run < 0.05);
  }
  return table;
}

// "11 of 15 printed tests of single targets are significant, 9 of 15 of this run."
std::string how_many_tests(const Published& published, std::string_view measure) {
  int all = 0, printed = 0, run = 0, same = 0;
  for (const PublishedRow& row : published.rows) {
    if (row.kind != "test" || row.target == "all" || !row.what.starts_with(measure)) continue;
    ++all;
    printed += *row.printed < 0.05 ? 1 : 0;
    run += row.run && *row.run < 0.05 ? 1 : 0;
    same += row.agrees.value_or(false) ? 1 : 0;
  }
  if (all == 0) return "";
  return fmt::format(
      "{}: of {} tests of single targets {} are significant in print and {} in this run; {} have "
      "the same answer.",
      capitalised(std::string(measure)), all, printed, run, same);
}

std::string fate_words(const PublishedPair& pair) {
  if (!pair.cluster.empty()) return pair.cluster;
  return pair.fate == motion::PairFate::unrated ? dash : "dropped";
}

HtmlTable pair_table(const PublishedPairs& pairs) {
  HtmlTable table;
  table.caption =
      "All 41 pairs of adjectives: the printed cluster, and this run’s with the two numbers that "
      "decide: a pair is kept when μ*, the largest mean magnitude, is at least 1.0 and σ, the mean "
      "standard deviation, at most 0.85.";
  table.columns = {"pair", "printed", "this run", "μ*", "σ", "kept alike"};
  for (const PublishedPair& pair : pairs.pairs) {
    const bool kept = pair.fate == motion::PairFate::kept;
    table.rows.push_back({pair.name, pair.kept_in_print ? pair.cluster_in_print : "dropped",
                          fate_words(pair), number_cell(pair.extreme, 2),
                          number_cell(pair.sigma, 2),
                          pair.extreme ? answer(kept == pair.kept_in_print) : dash});
  }
  return table;
}

std::string pair_sentence(const PublishedPairs& pairs) {
  if (!pairs.problem.empty()) return "There are no ratings to compare: " + pairs.problem + ".";
  std::string sentence = fmt::format(
      "{} rated; {} pairs were kept, {} of them also in print, and {} were dropped in "
      "both.",
      count_of(pairs.raters, "person", "people"), pairs.kept, pairs.kept_in_both,
      pairs.dropped_in_both);
  if (pairs.adjusted_rand) {
    sentence += fmt::format(
        " The clusters of the pairs that both kept are alike to an adjusted Rand index of {}.",
        fixed(*pairs.adjusted_rand, 2));
  }
  return sentence;
}

Table row_table(const Published& published) {
  Table table{"published",
              "A printed number or statement of the study that this one repeats, and this run’s.",
              {"kind", "what", "target", "place", "printed", "printed_words", "run", "run_words",
               "n", "p_exact", "smaller", "same", "note"},
              {}};
  for (const PublishedRow& row : published.rows) {
    table.rows.push_back({cell(row.kind), cell(row.what), cell(row.target), cell(row.place),
                          cell(row.printed), cell(row.printed_words), cell(row.run),
                          cell(row.run_words), row.n > 0 ? cell(row.n) : Cell(), cell(row.p_exact),
                          cell(row.direction), row.agrees ? cell(*row.agrees) : Cell(),
                          cell(row.note)});
  }
  return table;
}

Table pair_rows(const PublishedPairs& pairs) {
  Table table{"published_pairs",
              "A pair of adjectives: whether it was kept, and its cluster, in print and in this "
              "run.",
              {"pair", "kept_in_print", "cluster_in_print", "kept", "cluster", "extreme", "sigma"},
              {}};
  for (const PublishedPair& pair : pairs.pairs) {
    table.rows.push_back({cell(pair.name), cell(pair.kept_in_print), cell(pair.cluster_in_print),
                          pair.extreme ? cell(pair.fate == motion::PairFate::kept) : Cell(),
                          cell(pair.cluster), cell(pair.extreme), cell(pair.sigma)});
  }
  return table;
}

nlohmann::json json_of(const Published& published, const std::vector<Table>& tables) {
  nlohmann::json json = {{"study", published.study->name},
                         {"title", published.study->title},
                         {"notes", published.study->notes},
                         {"rows", json_rows(tables[0])}};
  if (!published.pairs) return json;
  const PublishedPairs& pairs = *published.pairs;
  const auto index = pairs.adjusted_rand;
  json["pairs"] = json_rows(tables[1]);
  json["kept"] = pairs.kept;
  json["kept_in_both"] = pairs.kept_in_both;
  json["dropped_in_both"] = pairs.dropped_in_both;
  json["adjusted_rand"] = index ? nlohmann::json(*index) : nlohmann::json();
  return json;
}

}  // namespace

Section published_section(const Results& results) {
  const Published& published = results.published;
  if (!published.study) return {};
  Section section;
  section.title = "Printed / this run";
  section.html = element("p", std::string(published.study->title) + ".");
  section.html += wide_words(statements(published));
  for (const char* measure : {"D of the guess", "time"}) {
    const std::string sentence = how_many_tests(published, measure);
    if (!sentence.empty()) section.html += element("p", sentence);
  }
  section.html += wide(tests(published));
  section.tables = {row_table(published)};
  if (published.pairs) {
    section.html += element("p", pair_sentence(*published.pairs));
    section.html += folded(pair_table(*published.pairs));
    section.tables.push_back(pair_rows(*published.pairs));
  }
  for (const std::string_view sentence : published.study->notes) {
    section.html += note(std::string(sentence));
  }
  section.json["published"] = json_of(published, section.tables);
  return section;
}

}  // namespace promenade::analysis
