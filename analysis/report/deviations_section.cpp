// What went another way than planned.
#include <fmt/format.h>

#include <map>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/cells.h"
#include "analysis/report/report_sections.h"

namespace promenade::analysis {
namespace {

// As in tables/deviations.csv, and as people read it.
struct KindWords {
  const char* name;
  const char* one;
  const char* many;
};

KindWords words_of(DeviationKind kind) {
  switch (kind) {
    case DeviationKind::missing_trials:
      return {"missing_trials", "trial missing", "trials missing"};
    case DeviationKind::skipped:
      return {"skipped", "trial skipped by the experimenter", "trials skipped by the experimenter"};
    case DeviationKind::not_ended:
      return {"not_ended", "trial aborted or cut off", "trials aborted or cut off"};
    case DeviationKind::repeated_trials:
      return {"repeated_trials", "trial done again", "trials done again"};
    case DeviationKind::repeat:
      return {"repeat", "repetition begun by the experimenter",
              "repetitions begun by the experimenter"};
    case DeviationKind::resumed:
      return {"resumed", "interruption, after which the session went on",
              "interruptions, after which the session went on"};
    case DeviationKind::order_repeated:
      return {"order_repeated", "other person with the same order",
              "other people with the same order"};
    case DeviationKind::order_unused:
      return {"order_unused", "order that nobody analysed has", "orders that nobody analysed has"};
  }
  return {"", "", ""};
}

std::string with_number(const Deviation& one) {
  const KindWords words = words_of(one.kind);
  return count_of(one.count, words.one, words.many);
}

std::string what_of(const Deviation& one) {
  const bool order =
      one.kind == DeviationKind::order_repeated || one.kind == DeviationKind::order_unused;
  return order ? "order " + one.what : one.what;
}

Table deviation_table(const Results& results) {
  Table table{"deviations",
              "Where sessions of those analysed went another way than planned.",
              {"participant", "kind", "count", "what", "reason"},
              {}};
  for (const Deviation& one : results.deviations) {
    table.rows.push_back({one.person.empty() ? Cell() : cell(one.person),
                          cell(std::string(words_of(one.kind).name)), cell(one.count),
                          cell(one.what), cell(one.reason)});
  }
  return table;
}

HtmlTable shown_table(const Results& results) {
  HtmlTable table;
  table.caption = "Person by person, with the reasons that the experimenter gave.";
  table.columns = {"person", "what happened", "where", "reason"};
  for (const Deviation& one : results.deviations) {
    table.rows.push_back({one.person.empty() ? "nobody" : one.person, with_number(one),
                          what_of(one), one.reason.empty() ? dash : one.reason});
  }
  return table;
}

std::map<DeviationKind, int> totals_of(const Results& results) {
  std::map<DeviationKind, int> totals;
  for (const Deviation& one : results.deviations) totals[one.kind] += one.count;
  return totals;
}

Html summary(const Results& results) {
  if (results.deviations.empty()) {
    return element("p",
                   "None is known: every person analysed has all trials, none was skipped, cut off "
                   "or done again, no session was interrupted, and each order was used once.");
  }
  Html list;
  for (const auto& [kind, count] : totals_of(results)) {
    list += element("li", count_of(count, words_of(kind).one, words_of(kind).many));
  }
  return element("ul", list);
}

std::string note_sentence(int notes) {
  return count_of(notes, "note", "notes") +
         " of experimenters may say more; they may name people and stand in an export only.";
}

}  // namespace

Section deviations_section(const Results& results) {
  Section section;
  section.title = "Deviations from the plan";
  section.html = summary(results) + wide_words(shown_table(results));
  if (results.log.notes > 0) section.html += element("p", note_sentence(results.log.notes));
  const Table table = deviation_table(results);
  nlohmann::json totals = nlohmann::json::object();
  for (const auto& [kind, count] : totals_of(results)) totals[words_of(kind).name] = count;
  section.json["deviations"] = {
      {"totals", totals}, {"rows", json_rows(table)}, {"notes", results.log.notes}};
  section.tables = {table};
  return section;
}

}  // namespace promenade::analysis
