#include "analysis/report/rating_tables.h"

#include <fmt/format.h>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/cells.h"

namespace promenade::analysis {
namespace {

Table motion_table(const Results& results) {
  Table table{"rating_pages",
              "Every motion that a person rated, and how its answers vary.",
              {"participant", "session", "trial", "position", "task", "target", "instrument",
               "items", "longest_run", "distinct", "median_s", "straight", "fast", "flagged"},
              {}};
  for (const RatedMotion& one : results.ratings.motions) {
    table.rows.push_back({cell(item(results.data.people, one.person)), cell(one.session),
                          cell(one.trial), cell(one.position), cell(one.task), cell(one.target),
                          cell(one.instrument), cell(one.pattern.items),
                          cell(one.pattern.longest_run), cell(one.pattern.distinct),
                          cell(one.pattern.median_s), cell(one.pattern.straight),
                          cell(one.pattern.fast), cell(one.pattern.flagged())});
  }
  return table;
}

Table rater_table(const Results& results) {
  Table table{"rating_quality",
              "How carefully each person rated, and how alike the motions that came twice.",
              {"participant", "motions", "straight", "fast", "flagged", "repeated", "compared",
               "mean_difference", "within_one", "correlation"},
              {}};
  for (const RaterQuality& one : results.ratings.raters) {
    table.rows.push_back({cell(item(results.data.people, one.person)), cell(one.motions),
                          cell(one.straight), cell(one.fast), cell(one.flagged), cell(one.repeated),
                          cell(one.compared), cell(one.mean_difference), cell(one.within_one),
                          cell(one.correlation)});
  }
  return table;
}

HtmlTable shown_table(const Results& results) {
  HtmlTable table;
  table.caption = fmt::format(
      "Ratings of motions by person. Straight: half of {} answers or more in a row are equal. "
      "Fast: "
      "in the middle {} s or less from one answer to the next. Twice: motions that came again; how "
      "far their answers differ, how many by one step at most, and how they correlate.",
      study::least_items_to_vary, study::fastest_s);
  table.columns = {"participant", "motions", "straight",   "fast",
                   "twice",       "differ",  "within one", "correlation"};
  for (const RaterQuality& one : results.ratings.raters) {
    table.rows.push_back({item(results.data.people, one.person), std::to_string(one.motions),
                          std::to_string(one.straight), std::to_string(one.fast),
                          std::to_string(one.repeated), number_cell(one.mean_difference, 2),
                          one.within_one ? percent(*one.within_one) : dash,
                          number_cell(one.correlation, 2)});
    table.strong.push_back(2 * one.flagged > one.motions);
  }
  return table;
}

std::string sentence_on(const RatingQuality& ratings) {
  int flagged = 0;
  for (const RatedMotion& one : ratings.motions) flagged += one.pattern.flagged() ? 1 : 0;
  return fmt::format("{} of {} of a motion hardly vary or came too fast to be read.", flagged,
                     count_of(size_of(ratings.motions), "rating", "ratings"));
}

}  // namespace

void add_rating_quality(const Results& results, Section& section) {
  if (results.ratings.motions.empty()) return;
  const Table raters = rater_table(results);
  section.html =
      section.html + element("p", sentence_on(results.ratings)) + folded(shown_table(results));
  section.json["rating_quality"] = json_rows(raters);
  section.tables.push_back(raters);
  section.tables.push_back(motion_table(results));
}

}  // namespace promenade::analysis
