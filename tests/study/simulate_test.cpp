#include "study/simulate.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <future>

#include "study/sqlite.h"
#include "toy.h"

namespace promenade::study {
namespace {

namespace fs = std::filesystem;

// Everything that must not depend on the machine or the day, as text.
std::string content(const std::string& file) {
  Database database(file, Database::Mode::read_only);
  std::string text;
  for (const char* sql :
       {"SELECT p.code, s.seed, s.sequence, s.outcome FROM session s JOIN participant p ON "
        "p.uuid = s.participant ORDER BY 1",
        "SELECT t_us, kind, target, value, detail FROM event e JOIN session s ON s.uuid = "
        "e.session JOIN participant p ON p.uuid = s.participant ORDER BY p.code, seq",
        "SELECT hex(weights), d FROM sample x JOIN trial t ON t.uuid = x.trial JOIN session s ON "
        "s.uuid = t.session JOIN participant p ON p.uuid = s.participant ORDER BY p.code, "
        "x.rowid"}) {
    Statement rows(database, sql);
    while (rows.step()) {
      for (int c = 0; c < rows.columns(); ++c) text += rows.text(c) + "|";
    }
  }
  return text;
}

// Simulates into a fresh file and returns its content.
std::string simulated(int participants, std::uint64_t seed, int jobs, int times = 1) {
  const fs::path file =
      fs::temp_directory_path() / ("promenade_simulate_" + std::to_string(::getpid()) + ".db");
  const StudyBundle bundle = toy::bundle();
  for (int i = 0; i < times; ++i) {
    Store store(file, bundle);
    Cohort cohort;
    cohort.participants = participants / times;
    cohort.seed = seed;
    cohort.jobs = jobs;
    EXPECT_EQ(simulate_cohort(bundle, toy::registry(), store, cohort), participants / times);
  }
  std::string text = content(file.string());
  fs::remove(file);
  return text;
}

TEST(SimulateCohort, DependsOnTheSeedAloneAndNotOnThreads) {
  const std::string one = simulated(7, 5, 1);
  EXPECT_EQ(one, simulated(7, 5, 3));
  EXPECT_NE(one, simulated(7, 6, 1));
}

TEST(SimulateCohort, GoesOnWithTheNumbersThatAreThere) {
  EXPECT_EQ(simulated(6, 5, 2), simulated(6, 5, 2, 2));
}

TEST(SimulateCohort, SharesAFileWithAnotherCohort) {
  const fs::path file =
      fs::temp_directory_path() / ("promenade_share_" + std::to_string(::getpid()) + ".db");
  const StudyBundle bundle = toy::bundle();
  const auto simulate = [&](std::uint64_t seed) {
    Store store(file, bundle);
    Cohort cohort;
    cohort.participants = 20;
    cohort.seed = seed;
    return simulate_cohort(bundle, toy::registry(), store, cohort);
  };
  auto other = std::async(std::launch::async, simulate, 1);
  EXPECT_EQ(simulate(2), 20);
  EXPECT_EQ(other.get(), 20);
  {
    Database database(file.string(), Database::Mode::read_only);
    Statement rows(database,
                   "SELECT count(*), count(DISTINCT participant), count(DISTINCT sequence), "
                   "max(sequence) FROM session WHERE outcome = 'finished'");
    ASSERT_TRUE(rows.step());
    for (const int column : {0, 1, 2}) EXPECT_EQ(rows.integer(column), 40) << column;
    EXPECT_EQ(rows.integer(3), 39);
  }
  fs::remove(file);
}

// Outcomes of the trials that count, over a cohort.
std::map<TrialOutcome, int> outcomes(const StudyBundle& bundle, int people, TaskKind kind) {
  std::map<TrialOutcome, int> count;
  for (int i = 0; i < people; ++i) {
    const Plan plan = make_plan(bundle.study, i);
    const auto seed = static_cast<std::uint64_t>(i);
    for (const Record& record : simulate_session(bundle, toy::registry(), plan, seed)) {
      const TrialEnded* ended = std::get_if<TrialEnded>(&record);
      if (!ended) continue;
      const PlannedTrial& trial = plan.trials[static_cast<std::size_t>(ended->trial)];
      const bool counts = !trial.practice && task_of(bundle.study, trial).kind == kind;
      if (counts) ++count[ended->outcome];
    }
  }
  return count;
}

TEST(SimulateSession, EndsWithEveryTrialDoneAndEveryRatingGiven) {
  const StudyBundle bundle = toy::bundle();
  const Plan plan = make_plan(bundle.study, 0);
  int trials = 0;
  int answers = 0;
  const std::vector<Record> records = simulate_session(bundle, toy::registry(), plan, 3);
  for (const Record& record : records) {
    trials += std::holds_alternative<TrialEnded>(record);
    answers += std::holds_alternative<Answer>(record);
  }
  EXPECT_EQ(trials, static_cast<int>(plan.trials.size()));
  EXPECT_EQ(answers, 4);
  EXPECT_EQ(std::get<SessionEnded>(records.back()).outcome, Outcome::finished);
}

TEST(SimulateSession, MostlySucceedsAndSometimesFails) {
  std::string text = toy::study_text();
  text.replace(text.find("\"auto\""), 6, "0.01");
  std::map<TrialOutcome, int> count = outcomes(toy::bundle(text), 40, TaskKind::match);
  EXPECT_GT(count[TrialOutcome::success], 40);  // of 80
  EXPECT_GT(count[TrialOutcome::timeout] + count[TrialOutcome::done], 0);
}

TEST(SimulateSession, EndsFindTasksByDone) {
  std::map<TrialOutcome, int> count = outcomes(toy::bundle(), 10, TaskKind::find);
  EXPECT_EQ(count[TrialOutcome::done], 20);
}

TEST(SimulateSession, ClicksForEveryChange) {
  const StudyBundle bundle = toy::bundle();
  int changes = 0;
  for (const Record& record :
       simulate_session(bundle, toy::registry(), make_plan(bundle.study, 1), 9)) {
    const TrialEnded* ended = std::get_if<TrialEnded>(&record);
    if (!ended) continue;
    EXPECT_GE(ended->clicks, ended->changes);
    changes += ended->changes;
  }
  EXPECT_GT(changes, 0);
}

TEST(DrawPerson, GivesDifferentPeopleWithinReason) {
  Rng rng(1, 0, "test");
  const Person one = draw_person(rng);
  const Person two = draw_person(rng);
  EXPECT_NE(one.patience_s, two.patience_s);
  for (const Person& person : {one, two}) {
    EXPECT_GT(person.think_s, 0);
    EXPECT_GE(person.ideas, 3);
  }
}

}  // namespace
}  // namespace promenade::study
