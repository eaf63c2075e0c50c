#include "study/plan.h"

#include <algorithm>
#include <cassert>

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

bool has_interface(const Task& task, int interface) {
  return std::find(task.interfaces.begin(), task.interfaces.end(), interface) !=
         task.interfaces.end();
}

// The trials of one interface, in order.
class Block {
 public:
  Block(const Study& study, int block, int interface, Plan& plan)
      : study_(study), block_(block), interface_(interface), plan_(plan) {}

  void add_practice() {
    for (std::size_t task = 0; task < study_.tasks.size(); ++task) {
      add(task, counted(study_.tasks[task].practice.size()), true);
    }
  }

  void add_tasks(Rng& rng) {
    for (std::size_t task = 0; task < study_.tasks.size(); ++task) {
      std::vector<int> targets = counted(study_.tasks[task].targets.size());
      if (study_.order != Order::fixed) rng.shuffle(targets);
      add(task, targets, false);
    }
  }

 private:
  void add(std::size_t task, const std::vector<int>& targets, bool practice) {
    if (!has_interface(study_.tasks[task], interface_)) return;
    for (const int target : targets) {
      PlannedTrial trial;
      trial.position = static_cast<int>(plan_.trials.size()) + 1;
      trial.block = block_;
      trial.practice = practice;
      trial.task = static_cast<int>(task);
      trial.interface = interface_;
      trial.target = target;
      plan_.trials.push_back(trial);
    }
  }

  const Study& study_;
  int block_;
  int interface_;
  Plan& plan_;
};

void add_pages(const Study& study, Plan& plan) {
  plan.pages = {{PageKind::welcome, -1}, {PageKind::consent, -1}};
  int block = 0;
  for (std::size_t i = 0; i < plan.trials.size(); ++i) {
    const PlannedTrial& trial = plan.trials[i];
    const int index = static_cast<int>(i);
    const bool opens = trial.block != block;
    if (opens && block > 0 && study.breaks.after_block)
      plan.pages.push_back({PageKind::break_, -1});
    plan.pages.push_back({opens ? PageKind::instructions : PageKind::intro, index});
    plan.pages.push_back({PageKind::trial, index});
    if (!trial.practice && !study.ratings.empty()) plan.pages.push_back({PageKind::rating, index});
    block = trial.block;
  }
  plan.pages.push_back({PageKind::thanks, -1});
}

}  // namespace

std::string_view to_text(PageKind kind) {
  switch (kind) {
    case PageKind::language:
      return "language";
    case PageKind::welcome:
      return "welcome";
    case PageKind::consent:
      return "consent";
    case PageKind::instructions:
      return "instructions";
    case PageKind::intro:
      return "intro";
    case PageKind::trial:
      return "trial";
    case PageKind::rating:
      return "rating";
    case PageKind::break_:
      return "break";
    case PageKind::thanks:
      return "thanks";
    case PageKind::declined:
      return "declined";
  }
  return "";
}

Plan make_plan(const Study& study, int sequence) {
  assert(sequence >= 0 && "orders are counted from 0");
  const auto participant = static_cast<std::uint64_t>(sequence);
  Plan plan;
  plan.sequence = sequence;
  // SQLite's integers have a sign.
  plan.seed = Rng(study.seed, participant, "session").next() >> 1;
  Rng order(study.seed, participant, "order");
  int block = 0;
  for (const int interface : interface_order(study, sequence)) {
    const std::size_t before = plan.trials.size();
    Block trials(study, block + 1, interface, plan);
    trials.add_practice();
    trials.add_tasks(order);
    block += plan.trials.size() > before;
  }
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

}  // namespace promenade::study
