// The trials of a session, in their order.
#include "study/plan.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <numeric>
#include <tuple>

#include "study/plan_pages.h"
#include "study/repeats.h"

namespace promenade::study {
namespace {

std::vector<int> counted(std::size_t n) {
  std::vector<int> values;
  for (std::size_t i = 0; i < n; ++i) values.push_back(static_cast<int>(i));
  return values;
}

std::vector<int> interface_order(const Study& study, int sequence) {
  const int n = static_cast<int>(study.interfaces.size());
  std::vector<int> order = counted(study.interfaces.size());
  if (study.order == Order::random) {
    Rng rng(study.seed, static_cast<std::uint64_t>(sequence), "interfaces");
    rng.shuffle(order);
  }
  if (study.order == Order::random || study.order == Order::fixed || n == 0) return order;
  const auto rows = study.order == Order::latin ? latin_square(n) : williams_design(n);
  return rows[static_cast<std::size_t>(sequence) % rows.size()];
}

// A task that begins from a guess has the targets, lists and draws of that task.
int dealer_of(const Study& study, int task) {
  const int guess = study.tasks[static_cast<std::size_t>(task)].start_guess;
  return guess >= 0 ? guess : task;
}

// In the order of the file.
std::vector<int> rated_by(const Task& task, int sequence) {
  if (!task.split) return counted(task.targets.size());
  std::vector<int> targets = motions_of(*task.split, sequence);
  std::sort(targets.begin(), targets.end());
  return targets;
}

bool contains(const std::vector<int>& values, int value) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

// Adds trials to the plan, block by block.
class Trials {
 public:
  Trials(const Study& study, Plan& plan)
      : study_(study),
        plan_(plan),
        order_(study.seed, static_cast<std::uint64_t>(plan.sequence), "order"),
        interfaces_(interface_order(study, plan.sequence)),
        tasks_(counted(study.tasks.size())) {
    if (study.task_order == Sequence::random) {
      Rng rng(study.seed, static_cast<std::uint64_t>(plan.sequence), "tasks");
      rng.shuffle(tasks_);
    }
  }

  void add_all() {
    const bool first = !study_.tasks.empty() && study_.tasks[0].kind == TaskKind::rate;
    if (first) add_rate_tasks();
    if (study_.nesting[0] != Factor::interface) add_practice_blocks();
    loop(0, {});
    if (!first) add_rate_tasks();
  }

 private:
  struct Choice {
    int interface = -1, task = -1, target = -1;
  };

  const Task& task(int index) const { return study_.tasks[static_cast<std::size_t>(index)]; }

  void add_rate_tasks() {
    for (const int index : tasks_) {
      if (task(index).kind != TaskKind::rate) continue;
      open_block();
      for (std::size_t k = 0; k < task(index).practice.size(); ++k) {
        add({-1, index, static_cast<int>(k)}, true);
      }
      for (const Showing& one : showings(task(index))) {
        add({-1, index, one.target}, false);
        plan_.trials.back().showing = one.showing;
      }
    }
  }

  void add_practice_blocks() {
    for (const int interface : interfaces_) {
      open_block();
      add_practice(interface);
    }
  }

  void add_practice(int interface) {
    for (const int index : tasks_) {
      for (std::size_t k = 0; k < task(index).practice.size(); ++k) {
        if (contains(task(index).interfaces, interface)) {
          add({interface, index, static_cast<int>(k)}, true);
        }
      }
    }
  }

  void loop(std::size_t level, Choice choice) {
    if (level == study_.nesting.size()) {
      if (is_dealt(choice)) add(choice, false);
      return;
    }
    for (const int value : values_of(study_.nesting[level], choice)) {
      if (level == 0) open_block();
      Choice inner = choice;
      switch (study_.nesting[level]) {
        case Factor::interface:
          inner.interface = value;
          if (level == 0) add_practice(value);
          break;
        case Factor::task:
          inner.task = value;
          break;
        case Factor::target:
          inner.target = value;
          break;
      }
      loop(level + 1, inner);
    }
  }

  std::vector<int> values_of(Factor factor, const Choice& choice) {
    if (factor == Factor::interface) return interfaces_;
    if (factor == Factor::target) {
      if (choice.task >= 0) return targets_in_order(task(choice.task).targets.size());
      std::size_t most = 0;
      for (const Task& one : study_.tasks) {
        if (one.kind != TaskKind::rate) most = std::max(most, one.targets.size());
      }
      return targets_in_order(most);
    }
    std::vector<int> tasks;
    for (const int index : tasks_) {
      if (task(index).kind != TaskKind::rate) tasks.push_back(index);
    }
    return tasks;
  }

  std::vector<int> targets_in_order(std::size_t count) { return in_order(counted(count)); }

  bool is_fixed() const {
    return study_.order == Order::fixed || study_.target_order == Sequence::fixed;
  }

  std::vector<int> in_order(std::vector<int> targets) {
    if (!is_fixed()) order_.shuffle(targets);
    return targets;
  }

