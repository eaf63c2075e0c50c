#include "analysis/outcomes.h"

#include "motion/problem.h"
#include "study/targets_csv.h"
#include "tests/analysis/made_study.h"

namespace promenade::analysis {
namespace {

// Two people rate, blind, what the six of the first study made.
class OutcomesTest : public MadeTest {
 protected:
  OutcomesTest() { options_.include_simulated = true; }
  Outcomes outcomes(const OutcomeChoice& choice = {}) const {
    return outcomes_of({folder_.file("a.db")}, options_, study::toy::registry(), choice);
  }
  void rate() const {
    const Outcomes made = outcomes();
    std::ofstream(folder_.file("made.csv")) << study::targets_csv(made.targets, made.motions);
    const study::StudyBundle bundle = study::read_study(
        folder_.file("b.toml"),
        "[study]\nname = \"judge\"\nset = \"builtin:A\"\n[[task]]\nname = \"judge\"\nkind = "
        "\"rate\"\ninstrument = \"adjectives\"\ntargets = [{ file = \"made.csv\" }]\n",
        study::toy::registry(),
        [](const std::string&, const std::string&) { return study::toy::motion_set(); });
    study::Store store(folder_.file("b.db"), bundle);
    study::Cohort cohort;
    cohort.participants = 2;
    study::simulate_cohort(bundle, study::toy::registry(), store, cohort);
  }
  // Towards "slow", the first word of the pair.
  double rated_slow(const std::string& name) const {
    study::Database database(folder_.file("b.db"), study::Database::Mode::read_only);
    study::Statement mean(database,
                          "SELECT -avg(answer.value), count(*) FROM answer JOIN trial ON "
                          "trial.uuid = answer.trial WHERE item = 'slow-fast' AND target = ?");
    EXPECT_TRUE(mean.bind(1, name).step());
    EXPECT_EQ(mean.integer(1), 2);
    return mean.real(0);
  }
  Results judged() {
    options_.rated_by = {folder_.file("b.db")};
    return compute_results({folder_.file("a.db")}, options_, {}, &study::toy::registry());
  }

  SelectionOptions options_;
};

TEST_F(OutcomesTest, AreWhatFindTasksEndedWith) {
  const Outcomes made = outcomes();
  EXPECT_EQ(made.motions, (std::vector<std::string>{"near", "side", "far"}));
  ASSERT_EQ(made.targets.size(), 12U);
  for (const Trial& trial : results_.data.trials) {
    if (!asks(trial)) continue;
    const std::string name =
        outcome_name(results_.log.trials[static_cast<std::size_t>(trial.logged)].uuid);
    const auto found = std::find_if(made.targets.begin(), made.targets.end(),
                                    [&name](const auto& target) { return target.name == name; });
    ASSERT_NE(found, made.targets.end());
    EXPECT_TRUE(found->weights->isApprox(weights_of(trial), 1e-12));
  }
}

TEST_F(OutcomesTest, CanBeOfOneInterfaceOrAnotherTask) {
  EXPECT_EQ(outcomes({{}, {"pick"}}).targets.size(), 6U);
  EXPECT_EQ(outcomes({{"copy"}, {}}).targets.size(), 12U);
  EXPECT_THROW(outcomes({{"sek"}, {}}), InputError);
  EXPECT_THROW(outcomes({{}, {"pik"}}), InputError);
  options_.include_simulated = false;
  EXPECT_THROW(outcomes(), InputError);
}

TEST_F(OutcomesTest, AreJudgedByThoseWhoRatedThem) {
  rate();
  const Results results = judged();
  const int measure = results.data.measure("rated_quality");
  ASSERT_GE(measure, 0);
  double least = 2, most = -2;
  for (const Trial& trial : results.data.trials) {
    const auto& value = trial.values[static_cast<std::size_t>(measure)];
    EXPECT_EQ(value.has_value(), asks(trial));
    if (!value) continue;
    const std::string& uuid = results.log.trials[static_cast<std::size_t>(trial.logged)].uuid;
    EXPECT_NEAR(*value, rated_slow(outcome_name(uuid)), 1e-12);
    least = std::min(least, *value);
    most = std::max(most, *value);
  }
  EXPECT_LT(least, most) << "raters who always say the same would test nothing";
}

TEST_F(OutcomesTest, OfAnotherStudyAreRefused) {
  rate();
  study::Database(folder_.file("b.db"), study::Database::Mode::read_write)
      .exec("UPDATE trial SET target = 'made-' || substr(target, 6, 4)");
  try {
    judged();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("rates nothing that was made in this study"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace promenade::analysis
