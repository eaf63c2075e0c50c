#include "study/plan_pages.h"

#include <algorithm>
#include <set>
#include <utility>

namespace promenade::study {
namespace {

using When = Questionnaire::When;

class Pages {
 public:
  Pages(const Study& study, Plan& plan) : study_(study), plan_(plan) {}

  void add_all() {
    plan_.pages = {{PageKind::welcome}, {PageKind::consent}};
    ask(When::start, -1);
    for (std::size_t i = 0; i < plan_.trials.size(); ++i) {
      open(static_cast<int>(i));
      plan_.pages.push_back({PageKind::trial, static_cast<int>(i)});
      close(static_cast<int>(i));
    }
    ask(When::end, -1);
    plan_.pages.push_back({PageKind::thanks});
  }

 private:
  const PlannedTrial& trial(int index) const {
    return plan_.trials[static_cast<std::size_t>(index)];
  }
  bool is_last(int index) const { return index + 1 == static_cast<int>(plan_.trials.size()); }
  bool ends_block(int index) const {
    return is_last(index) || trial(index + 1).block != trial(index).block;
  }
  // Practice of a block is one row of trials.
  bool ends_practice(int index) const {
    return trial(index).practice && (ends_block(index) || !trial(index + 1).practice);
  }
  bool ends_task(int index) const {
    const PlannedTrial& one = trial(index);
    return !one.practice && std::none_of(plan_.trials.begin() + index + 1, plan_.trials.end(),
                                         [&](const PlannedTrial& later) {
                                           return !later.practice && later.task == one.task &&
                                                  later.interface == one.interface;
                                         });
  }

  void open(int index) {
    const PlannedTrial& one = trial(index);
    const bool new_block = index == 0 || ends_block(index - 1);
    if (new_block) counted_ = 0;
    const bool rests = study_.breaks.after_trials > 0 && counted_ > 0 &&
                       counted_ % study_.breaks.after_trials == 0 && !one.practice;
    if (index > 0 && (new_block ? study_.breaks.after_block : rests)) {
      plan_.pages.push_back({PageKind::break_});
    }
    // What a person has not met yet is explained.
    const int task = one.interface < 0 ? one.task : -1;
    const bool met = !explained_.emplace(one.interface, task).second;
    plan_.pages.push_back({met ? PageKind::intro : PageKind::instructions, index});
  }

  void close(int index) {
    const PlannedTrial& one = trial(index);
    if (!one.practice) {
      ++counted_;
      ask(When::trial, index);
    }
    if (ends_practice(index) && study_.practice.until == Practice::Until::released) {
      plan_.pages.push_back({PageKind::release, index});
    }
    if (ends_task(index)) ask(When::task, index);
    if (ends_block(index) && !one.practice && one.interface >= 0) ask(When::block, index);
  }

  bool is_about(const Questionnaire& questionnaire, int index) const {
    const std::vector<int>& tasks = questionnaire.tasks;
    if (index < 0 || questionnaire.when == When::block) return true;
    // The answers of a rate trial are its own instrument, unless the study says otherwise.
    if (tasks.empty()) return trial(index).interface >= 0;
    return std::find(tasks.begin(), tasks.end(), trial(index).task) != tasks.end();
  }

  void ask(When when, int index) {
    for (std::size_t q = 0; q < study_.questionnaires.size(); ++q) {
      const Questionnaire& questionnaire = study_.questionnaires[q];
      if (questionnaire.when != when || !is_about(questionnaire, index)) continue;
      plan_.pages.push_back({PageKind::questionnaire, index, static_cast<int>(q)});
    }
  }

  const Study& study_;
  Plan& plan_;
  std::set<std::pair<int, int>> explained_;  // interface, or -1 and the rate task
  int counted_ = 0;                          // trials of this block that count, so far
};

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
    case PageKind::questionnaire:
      return "questionnaire";
    case PageKind::release:
      return "release";
    case PageKind::break_:
      return "break";
    case PageKind::thanks:
      return "thanks";
    case PageKind::declined:
      return "declined";
  }
  return "";
}

void add_pages(const Study& study, Plan& plan) { Pages(study, plan).add_all(); }

}  // namespace promenade::study
