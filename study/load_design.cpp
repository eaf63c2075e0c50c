// How a session is laid out: the design keys of [study], [breaks], [practice], [safety].
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "motion/did_you_mean.h"
#include "study/plan.h"
#include "study/study_parts.h"

namespace promenade::study {
namespace {

Sequence sequence_of(const std::optional<std::string>& word, Sequence standard) {
  if (!word) return standard;
  return *word == "random" ? Sequence::random : Sequence::fixed;
}

// ["target", "task", "interface"]: each of the three once.
void read_nesting(const TomlTable& table, Study& study) {
  if (!table.has("nesting")) return;
  const std::array<std::string, 3> words = {"interface", "task", "target"};
  std::vector<Factor> factors;
  for (const TomlText& entry : table.texts("nesting")) {
    const auto found = std::find(words.begin(), words.end(), entry.text);
    const auto factor = static_cast<Factor>(found - words.begin());
    const bool twice = std::find(factors.begin(), factors.end(), factor) != factors.end();
    if (found == words.end() || twice) {
      table.reader().add(entry.place, "\"" + entry.text + "\" is " +
                                          (twice ? "named twice" : "no factor of a study") +
                                          did_you_mean(entry.text, {words.begin(), words.end()}));
      return;
    }
    factors.push_back(factor);
  }
  if (factors.size() != words.size()) {
    table.error("nesting",
                R"("nesting" names "interface", "task" and "target", the outermost first)");
    return;
  }
  std::copy(factors.begin(), factors.end(), study.nesting.begin());
}

}  // namespace

void read_design(const TomlTable& table, Study& study) {
  const std::vector<std::string> words = {"fixed", "random"};
  study.task_order = sequence_of(table.choice("task_order", words), study.task_order);
  study.target_order = sequence_of(table.choice("target_order", words), study.target_order);
  read_nesting(table, study);
  study.participants = static_cast<int>(table.integer("participants", 1, 100'000).value_or(0));
  study.most_minutes = table.number("most_minutes", 1, 1440).value_or(study.most_minutes);
}

namespace {

// "10 or 20", the next good numbers.
std::string next_multiples(int people, int round) {
  const int rounds = std::max(1, people / round);
  return fmt::format("{} or {}", rounds * round, (rounds + 1) * round);
}

void warn_of_orders(const TomlTable& section, const Study& study) {
  const int round = round_of_orders(study);
  if (study.participants % round == 0) return;
  const bool lists = round != rows_of_design(study);
  section.warning("participants",
                  fmt::format("{} people are not balanced over the {} orders of the interfaces"
                              "{}; {} are",
                              study.participants, round, lists ? " with the lists of targets" : "",
                              next_multiples(study.participants, round)));
}

void warn_of_ratings(const TomlTable& section, const Study& study) {
  for (const Task& task : study.tasks) {
    if (!task.split || study.participants % round_of_ratings(*task.split) == 0) continue;
    section.warning(
        "participants",
        fmt::format("{} people who rate {} of {} motions each rate some of the task \"{}\" more "
                    "often than others; {} people do not",
                    study.participants, task.split->each(), task.split->motions(), task.name,
                    next_multiples(study.participants, round_of_design(study))));
  }
}

}  // namespace

void warn_of_numbers(const TomlTable& root, const Study& study) {
  if (study.participants == 0) return;
  const TomlTable section = *root.table("study");
  warn_of_orders(section, study);
  warn_of_ratings(section, study);
}

void read_breaks(const TomlTable& root, Study& study) {
  const auto table = root.table("breaks");
  if (!table) return;
  study.breaks.after_block = table->choice("after", {"none", "block"}) == "block";
  study.breaks.after_trials = static_cast<int>(table->integer("every", 1, 1000).value_or(0));
  const double least_s = table->number("least_s", 0, 3600).value_or(0);
  study.breaks.least_us = static_cast<std::int64_t>(std::llround(1e6 * least_s));
}

void read_practice(const TomlTable& root, Study& study) {
  const auto table = root.table("practice");
  if (!table) return;
  Practice& practice = study.practice;
  const auto until = table->choice("until", {"done", "criterion", "released"});
  if (until == "criterion") practice.until = Practice::Until::criterion;
  if (until == "released") practice.until = Practice::Until::released;
  practice.successes =
      static_cast<int>(table->integer("successes", 1, 100).value_or(practice.successes));
  practice.most_rounds =
      static_cast<int>(table->integer("most_rounds", 1, 100).value_or(practice.most_rounds));
}

void read_safety(const TomlTable& root, Study& study) {
  const auto table = root.table("safety");
  if (!table) return;
  Safety& safety = study.safety;
  const auto resume = table->choice("resume", {"continue", "trial", "block"});
  if (resume == "trial") safety.resume = ResumePolicy::redo_trial;
  if (resume == "block") safety.resume = ResumePolicy::redo_block;
  if (table->choice("withdraw", {"everything", "link"}) == "link") {
    safety.withdrawal = Withdrawal::link;
  }
  safety.copy_to = table->text("copy_to").value_or("");
  safety.leave = table->boolean("leave").value_or(false);
  safety.keep = table->text("keep").value_or("");
}

}  // namespace promenade::study
