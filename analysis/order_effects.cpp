#include "analysis/order_effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/primary.h"
#include "analysis/statistics/differences.h"
#include "analysis/statistics/median.h"

namespace promenade::analysis {
namespace {

// turn[person][interface] in one task, from 1; 0: the person did not have it.
using Turns = std::vector<std::vector<int>>;

// The order of the trials as they were worked on, also of those that do not count.
Turns turns_in(const Log& log, const Dataset& data, int task) {
  std::vector<int> person_of(log.sessions.size(), -1);
  for (const Trial& trial : data.trials) {
    const int session = item(log.trials, trial.logged).session;
    person_of[static_cast<std::size_t>(session)] = trial.person;
  }
  Turns turns(data.people.size(), std::vector<int>(data.interfaces.size(), 0));
  std::vector<int> last(data.people.size(), 0);
  for (const LoggedTrial& trial : log.trials) {
    const int person = item(person_of, trial.session);
    if (person < 0 || trial.task != item(data.tasks, task).name) continue;
    const auto found = std::find(data.interfaces.begin(), data.interfaces.end(), trial.interface);
    if (found == data.interfaces.end()) continue;
    int& turn = item(item(turns, person), static_cast<int>(found - data.interfaces.begin()));
    if (turn == 0) turn = ++item(last, person);
  }
  return turns;
}

// values[turn - 1] of one person.
PersonValues by_turn(const std::vector<PersonValues>& of_interface, const Turns& turns,
                     int person) {
  PersonValues values(of_interface.size());
  for (int i = 0; i < size_of(of_interface); ++i) {
    const int turn = item(item(turns, person), i);
    if (turn > 0) item(values, turn - 1) = item(item(of_interface, i), person);
  }
  return values;
}

// Nothing for fewer than two values.
std::optional<double> slope_of(const PersonValues& values) {
  double n = 0, sum_x = 0, sum_y = 0;
  for (int i = 0; i < size_of(values); ++i) {
    if (!item(values, i)) continue;
    ++n;
    sum_x += i;
    sum_y += *item(values, i);
  }
  if (n < 2) return std::nullopt;
  double above = 0, below = 0;
  for (int i = 0; i < size_of(values); ++i) {
    if (!item(values, i)) continue;
    above += (i - sum_x / n) * (*item(values, i) - sum_y / n);
    below += (i - sum_x / n) * (i - sum_x / n);
  }
  return above / below;
}

void test_slopes(Learning& learning) {
  // As one side of pairs whose other side is zero, so that rounding makes no false order.
  const PersonValues slopes(learning.slopes.begin(), learning.slopes.end());
  learning.slopes = paired_differences(slopes, PersonValues(slopes.size(), 0.0)).values;
  if (learning.slopes.empty()) return;
  learning.test = wilcoxon(learning.slopes);
  learning.p = learning.test.exact ? learning.test.exact->two : learning.test.normal->two;
  learning.sign = sign_test(learning.test.n_positive, learning.test.n_negative);
  const WalshAverages walsh(learning.slopes);
  learning.hl = hodges_lehmann(walsh);
  learning.hl_ci = hodges_lehmann_interval(walsh, learning.test.n, 0.95);
}

class Maker {
 public:
  Maker(const Log& log, const Dataset& data) : log_(log), data_(data) {}

  OrderEffects make() {
    for (int task = 0; task < size_of(data_.tasks); ++task) {
      const Turns turns = turns_in(log_, data_, task);
      for (int measure = 0; measure < size_of(data_.measures); ++measure) {
        if (is_primary(item(data_.measures, measure)) && data_.occurs(measure, task)) {
          add_measure(measure, task, turns);
        }
      }
      count(task, turns);
      say(task);
    }
    return std::move(made_);
  }

 private:
  void add_measure(int measure, int task, const Turns& turns) {
    std::vector<PersonValues> of_interface;
    for (int i = 0; i < size_of(data_.interfaces); ++i) {
      of_interface.push_back(mean_per_person(data_, measure, i, task));
    }
    std::vector<PersonValues> of_turn(data_.interfaces.size());
    Learning learning;
    learning.measure = measure;
    learning.task = task;
    for (int person = 0; person < size_of(data_.people); ++person) {
      const PersonValues values = by_turn(of_interface, turns, person);
      for (int i = 0; i < size_of(values); ++i) {
        item(of_turn, i).push_back(item(values, i));
      }
      if (const auto slope = slope_of(values)) learning.slopes.push_back(*slope);
    }
    for (int i = 0; i < size_of(of_turn); ++i) {
      const std::vector<double> values = present(item(of_turn, i));
      if (values.empty()) continue;
      made_.turns.push_back({measure, task, i + 1, moments_of(values), median_of(values)});
    }
    test_slopes(learning);
    made_.learning.push_back(std::move(learning));
    add_carry_over(measure, task);
  }

