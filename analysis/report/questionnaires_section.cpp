// What people answered, instrument by instrument.
#include <fmt/format.h>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/cells.h"
#include "analysis/report/report_sections.h"

namespace promenade::analysis {
namespace {

constexpr const char* own_words = "(own words)";

std::string interface_name(const Dataset& data, int interface) {
  return interface < 0 ? "" : item(data.interfaces, interface);
}

std::vector<Cell> head_of(const QuestionnaireResult& one) {
  return {cell(one.instrument), cell(one.version), cell(one.asked)};
}

void add_row(const QuestionnaireResult& one, std::vector<Cell> cells, Table& table) {
  std::vector<Cell> row = head_of(one);
  row.insert(row.end(), cells.begin(), cells.end());
  table.rows.push_back(std::move(row));
}

Table scale_table(const Results& results) {
  Table table{"questionnaires",
              "Scores and scales of each instrument; one value per participant.",
              {"instrument", "version", "asked", "name", "kind", "interface", "n", "mean", "sd",
               "mean_ci_lower", "mean_ci_upper", "median", "median_ci_lower", "median_ci_upper"},
              {}};
  for (const QuestionnaireResult& one : results.questionnaires) {
    for (const ScaleResult& scale : one.scales) {
      const Moments& m = scale.moments;
      add_row(one,
              {cell(scale.name), cell(std::string(scale.is_score ? "score" : "item")),
               cell(interface_name(results.data, scale.interface)), cell(m.n), cell(m.mean),
               cell(m.sd), lower(m.mean_ci), upper(m.mean_ci), cell(scale.median),
               lower(scale.median_ci), upper(scale.median_ci)},
              table);
    }
  }
  return table;
}

Table pair_table(const Results& results) {
  Table table{
      "questionnaire_pairs",
      "Scores of each pair of interfaces (differences are a − b) by the signed-rank test.",
      {"instrument", "version", "asked", "name", "a", "b", "n", "n_missing", "n_zero", "W_plus",
       "W_minus", "p_exact_two", "p_holm", "rank_biserial", "hl", "hl_ci_lower", "hl_ci_upper"},
      {}};
  for (const QuestionnaireResult& one : results.questionnaires) {
    for (const ScalePair& pair : one.pairs) {
      const Comparison& c = pair.comparison;
      const auto ci = interval_of(c.hl_ci);
      add_row(one,
              {cell(pair.name), cell(item(results.data.interfaces, c.a)),
               cell(item(results.data.interfaces, c.b)), cell(c.test.n), cell(c.missing),
               cell(c.test.n_zero), Cell(c.test.w_plus), Cell(c.test.w_minus),
               c.test.exact ? Cell(c.test.exact->two) : Cell(), cell(c.p_holm),
               cell(c.test.rank_biserial), cell(c.hl), lower(ci), upper(ci)},
              table);
    }
  }
  return table;
}

Table alpha_table(const Results& results) {
  Table table{"questionnaire_alphas",
              "Cronbach's alpha of each score of two items or more, with Feldt's 95 % interval.",
              {"instrument", "version", "asked", "name", "interface", "n", "items", "alpha",
               "alpha_ci_lower", "alpha_ci_upper"},
              {}};
  for (const QuestionnaireResult& one : results.questionnaires) {
    for (const ScoreAlpha& of : one.alphas) {
      add_row(one,
              {cell(of.score), cell(interface_name(results.data, of.interface)), cell(of.alpha.n),
               cell(of.alpha.k), cell(of.alpha.alpha), lower(of.alpha.interval),
               upper(of.alpha.interval)},
              table);
    }
  }
  return table;
}

Table choice_table(const Results& results) {
  Table table{"questionnaire_choices",
              "How often each choice was made.",
              {"instrument", "version", "asked", "item", "interface", "choice", "count", "answers",
               "share"},
              {}};
  for (const QuestionnaireResult& one : results.questionnaires) {
    for (const ChoiceCount& choice : one.choices) {
      add_row(one,
              {cell(choice.item), cell(interface_name(results.data, choice.interface)),
               cell(choice.choice.empty() ? own_words : choice.choice), cell(choice.count),
               cell(choice.answers), Cell(static_cast<double>(choice.count) / choice.answers)},
              table);
    }
  }
  return table;
}

Table rank_table(const Results& results) {
  Table table{
      "questionnaire_rankings",
      "How often each choice stood at each place of a ranking, 1 the best.",
      {"instrument", "version", "asked", "item", "choice", "n", "mean_rank", "place", "count"},
      {}};
  for (const QuestionnaireResult& one : results.questionnaires) {
    for (const RankResult& rank : one.ranks) {
      for (int i = 0; i < size_of(rank.counts); ++i) {
        add_row(one,
                {cell(rank.item), cell(rank.choice), cell(rank.n), Cell(rank.mean_rank),
                 cell(i + 1), cell(item(rank.counts, i))},
                table);
      }
    }
  }
  return table;
}

std::string alpha_words(const QuestionnaireResult& one, const ScaleResult& scale) {
  for (const ScoreAlpha& of : one.alphas) {
    if (!scale.is_score || of.score != scale.name || of.interface != scale.interface) continue;
    if (!of.alpha.alpha) return dash;
    std::string words = fixed(*of.alpha.alpha, 2);
    if (of.alpha.interval) {
      words += " [" + fixed(of.alpha.interval->lower, 2) + ", " +
               fixed(of.alpha.interval->upper, 2) + "]";
    }
    return words;
  }
  return dash;
}

HtmlTable shown_scales(const Results& results, const QuestionnaireResult& one) {
  HtmlTable table;
  table.caption =
      "Scores (bold) and items, one value per participant. The interval of the mean is Student's, "
      "that of the median the sign test's, both 95 %; alpha is Cronbach's, with Feldt's interval.";
  table.columns = {"name",
                   "interface",
                   "n",
                   "mean",
                   "SD",
                   "CI of the mean",
                   "median",
                   "CI of the median",
                   "alpha [95 % CI]"};
  table.heads = 2;
  for (const ScaleResult& scale : one.scales) {
    const Moments& m = scale.moments;
    table.rows.push_back({scale.name, interface_name(results.data, scale.interface),
                          std::to_string(m.n), number_cell(m.mean, 2), number_cell(m.sd, 2),
                          range_cell(m.mean_ci, 2), number_cell(scale.median, 2),
                          range_cell(scale.median_ci, 2), alpha_words(one, scale)});
    table.strong.push_back(scale.is_score);
  }
  return table;
}

HtmlTable shown_pairs(const Results& results, const QuestionnaireResult& one) {
  HtmlTable table;
  table.caption =
      "Pairs of interfaces by the signed-rank test; differences by Hodges-Lehmann with 95 % "
      "interval. Bold: adjusted p < .05.";
  table.columns = {"name", "a − b", "n", "difference [95 % CI]", "exact p", "Holm p", "r"};
  table.heads = 2;
  for (const ScalePair& pair : one.pairs) {
    const Comparison& c = pair.comparison;
    std::string difference = number_cell(c.hl, 2);
    if (c.hl_ci) {
      difference +=
          " [" + fixed(c.hl_ci->interval.lower, 2) + ", " + fixed(c.hl_ci->interval.upper, 2) + "]";
    }
    table.rows.push_back(
        {pair.name, item(results.data.interfaces, c.a) + " − " + item(results.data.interfaces, c.b),
         std::to_string(c.test.n), difference, p_cell(c.p), p_cell(c.p_holm),
         number_cell(c.test.rank_biserial, 2)});
    table.strong.push_back(c.p_holm.value_or(1) < 0.05);
  }
  return table;
}

HtmlTable shown_choices(const Results& results, const QuestionnaireResult& one) {
  HtmlTable table;
  table.caption =
      "Choices: how often each was made, of those who answered. Choices between pairs, which weigh "
      "a "
      "score, stand in tables/questionnaire_choices.csv alone.";
  table.columns = {"item", "interface", "choice", "count", "answers", "share"};
  table.heads = 3;
  for (const ChoiceCount& choice : one.choices) {
    if (choice.is_pair) continue;
    table.rows.push_back({choice.item, interface_name(results.data, choice.interface),
                          choice.choice.empty() ? own_words : choice.choice,
                          std::to_string(choice.count), std::to_string(choice.answers),
                          percent_of(choice.count, choice.answers)});
  }
  return table;
}

HtmlTable shown_ranks(const QuestionnaireResult& one) {
  HtmlTable table;
  table.caption = "Rankings: mean rank (1 is the best) and how often each place.";
  table.columns = {"item", "choice", "n", "mean rank"};
  table.heads = 2;
  std::size_t places = 0;
  for (const RankResult& rank : one.ranks) places = std::max(places, rank.counts.size());
  for (std::size_t i = 1; i <= places; ++i) table.columns.push_back(fmt::format("place {}", i));
  for (const RankResult& rank : one.ranks) {
    std::vector<std::string> row = {rank.item, rank.choice, std::to_string(rank.n),
                                    fixed(rank.mean_rank, 2)};
    for (const int count : rank.counts) row.push_back(std::to_string(count));
    row.resize(places + 4, dash);
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string moment_words(const std::string& asked) {
  if (asked == "start") return "at the start";
  if (asked == "end") return "at the end";
  return asked.empty() ? "at some time" : "after each " + asked;
}

std::string facts_on(const QuestionnaireResult& one) {
  std::string words =
      fmt::format("Asked {}; {} filled it in, {}.", moment_words(one.asked),
                  count_of(one.people, "person", "people"), count_of(one.pages, "page", "pages"));
  if (one.declined > 0) {
    words += fmt::format(" {} declined.", count_of(one.declined, "answer was", "answers were"));
  }
  if (!one.is_known) {
    words +=
        " Its file is not in the database or cannot be read by this version, so that nothing can "
        "be computed.";
  }
  if (!one.citation.empty()) words += " " + one.citation + ".";
  return words;
}

Html texts_on(const QuestionnaireResult& one) {
  int texts = 0;
  for (const TextCount& count : one.texts) texts += count.texts;
  if (texts == 0) return {};
  return element("p", count_of(texts, "free answer is", "free answers are") +
                          " not printed, for they may tell who somebody is: they are in table "
                          "answer of the database, and in an export.");
}

Html part_on(const Results& results, const QuestionnaireResult& one) {
  return element("h3",
                 one.instrument + ", version " + one.version + ", " + moment_words(one.asked)) +
         element("p", facts_on(one)) + wide(shown_scales(results, one)) +
         wide(shown_pairs(results, one)) + wide(shown_choices(results, one)) +
         wide(shown_ranks(one)) + texts_on(one);
}

nlohmann::json instruments_json(const Results& results) {
  nlohmann::json list = nlohmann::json::array();
  for (const QuestionnaireResult& one : results.questionnaires) {
    nlohmann::json texts = nlohmann::json::object();
    for (const TextCount& count : one.texts) texts[count.item] = count.texts;
    list.push_back({{"instrument", one.instrument},
                    {"version", one.version},
                    {"asked", one.asked},
                    {"citation", one.citation},
                    {"people", one.people},
                    {"pages", one.pages},
                    {"declined", one.declined},
                    {"free_answers", texts}});
  }
  return list;
}

}  // namespace

Section questionnaires_section(const Results& results) {
  Section section;
  if (results.questionnaires.empty()) return section;
  section.title = "Questionnaires";
  for (const QuestionnaireResult& one : results.questionnaires) {
    section.html += part_on(results, one);
  }
  nlohmann::json& json = section.json["questionnaires"];
  json["instruments"] = instruments_json(results);
  for (const auto& [key, table] : {std::pair{"scales", scale_table(results)},
                                   {"pairs", pair_table(results)},
                                   {"alphas", alpha_table(results)},
                                   {"choices", choice_table(results)},
                                   {"rankings", rank_table(results)}}) {
    json[key] = json_rows(table);
    if (!table.rows.empty()) section.tables.push_back(table);
  }
  return section;
}

}  // namespace promenade::analysis
