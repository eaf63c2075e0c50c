// Simulated people who only want to be done with it, as the report is to find them.
#include <gtest/gtest.h>

#include "study/answer_pattern.h"
#include "study/load_study.h"
#include "study/simulate.h"
#include "toy.h"

namespace promenade::study {
namespace {

// What a person answers to 41 pairs about one walk.
AnswerPattern pattern_of(const Tendencies& tendencies, std::uint64_t seed) {
  const StudyBundle bundle =
      read_study("rated.toml",
                 "[study]\nname = 'rated'\n[[task]]\nname = 'judge'\nkind = 'rate'\ninstrument = "
                 "'adjectives'\ntargets = [{example = 'happy'}]\n",
                 toy::registry(), load_motion_set);
  std::vector<TimedAnswer> answers;
  for (const auto& step :
       simulate_steps(bundle, toy::registry(), make_plan(bundle.study, 0), seed, tendencies)) {
    for (const Record& record : step) {
      const auto* answer = std::get_if<Answer>(&record);
      if (answer && answer->trial >= 0) answers.push_back({*answer->value, answer->t_us});
    }
  }
  return answer_pattern(answers);
}

TEST(SimulatedParticipants, DrawLinesOnlyWhereTheyTendToIt) {
  Tendencies lazy;
  lazy.straight_lining = 1;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    EXPECT_FALSE(pattern_of({}, seed).flagged());
    EXPECT_TRUE(pattern_of(lazy, seed).fast);
    EXPECT_LE(pattern_of(lazy, seed).distinct, 5);
    EXPECT_GE(pattern_of(lazy, seed).longest_run, 10);
  }
}

}  // namespace
}  // namespace promenade::study
