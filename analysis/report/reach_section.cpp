// What each interface can reach at all: the yardstick of regret.
#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/cells.h"
#include "analysis/report/report_sections.h"

namespace promenade::analysis {

Section reach_section(const Results& results) {
  const Reachability& reach = results.reachability;
  Section section;
  if (reach.rows.empty() && reach.missing.empty()) return section;
  section.title = "What each interface can reach";
  section.json["reachable"] = nlohmann::json::array();
  Table table{"reachable",
              "The smallest D that a search over an interface found for a target.",
              {"task", "target", "interface", "d_best_reachable"},
              {}};
  HtmlTable shown;
  shown.caption =
      "Best D that each interface can reach, found by a search over its settings; regret is the "
      "final D minus this.";
  shown.columns = {"task", "target", "interface", "best D"};
  shown.heads = 3;
  for (const BestReachable& row : reach.rows) {
    table.rows.push_back({row.task, row.target, row.interface, row.best_m});
    shown.rows.push_back({row.task, row.target, row.interface, fixed(row.best_m * 100, 1) + " cm"});
    section.json["reachable"].push_back({{"task", row.task},
                                         {"target", row.target},
                                         {"interface", row.interface},
                                         {"d_best_reachable", row.best_m}});
  }
  if (!reach.missing.empty()) section.html += element("p", reach.missing);
  if (reach.rows.empty()) return section;
  section.html += wide(shown);
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace promenade::analysis