  std::vector<Showing> showings(const Task& task) {
    const bool repeats = task.split && task.repeats > 0;
    return with_repeats(
        in_order(rated_by(task, plan_.sequence)),
        repeats ? repeated_of(*task.split, task.repeats, plan_.sequence) : std::vector<int>(),
        is_fixed());
  }

  bool is_dealt(const Choice& choice) const {
    const Task& asked = task(choice.task);
    if (!contains(asked.interfaces, choice.interface)) return false;
    if (choice.target >= static_cast<int>(asked.targets.size())) return false;
    if (asked.deal == Deal::same) return true;
    const int list = list_of(study_, choice.task, choice.interface, plan_.sequence);
    return contains(asked.lists[static_cast<std::size_t>(list)], choice.target);
  }

  // A block that gets no trial is none.
  void open_block() {
    const bool empty = plan_.trials.empty() || plan_.trials.back().block < block_;
    if (!empty || block_ == 0) ++block_;
  }

  void add(const Choice& choice, bool practice) {
    PlannedTrial trial;
    trial.position = static_cast<int>(plan_.trials.size()) + 1;
    trial.block = block_;
    trial.practice = practice;
    trial.task = choice.task;
    trial.interface = choice.interface;
    trial.target = choice.target;
    const Target& target = target_of(study_, trial);
    if (target.draw) trial.drawn = drawn(choice.task, target, practice, choice.target);
    plan_.trials.push_back(std::move(trial));
  }

  // Drawn once, for all interfaces, and for a guess and what begins from it.
  const Eigen::VectorXd& drawn(int index, const Target& target, bool practice, int place) {
    Eigen::VectorXd& weights = drawn_[{dealer_of(study_, index), practice, place}];
    if (weights.size() == 0) weights = drawn_target(study_, index, target, plan_.sequence);
    return weights;
  }

  const Study& study_;
  Plan& plan_;
  Rng order_;
  std::vector<int> interfaces_, tasks_;
  std::map<std::tuple<int, bool, int>, Eigen::VectorXd> drawn_;
  int block_ = 0;
};

}  // namespace

int rows_of_design(const Study& study) {
  const int n = static_cast<int>(study.interfaces.size());
  if (n == 0) return 1;
  if (study.order == Order::latin) return static_cast<int>(latin_square(n).size());
  return study.order == Order::williams ? static_cast<int>(williams_design(n).size()) : 1;
}

int round_of_orders(const Study& study) {
  int lists = 1;
  for (const Task& task : study.tasks) {
    if (task.deal == Deal::rotated && !task.lists.empty()) {
      lists = std::lcm(lists, static_cast<int>(task.lists.size()));
    }
  }
  return rows_of_design(study) * lists;
}

int round_of_design(const Study& study) {
  int round = round_of_orders(study);
  for (const Task& task : study.tasks) {
    if (task.split) round = std::lcm(round, round_of_ratings(*task.split));
  }
  return round;
}

int cells_of_design(const Study& study) {
  int cells = round_of_design(study);
  for (const Task& task : study.tasks) {
    if (task.split) cells = std::lcm(cells, round_of_pairs(*task.split));
  }
  return cells;
}

// Over as many sequences as there are lists every interface meets every list; over all orders
// of the design times that, in every order.
int list_of(const Study& study, int task, int interface, int sequence) {
  const Task& dealer = study.tasks[static_cast<std::size_t>(dealer_of(study, task))];
  const auto found = std::find(dealer.interfaces.begin(), dealer.interfaces.end(), interface);
  const int rows = rows_of_design(study);
  const int shift = sequence % rows + sequence / rows;
  const auto place = static_cast<int>(found - dealer.interfaces.begin());
  return (place + shift) % static_cast<int>(dealer.lists.size());
}

Eigen::VectorXd drawn_target(const Study& study, int task, const Target& target, int sequence) {
  const std::string& name = study.tasks[static_cast<std::size_t>(dealer_of(study, task))].name;
  const std::string& stream = target.stream.empty() ? target.name : target.stream;
  Rng rng(study.seed, static_cast<std::uint64_t>(sequence), "target:" + name + ":" + stream);
  return target.draw(rng);
}

Plan make_plan(const Study& study, int sequence) {
  assert(sequence >= 0 && "orders are counted from 0");
  Plan plan;
  plan.sequence = sequence;
  // SQLite's integers have a sign.
  plan.seed = Rng(study.seed, static_cast<std::uint64_t>(sequence), "session").next() >> 1;
  Trials(study, plan).add_all();
  add_pages(study, plan);
  return plan;
}

const Task& task_of(const Study& study, const PlannedTrial& trial) {
  return study.tasks[static_cast<std::size_t>(trial.task)];
}

const Target& target_of(const Study& study, const PlannedTrial& trial) {
  const Task& task = task_of(study, trial);
  return (trial.practice ? task.practice : task.targets)[static_cast<std::size_t>(trial.target)];
}

const Eigen::VectorXd* target_weights(const Study& study, const PlannedTrial& trial) {
  if (trial.drawn.size() > 0) return &trial.drawn;
  const Target& target = target_of(study, trial);
  return target.weights ? &*target.weights : nullptr;
}

}  // namespace promenade::study
