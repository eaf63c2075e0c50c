#include "analysis/selection.h"

#include <algorithm>
#include <map>
#include <set>

#include "analysis/item.h"
#include "analysis/natural_order.h"
#include "motion/files.h"
#include "motion/problem.h"

namespace promenade::analysis {
namespace {

// People and their sessions, in the order in which they came.
struct Group {
  std::string code;
  int file = 0;
  std::vector<int> sessions;
};

bool selected(const LoggedSession& session, const SelectionOptions& options) {
  return (!session.simulated || options.include_simulated) &&
         (!session.pilot || options.include_pilot);
}

std::vector<Group> group_by_person(const Log& log, const SelectionOptions& options,
                                   Selection& selection) {
  std::map<std::string, std::size_t> group_of;
  std::set<std::string> simulated;
  std::set<std::string> pilot;
  std::vector<Group> groups;
  for (std::size_t i = 0; i < log.sessions.size(); ++i) {
    const LoggedSession& session = log.sessions[i];
    if (!selected(session, options)) {
      // Simulated pilot sessions are left out as what was not asked for.
      const bool as_simulated = session.simulated && !options.include_simulated;
      (as_simulated ? simulated : pilot).insert(session.participant);
      continue;
    }
    const auto [found, is_new] = group_of.emplace(session.participant, groups.size());
    if (is_new) groups.push_back({session.code, session.file, {}});
    groups[found->second].sessions.push_back(static_cast<int>(i));
  }
  selection.left_out_simulated = size_of(simulated);
  selection.left_out_pilot = size_of(pilot);
  return groups;
}

Disposition disposition_of(const std::string& outcome) {
  if (outcome == "finished") return Disposition::analysed;
  if (outcome == "declined") return Disposition::declined;
  if (outcome == "withdrawn") return Disposition::withdrawn;
  return Disposition::unfinished;
}

// Sessions of people before pilot ones before simulated ones.
int rank_of(const LoggedSession& session) { return session.simulated ? 2 : session.pilot ? 1 : 0; }

int best_rank(const Log& log, const Group& group) {
  int best = rank_of(item(log.sessions, group.sessions[0]));
  for (const int index : group.sessions) {
    best = std::min(best, rank_of(item(log.sessions, index)));
  }
  return best;
}

// Someone's pilot session says nothing once they took part for real. Withdrawn in one
// session is withdrawn in all; else the first finished one counts; else the last outcome.
Person person_of(const Log& log, const Group& group) {
  Person person;
  person.code = group.code;
  const int rank = best_rank(log, group);
  for (const int index : group.sessions) {
    const LoggedSession& session = item(log.sessions, index);
    if (rank_of(session) != rank) continue;
    person.simulated = person.simulated || session.simulated;
    person.pilot = person.pilot || session.pilot;
    if (person.disposition == Disposition::withdrawn) continue;
    const Disposition disposition = disposition_of(session.outcome);
    if (person.disposition == Disposition::analysed && disposition != Disposition::withdrawn)
      continue;
    person.disposition = disposition;
    person.session = disposition == Disposition::analysed ? index : -1;
  }
  return person;
}

void tell_apart(std::vector<Person>& people, const std::vector<Group>& groups,
                Selection& selection) {
  std::map<std::string, int> holders;
  for (const Group& group : groups) ++holders[group.code];
  std::map<std::string, int> given;
  for (Person& person : people) {
    if (holders[person.code] > 1) person.code += "/" + std::to_string(++given[person.code]);
  }
  for (const auto& [code, count] : holders) {
    if (count > 1) selection.shared_codes.push_back(code);
  }
}

bool is_known(const Log& log, const std::string& code) {
  return std::any_of(log.sessions.begin(), log.sessions.end(),
                     [&](const LoggedSession& session) { return session.code == code; });
}

// Whoever did not finish stays what they are.
void exclude(const Log& log, const std::string& file, Selection& selection) {
  std::vector<Problem> problems;
  for (const Exclusion& exclusion : selection.exclusions) {
    for (Person& person : selection.people) {
      if (person.code != exclusion.code || person.disposition != Disposition::analysed) continue;
      person.disposition = Disposition::excluded;
      person.reason = exclusion.reason;
    }
    if (is_known(log, exclusion.code)) continue;
    problems.push_back({file, exclusion.line, 1,
                        "nobody in the databases has the code \"" + exclusion.code + "\"",
                        Severity::error});
  }
  if (!problems.empty()) throw InputError(std::move(problems));
}

}  // namespace

int Selection::count(Disposition disposition) const {
  return static_cast<int>(std::count_if(
      people.begin(), people.end(), [&](const Person& p) { return p.disposition == disposition; }));
}

bool Selection::any_simulated() const {
  return std::any_of(people.begin(), people.end(), [](const Person& p) { return p.simulated; });
}

bool Selection::any_pilot() const {
  return std::any_of(people.begin(), people.end(), [](const Person& p) { return p.pilot; });
}

Selection select(const Log& log, const SelectionOptions& options) {
  Selection selection;
  const std::vector<Group> groups = group_by_person(log, options, selection);
  for (const Group& group : groups) selection.people.push_back(person_of(log, group));
  if (!options.exclude_file.empty()) {
    selection.exclusions = parse_exclusions(options.exclude_file, read_file(options.exclude_file));
    exclude(log, options.exclude_file, selection);
  }
  tell_apart(selection.people, groups, selection);
  std::stable_sort(selection.people.begin(), selection.people.end(),
                   [](const Person& a, const Person& b) { return natural_less(a.code, b.code); });
  return selection;
}

}  // namespace promenade::analysis
