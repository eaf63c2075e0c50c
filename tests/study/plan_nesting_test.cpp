// Other orders of the three loops, rate tasks, questionnaires and breaks.
#include <gtest/gtest.h>

#include "study/plan.h"
#include "toy.h"

namespace promenade::study {
namespace {

const std::string head = "[study]\nname = 'plan'\nseed = 3\norder = 'fixed'\n";
const std::string body =
    "[[interface]]\nname = 'pick'\n[[interface]]\nname = 'mix'\n"
    "[[task]]\nname = 'copy'\nkind = 'match'\ntargets = [{example = 'far'}, {example = 'side'}]\n"
    "practice = [{example = 'near'}]\n"
    "[[task]]\nname = 'seek'\nkind = 'find'\nqualities = [{name = 'jolly'}]\n";

Plan plan_of(const std::string& text, int sequence = 0) {
  return make_plan(toy::bundle(text).study, sequence);
}

// "copy/pick/far" and so on, practice in brackets, "|" between blocks.
std::string trials_of(const std::string& text) {
  const Study study = toy::bundle(text).study;
  const Plan plan = make_plan(study, 0);
  std::string line;
  int block = 1;
  for (const PlannedTrial& trial : plan.trials) {
    if (trial.block != block) line += "| ";
    block = trial.block;
    std::string one = task_of(study, trial).name;
    if (trial.interface >= 0) {
      one += "/" + study.interfaces[static_cast<std::size_t>(trial.interface)].name;
    }
    one += "/" + target_of(study, trial).name;
    line += (trial.practice ? "(" + one + ")" : one) + " ";
  }
  return line;
}

std::string pages_of(const std::string& text) {
  std::string line;
  for (const Page& page : plan_of(text).pages) line += std::string(to_text(page.kind)) + " ";
  return line;
}

TEST(Nesting, HasTheInterfaceOutermostUnlessToldOtherwise) {
  EXPECT_EQ(trials_of(head + body),
            "(copy/pick/near) copy/pick/far copy/pick/side seek/pick/jolly "
            "| (copy/mix/near) copy/mix/far copy/mix/side seek/mix/jolly ");
}

TEST(Nesting, WithTheTaskOutermostPractisesFirst) {
  EXPECT_EQ(trials_of(head + "nesting = ['task', 'interface', 'target']\n" + body),
            "(copy/pick/near) | (copy/mix/near) "
            "| copy/pick/far copy/pick/side copy/mix/far copy/mix/side "
            "| seek/pick/jolly seek/mix/jolly ");
}

TEST(Nesting, WithTheTargetOutermostIsTheOrderOfOshita) {
  EXPECT_EQ(trials_of(head + "nesting = ['target', 'task', 'interface']\n" + body),
            "(copy/pick/near) | (copy/mix/near) "
            "| copy/pick/far copy/mix/far seek/pick/jolly seek/mix/jolly "
            "| copy/pick/side copy/mix/side ");
}

TEST(Nesting, IsRefusedUnlessItNamesAllThree) {
  for (const char* wrong :
       {"['task']", "['task', 'task', 'target']", "['task', 'goal', 'target']"}) {
    EXPECT_THROW(toy::bundle(head + "nesting = " + wrong + "\n" + body), InputError) << wrong;
  }
}

TEST(RateTasks, AreBlocksOfTheirOwnWithoutAnInterface) {
  const std::string rate =
      "[[task]]\nname = 'judge'\nkind = 'rate'\ninstrument = 'impression'\n"
      "targets = [{example = 'far'}, {example = 'near'}]\n";
  EXPECT_EQ(trials_of(head + rate), "judge/far judge/near ");
  const std::string last = trials_of(head + body + rate);
  EXPECT_EQ(last.substr(last.rfind('|')), "| judge/far judge/near ");
}

TEST(Questionnaires, StandWhereTheyAreAskedFor) {
  std::string text = head +
                     "[[interface]]\nname = 'pick'\n[[interface]]\nname = 'mix'\n[[task]]\nname = "
                     "'copy'\nkind = 'match'\ntargets = [{example = 'far'}]\n";
  for (const char* when : {"start", "trial", "task", "block", "end"}) {
    text += "[[questionnaire]]\ninstrument = 'comment'\nwhen = '" + std::string(when) + "'\n";
  }
  EXPECT_EQ(pages_of(text),
            "welcome consent questionnaire "
            "instructions trial questionnaire questionnaire questionnaire "
            "instructions trial questionnaire questionnaire questionnaire "
            "questionnaire thanks ");
}

TEST(Questionnaires, CanBeOfSomeTasksOnly) {
  const std::string text = head + body +
                           "[[questionnaire]]\ninstrument = 'comment'\nwhen = 'trial'\ntasks = "
                           "['seek']\n";
  const Plan plan = plan_of(text);
  int asked = 0;
  for (const Page& page : plan.pages) {
    if (page.kind != PageKind::questionnaire) continue;
    ++asked;
    EXPECT_EQ(plan.trials[static_cast<std::size_t>(page.trial)].task, 1);
  }
  EXPECT_EQ(asked, 2);
}

TEST(Breaks, CanComeAfterSoManyTrialsToo) {
  const std::string text = head + body + "[breaks]\nevery = 2\nafter = 'block'\n";
  EXPECT_EQ(pages_of(text),
            "welcome consent "
            "instructions trial intro trial intro trial break intro trial break "
            "instructions trial intro trial intro trial break intro trial thanks ");
}

TEST(Instructions, OpenWhatHasNotBeenMetAndNothingElse) {
  const std::string text = head + "nesting = ['target', 'task', 'interface']\n" + body;
  const std::string pages = pages_of(text);
  std::size_t count = 0;
  for (auto at = pages.find("instructions"); at != std::string::npos;
       at = pages.find("instructions", at + 1)) {
    ++count;
  }
  EXPECT_EQ(count, 2U) << pages;
}

}  // namespace
}  // namespace promenade::study
