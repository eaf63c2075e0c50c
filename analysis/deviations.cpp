#include "analysis/deviations.h"

#include <algorithm>
#include <array>
#include <map>

#include "analysis/item.h"

namespace promenade::analysis {
namespace {

std::string name_of(const LoggedTrial& trial) {
  return trial.task + ", " + trial.interface + ", " + trial.target;
}

class Finder {
 public:
  Finder(const Log& log, const Selection& selection) : log_(log), selection_(selection) {
    trials_.resize(log.sessions.size());
    for (int i = 0; i < size_of(log.trials); ++i) {
      item(trials_, item(log.trials, i).session).push_back(i);
    }
    count_planned();
    count_orders();
  }

  std::vector<Deviation> find() {
    for (const Person& person : selection_.people) {
      if (person.disposition == Disposition::analysed) look_at(person);
    }
    find_unused_orders();
    return std::move(found_);
  }

 private:
  using Order = std::array<int, 4>;  // version, simulated, pilot, sequence

  // What most sessions of a version have; of as many the larger one.
  void count_planned() {
    std::map<int, std::map<int, int>> sessions;  // version, trials
    for (const Person& person : selection_.people) {
      if (person.session < 0) continue;
      const int version = item(log_.sessions, person.session).version;
      ++sessions[version][size_of(item(trials_, person.session))];
    }
    for (const auto& [version, counts] : sessions) {
      planned_[version] = std::max_element(counts.begin(), counts.end(), [](auto& a, auto& b) {
                            return a.second != b.second ? a.second < b.second : a.first < b.first;
                          })->first;
    }
  }

  static Order order_of(const LoggedSession& session) {
    return {session.version, session.simulated, session.pilot, session.sequence};
  }

  void count_orders() {
    for (const Person& person : selection_.people) {
      if (person.disposition != Disposition::analysed) continue;
      ++used_[order_of(item(log_.sessions, person.session))];
    }
  }

  void add(DeviationKind kind, const Person& person, int count, const std::string& what = "",
           const std::string& reason = "") {
    if (count > 0) found_.push_back({kind, person.code, count, what, reason});
  }

  void look_at(const Person& person) {
    const LoggedSession& session = item(log_.sessions, person.session);
    const int trials = size_of(item(trials_, person.session));
    add(DeviationKind::missing_trials, person, planned_[session.version] - trials);
    for (const int index : item(trials_, person.session)) {
      const LoggedTrial& trial = item(log_.trials, index);
      if (trial.outcome == "skipped") {
        add(DeviationKind::skipped, person, 1, name_of(trial), reason_for(index));
      } else if (trial.outcome.empty() || trial.outcome == "aborted") {
        add(DeviationKind::not_ended, person, 1, name_of(trial));
      }
    }
    add(DeviationKind::repeated_trials, person, session.repeated_trials);
    for (const LoggedAct& act : log_.acts) {
      if (act.session != person.session || act.kind != "repeat") continue;
      add(DeviationKind::repeat, person, 1, act.target, act.reason);
    }
    add(DeviationKind::resumed, person, session.resumed);
    const int others = used_[order_of(session)] - 1;
    add(DeviationKind::order_repeated, person, others, std::to_string(session.sequence));
  }

  std::string reason_for(int trial) const {
    for (const LoggedAct& act : log_.acts) {
      if (act.kind == "skip" && act.trial == trial) return act.reason;
    }
    return "";
  }

  // Below the largest that anybody analysed has, whatever the version.
  void find_unused_orders() {
    std::map<std::array<int, 2>, std::map<int, int>> used;  // simulated, pilot: sequences
    for (const auto& [order, people] : used_) used[{order[1], order[2]}][order[3]] += people;
    for (const auto& [kind, sequences] : used) {
      for (int sequence = 0; sequence < sequences.rbegin()->first; ++sequence) {
        if (sequences.count(sequence) > 0) continue;
        found_.push_back({DeviationKind::order_unused, "", 1, std::to_string(sequence), ""});
      }
    }
  }

  const Log& log_;
  const Selection& selection_;
  std::vector<std::vector<int>> trials_;  // of each session, indices into Log::trials
  std::map<int, int> planned_;            // trials by version
  std::map<Order, int> used_;             // people analysed
  std::vector<Deviation> found_;
};

}  // namespace

std::vector<Deviation> deviations_of(const Log& log, const Selection& selection) {
  return Finder(log, selection).find();
}

}  // namespace promenade::analysis
