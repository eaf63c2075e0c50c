#include "analysis/flow.h"

#include <set>

#include "analysis/item.h"

namespace promenade::analysis {

Flow flow_of(const Log& log, const Selection& selection) {
  std::set<std::string> came;
  for (const LoggedSession& session : log.sessions) came.insert(session.code);
  Flow flow;
  flow.booked = size_of(log.roster);
  for (const LoggedPlace& place : log.roster) {
    flow.no_show += place.state == "no_show" ? 1 : 0;
    flow.replaced += place.state == "replaced" ? 1 : 0;
    flow.expected += place.state == "booked" && came.count(place.code) == 0 ? 1 : 0;
  }
  flow.removed = log.removed_people;
  flow.began = size_of(selection.people) + flow.removed;
  flow.declined = selection.count(Disposition::declined);
  flow.withdrawn = selection.count(Disposition::withdrawn) + flow.removed;
  flow.unfinished = selection.count(Disposition::unfinished);
  flow.excluded = selection.count(Disposition::excluded);
  flow.analysed = selection.count(Disposition::analysed);
  return flow;
}

}  // namespace promenade::analysis
