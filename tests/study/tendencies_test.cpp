#include <gtest/gtest.h>

#include "study/simulate.h"
#include "toy.h"

namespace promenade::study {
namespace {

constexpr int people = 40;

// What a cohort did, on average; without practice.
struct Deeds {
  double session_s = 0;
  double rating[2] = {0, 0}, final_d[2] = {0, 0};  // with "pick" and with "mix"
};

void add(Deeds& deeds, const Record& record, const Plan& plan) {
  const auto interface_of = [&plan](int trial) {
    return plan.trials[static_cast<std::size_t>(trial)].interface;
  };
  if (const auto* answer = std::get_if<Answer>(&record)) {
    deeds.rating[interface_of(answer->trial)] += answer->value.value_or(0) / people;
  } else if (const auto* ended = std::get_if<TrialEnded>(&record)) {
    const bool practice = plan.trials[static_cast<std::size_t>(ended->trial)].practice;
    if (!practice && ended->d_final) {
      deeds.final_d[interface_of(ended->trial)] += *ended->d_final / people;
    }
  } else if (const auto* end = std::get_if<SessionEnded>(&record)) {
    deeds.session_s += static_cast<double>(end->t_us) / 1e6 / people;
  }
}

Deeds deeds_of(const Tendencies& tendencies) {
  const StudyBundle bundle = toy::bundle();
  Deeds deeds;
  for (int i = 0; i < people; ++i) {
    const Plan plan = make_plan(bundle.study, i);
    const auto seed = static_cast<std::uint64_t>(i);
    for (const auto& step : simulate_steps(bundle, toy::registry(), plan, seed, tendencies)) {
      for (const Record& record : step) add(deeds, record, plan);
    }
  }
  return deeds;
}

Deeds usual() { return deeds_of({}); }

TEST(Tendencies, OfFatigueMakeTheSessionLonger) {
  Tendencies tired;
  tired.fatigue = 2;
  EXPECT_GT(deeds_of(tired).session_s, 1.1 * usual().session_s);
}

TEST(Tendencies, OfPreferenceRaiseTheRatingsOfThatInterfaceAlone) {
  Tendencies fond;
  fond.preference["mix"] = 0.3;
  const Deeds before = usual();
  const Deeds after = deeds_of(fond);
  EXPECT_GT(after.rating[1], before.rating[1] + 1);
  EXPECT_EQ(after.rating[0], before.rating[0]);
}

TEST(Tendencies, OfDifficultyLeaveMoreDistanceWithThatInterface) {
  Tendencies clumsy;
  clumsy.difficulty["mix"] = 8;
  EXPECT_GT(deeds_of(clumsy).final_d[1], 1.2 * usual().final_d[1]);
}

TEST(Tendencies, OfLearningTakeAwayWhatNoiseAdds) {
  Tendencies noisy;
  noisy.noise = 8;
  Tendencies learning = noisy;
  learning.learning = 0.6;
  EXPECT_LT(deeds_of(learning).final_d[1], deeds_of(noisy).final_d[1]);
}

TEST(Tendencies, OfOwnTasteDifferBetweenPeopleAndKeepTheMean) {
  Tendencies own;
  own.taste = 0.05;
  const Deeds before = usual();
  const Deeds after = deeds_of(own);
  EXPECT_NE(after.rating[0], before.rating[0]);
  EXPECT_NEAR(after.rating[0], before.rating[0], 0.5);
}

}  // namespace
}  // namespace promenade::study
