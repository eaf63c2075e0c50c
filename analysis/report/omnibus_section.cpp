// Friedman's test of all interfaces at once, and the pairs behind it by mean ranks.
#include <fmt/format.h>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/cells.h"
#include "analysis/report/report_sections.h"
#include "analysis/report/sentences.h"
#include "analysis/statistics/row_permutations.h"

namespace promenade::analysis {
namespace {

std::string ranks_in_words(const Dataset& data, const OmnibusTest& one) {
  std::string words;
  for (int i = 0; i < size_of(one.interfaces); ++i) {
    words += (i > 0 ? ", " : "") + item(data.interfaces, item(one.interfaces, i)) + " " +
             fixed(item(one.test->mean_ranks, i), 2);
  }
  return words;
}

HtmlTable test_table(const Results& results, int task) {
  const Dataset& data = results.data;
  HtmlTable table;
  table.caption =
      of_task(data, task) +
      "Friedman’s test with one value per participant (the mean over targets), of those who have "
      "a value for every interface. Rank 1 is the lowest value. Bold: p < .05 (exact, else F).";
  table.columns = {"measure", "n",    "left out", "mean ranks", "χ²",
                   "df",      "χ² p", "F p",      "exact p",    "W"};
  for (const OmnibusTest& one : results.omnibus) {
    if (one.task != task) continue;
    std::vector<std::string> row = {item(data.measures, one.measure).label, std::to_string(one.n),
                                    std::to_string(one.incomplete)};
    if (one.test && one.n > 1) {
      const FriedmanTest& test = *one.test;
      for (const std::string& cell :
           {ranks_in_words(data, one), number_cell(test.chi2, 2), std::to_string(test.k - 1),
            p_cell(test.p), p_cell(test.p_f), test.chi2 ? p_cell(test.p_exact) : dash,
            number_cell(test.kendall_w, 2)}) {
        row.push_back(cell);
      }
    } else {
      row.resize(table.columns.size(), dash);
    }
    table.rows.push_back(std::move(row));
    table.strong.push_back(one.n > 1 && omnibus_p(one).value_or(1) < significance);
  }
  return table;
}

HtmlTable pair_table(const Results& results, int task) {
  const Dataset& data = results.data;
  HtmlTable table;
  table.caption = of_task(data, task) +
                  "Pairs after Friedman’s test, by the difference of their mean ranks, where the "
                  "test above has p < .05.";
  table.columns = {"measure", "pair", "z", "normal p", "Holm p", "Nemenyi p"};
  table.heads = 2;
  for (const OmnibusTest& one : results.omnibus) {
    if (one.task != task || one.n < 2 || omnibus_p(one).value_or(1) >= significance) continue;
    for (const RankPair& pair : one.test->pairs) {
      table.rows.push_back(
          {item(data.measures, one.measure).label,
           pair_name(data, item(one.interfaces, pair.a), item(one.interfaces, pair.b)),
           fixed(pair.z, 2), p_cell(pair.p_normal), p_cell(pair.p_holm), p_cell(pair.p_nemenyi)});
      table.strong.push_back(pair.p_holm < significance);
    }
  }
  return table;
}

Table test_rows(const Results& results) {
  const Dataset& data = results.data;
  Table table{"friedman",
              "All interfaces at once by Friedman's test; one value per participant.",
              {"measure", "task", "n", "n_incomplete", "k", "chi2", "df", "p_chi2", "f", "p_f",
               "p_exact", "kendall_w"},
              {}};
  for (const OmnibusTest& one : results.omnibus) {
    std::vector<Cell> row = {cell(item(data.measures, one.measure).name),
                             cell(item(data.tasks, one.task).name), cell(one.n),
                             cell(one.incomplete), cell(size_of(one.interfaces))};
    if (one.test && one.test->chi2) {
      const FriedmanTest& test = *one.test;
      row.insert(row.end(), {cell(test.chi2), cell(test.k - 1), cell(test.p), cell(test.f),
                             cell(test.p_f), cell(test.p_exact), cell(test.kendall_w)});
    }
    row.resize(table.columns.size());
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table rank_rows(const Results& results) {
  const Dataset& data = results.data;
  Table table{"friedman_ranks",
              "The mean rank of each interface in Friedman's test.",
              {"measure", "task", "interface", "mean_rank"},
              {}};
  for (const OmnibusTest& one : results.omnibus) {
    for (int i = 0; one.test && i < size_of(one.interfaces); ++i) {
      table.rows.push_back({cell(item(data.measures, one.measure).name),
                            cell(item(data.tasks, one.task).name),
                            cell(item(data.interfaces, item(one.interfaces, i))),
                            cell(item(one.test->mean_ranks, i))});
    }
  }
  return table;
}

Table pair_rows(const Results& results) {
  const Dataset& data = results.data;
  Table table{"friedman_pairs",
              "Every pair of interfaces by the mean ranks of Friedman's test.",
              {"measure", "task", "a", "b", "z", "p_normal", "p_holm", "p_nemenyi"},
              {}};
  for (const OmnibusTest& one : results.omnibus) {
    if (!one.test || !one.test->chi2) continue;
    for (const RankPair& pair : one.test->pairs) {
      table.rows.push_back({cell(item(data.measures, one.measure).name),
                            cell(item(data.tasks, one.task).name),
                            cell(item(data.interfaces, item(one.interfaces, pair.a))),
                            cell(item(data.interfaces, item(one.interfaces, pair.b))), cell(pair.z),
                            cell(pair.p_normal), cell(pair.p_holm), cell(pair.p_nemenyi)});
    }
  }
  return table;
}

}  // namespace

Section omnibus_section(const Results& results) {
  if (results.omnibus.empty()) return {};
  Section section;
  section.title = "All interfaces at once";
  for (int task = 0; task < size_of(results.data.tasks); ++task) {
    section.html += wide(test_table(results, task)) + folded(pair_table(results, task));
  }
  section.html += note(fmt::format(
      "χ² is corrected for ties; F is that of Iman and Davenport; W is Kendall’s. The exact p "
      "counts all orders within the participants; that is done for three interfaces and up to {} "
      "participants, since beyond there are too many. A dash: all have the same values, or only "
      "one participant has all of them. Holm’s family after the test: all pairs of one measure.",
      row_permutations_subjects));
  section.tables = {test_rows(results), rank_rows(results), pair_rows(results)};
  for (const Table& table : section.tables) section.json[table.name] = json_rows(table);
  return section;
}

}  // namespace promenade::analysis