  // One value per person: the mean over the trials after the same interface.
  void add_carry_over(int measure, int task) {
    using Place = std::pair<int, int>;  // interface, previous one
    std::map<Place, std::map<int, std::pair<double, int>>> sums;
    for (const Trial& trial : data_.trials) {
      const std::optional<double>& value = item(trial.values, measure);
      if (trial.task != task || !value) continue;
      auto& [sum, count] = sums[{trial.interface, trial.previous_interface}][trial.person];
      sum += *value;
      ++count;
    }
    for (const auto& [place, people] : sums) {
      std::vector<double> values;
      for (const auto& [person, sum] : people) values.push_back(sum.first / sum.second);
      made_.carry_over.push_back({measure, task, place.first, place.second, moments_of(values)});
    }
  }

  void count(int task, const Turns& turns) {
    const int interfaces = size_of(data_.interfaces);
    for (int i = 0; i < interfaces; ++i) {
      TurnCount count{task, i, std::vector<int>(data_.interfaces.size(), 0)};
      for (const std::vector<int>& of_person : turns) {
        if (item(of_person, i) > 0) ++item(count.at_turn, item(of_person, i) - 1);
      }
      made_.turn_counts.push_back(std::move(count));
    }
    for (int before = 0; before < interfaces; ++before) {
      for (int after = 0; after < interfaces; ++after) {
        if (before == after) continue;
        SuccessionCount count{task, before, after, 0};
        for (const std::vector<int>& turn : turns) {
          const bool follows =
              item(turn, before) > 0 && item(turn, after) == item(turn, before) + 1;
          count.people += follows ? 1 : 0;
        }
        made_.successions.push_back(count);
      }
    }
  }

  void say(int task) {
    const std::string where =
        data_.tasks.size() > 1 ? "In task " + item(data_.tasks, task).name + " " : "";
    const std::string sentence = where + balance_in(task);
    made_.sentences.push_back(capitalised(sentence));
  }

  // How many interfaces the task was for: an order has as many places.
  int interfaces_in(int task) const {
    int used = 0;
    for (const TurnCount& count : made_.turn_counts) {
      used += count.task == task && is_used(count) ? 1 : 0;
    }
    return used;
  }

  bool is_used(const TurnCount& count) const {
    return std::any_of(count.at_turn.begin(), count.at_turn.end(),
                       [](int people) { return people > 0; });
  }

  // The smallest and the largest of all counts of a task, and whose they are.
  struct Spread {
    int least = 0, least_at = 0;
    int most = -1, most_at = 0;
    bool fixed = true;  // each interface stood at one place alone
  };
  Spread spread_in(int task) const {
    Spread spread;
    const int turns = interfaces_in(task);
    for (const TurnCount& count : made_.turn_counts) {
      if (count.task != task || !is_used(count)) continue;
      int places = 0;
      for (int turn = 0; turn < turns; ++turn) {
        const int people = item(count.at_turn, turn);
        const bool first = spread.most < 0;
        if (first || people < spread.least)
          spread.least = people, spread.least_at = count.interface;
        if (first || people > spread.most) spread.most = people, spread.most_at = count.interface;
        places += people > 0 ? 1 : 0;
      }
      spread.fixed = spread.fixed && places <= 1;
    }
    return spread;
  }

  std::string balance_in(int task) const {
    const int interfaces = interfaces_in(task);
    if (interfaces < 2) return "there is one interface, and so no order to balance.";
    if (data_.people.size() == 1) return "one person has one order: there is nothing to balance.";
    const Spread spread = spread_in(task);
    if (spread.fixed) {
      return "everybody had the interfaces in the same order: what comes from learning, and what "
             "from the interface, cannot be told apart.";
    }
    const bool uneven = size_of(data_.people) % interfaces != 0;
    if (uneven && spread.most - spread.least == 1) {
      return fmt::format(
          "the orders are as balanced as {} people allow: each interface stood {} or {} times at "
          "each place.",
          data_.people.size(), spread.least, spread.most);
    }
    return spread.least == spread.most ? successions_in(task) : positions_differ(spread);
  }

  std::string positions_differ(const Spread& spread) const {
    return fmt::format(
        "the orders are not balanced: {} stood {} at one of the places, {} stood {} at one, so "
        "that differences between interfaces hold some of the effect of order.",
        item(data_.interfaces, spread.least_at), count_of(spread.least, "time", "times"),
        item(data_.interfaces, spread.most_at), count_of(spread.most, "time", "times"));
  }

  std::string successions_in(int task) const {
    std::set<int> used, counts;
    for (const TurnCount& count : made_.turn_counts) {
      if (count.task == task && is_used(count)) used.insert(count.interface);
    }
    for (const SuccessionCount& one : made_.successions) {
      const bool both = used.count(one.previous) > 0 && used.count(one.interface) > 0;
      if (one.task == task && both) counts.insert(one.people);
    }
    if (counts.size() <= 1) {
      return "the orders are balanced: each interface stood equally often at each place, and "
             "followed each other one equally often.";
    }
    return fmt::format(
        "each interface stood equally often at each place, but not after each other one: between "
        "{} and {} people had one right after another.",
        *counts.begin(), *counts.rbegin());
  }

  const Log& log_;
  const Dataset& data_;
  OrderEffects made_;
};

}  // namespace

OrderEffects order_effects_of(const Log& log, const Dataset& data) {
  return Maker(log, data).make();
}

}  // namespace promenade::analysis
