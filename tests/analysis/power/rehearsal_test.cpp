#include "analysis/power/rehearsal.h"

#include <gtest/gtest.h>

#include "motion/problem.h"
#include "toy.h"

namespace promenade::analysis {
namespace {

Rehearsal rehearsal_of(const study::StudyBundle& bundle) {
  return {&bundle, &study::toy::registry(), {}, {}, {}};
}

using Rows = std::vector<std::vector<std::optional<double>>>;

// Of each person; the order of the trials goes by random identities.
Rows values_of(const Dataset& data) {
  Rows rows;
  for (int task = 0; task < static_cast<int>(data.tasks.size()); ++task) {
    for (int measure = 0; measure < static_cast<int>(data.measures.size()); ++measure) {
      for (const int interface : {0, 1}) {
        rows.push_back(mean_per_person(data, measure, interface, task));
      }
    }
  }
  return rows;
}

TEST(Rehearse, GivesFewerPeopleAsTheFirstOfMore) {
  const study::StudyBundle bundle = study::toy::bundle();
  const Rehearsal rehearsal = rehearsal_of(bundle);
  const Dataset six = rehearse(rehearsal, 6, 3, 0);
  const Dataset four = rehearse(rehearsal, 4, 3, 0);
  EXPECT_EQ(six.people.size(), 6U);
  EXPECT_TRUE(six.all_simulated);
  EXPECT_EQ(values_of(first_people(six, 4)), values_of(four));
  EXPECT_NE(values_of(rehearse(rehearsal, 4, 3, 1)), values_of(four));
}

TEST(RehearsedPower, DoesNotDependOnThreads) {
  const study::StudyBundle bundle = study::toy::bundle();
  PowerQuestion question;
  question.participants = {6, 8};
  question.studies = 12;
  std::vector<int> found[2];
  for (const int threads : {1, 3}) {
    question.threads = threads;
    for (const PowerTable& table : rehearsed_power(rehearsal_of(bundle), question)) {
      for (const PowerRow& row : table.rows) found[threads / 2].push_back(row.alone.found);
    }
  }
  EXPECT_FALSE(found[0].empty());
  EXPECT_EQ(found[0], found[1]);
}

TEST(RehearsedPower, FindsThatOneInterfaceIsLiked) {
  const study::StudyBundle bundle = study::toy::bundle();
  Rehearsal rehearsal = rehearsal_of(bundle);
  rehearsal.measures = {"liked"};
  rehearsal.tendencies.preference = {{"pick", 0.5}, {"mix", -0.5}};
  PowerQuestion question;
  question.participants = {12};
  question.studies = 20;
  const auto tables = rehearsed_power(rehearsal, question);
  ASSERT_FALSE(tables.empty());
  for (const PowerTable& table : tables) {
    EXPECT_EQ(table.rows[0].holm.found, 20) << table.task;
    EXPECT_EQ(table.any[0].second.found, 20);
    EXPECT_GT(table.rows[0].hl.value(), 0);
  }
}

TEST(RehearsedPower, NamesWhatTheStudyHasNot) {
  const study::StudyBundle bundle = study::toy::bundle();
  Rehearsal rehearsal = rehearsal_of(bundle);
  PowerQuestion question;
  question.participants = {4};
  rehearsal.tasks = {"dance"};
  EXPECT_THROW(rehearsed_power(rehearsal, question), InputError);
  rehearsal.tasks = {};
  rehearsal.measures = {"beauty"};
  EXPECT_THROW(rehearsed_power(rehearsal, question), InputError);
}

}  // namespace
}  // namespace promenade::analysis
