#include "study/trial_list.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "study/simulate.h"
#include "study/sqlite.h"
#include "study/store.h"
#include "toy.h"

namespace promenade::study {
namespace {

class TrialListTest : public testing::Test {
 protected:
  TrialListTest() {
    Store store(file_, bundle_);
    Cohort cohort;
    cohort.participants = 2;
    simulate_cohort(bundle_, toy::registry(), store, cohort);
  }
  ~TrialListTest() override {
    for (const char* end : {"", "-wal", "-shm"}) std::filesystem::remove(file_ + end);
  }
  void change(const std::string& sql) const {
    Database(file_, Database::Mode::read_write).exec(sql);
  }
  std::vector<ListedTrial> list() const {
    Database database(file_, Database::Mode::read_only);
    return list_trials(database);
  }
  ListedTrial choose(const std::string& uuid) const {
    Database database(file_, Database::Mode::read_only);
    return choose_trial(database, uuid);
  }

  StudyBundle bundle_ = toy::bundle();
  std::string file_ = (std::filesystem::temp_directory_path() /
                       ("promenade_trials_" + std::to_string(::getpid()) + ".db"))
                          .string();
};

TEST_F(TrialListTest, HasEveryTrialWithItsTimeAndD) {
  const std::vector<ListedTrial> trials = list();
  ASSERT_EQ(trials.size(), 12U);
  EXPECT_EQ(trials.front().participant, "S001");
  EXPECT_EQ(trials.front().position, 1);
  EXPECT_TRUE(trials.front().simulated);
  for (const ListedTrial& trial : trials) EXPECT_GT(trial.seconds.value_or(0), 0);
}

TEST_F(TrialListTest, ATrialIsChosenByItsUuid) {
  const ListedTrial third = list()[2];
  EXPECT_EQ(choose(third.uuid).position, third.position);
  EXPECT_EQ(choose(third.uuid).session, third.session);
}

TEST_F(TrialListTest, WithoutAUuidItIsTheOneThatEndedLast) {
  change("UPDATE session SET started_utc = '2026-01-01T10:00:00Z'");
  change("UPDATE trial SET ended_us = 1 + ended_us % 1000");
  const std::string wanted = list()[4].uuid;
  change("UPDATE trial SET ended_us = 9000000 WHERE uuid = '" + wanted + "'");
  EXPECT_EQ(choose("").uuid, wanted);
}

TEST_F(TrialListTest, SaysHowToFindTheTrialsThatThereAre) {
  try {
    choose("nobody");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("has no trial nobody; `promenade replay"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(TrialListTest, ATrialThatHasNotEndedIsListedAndOnlyPlayedByItsUuid) {
  change("UPDATE trial SET outcome = NULL, ended_us = NULL");
  EXPECT_FALSE(list().front().seconds);
  EXPECT_THROW(choose(""), InputError);
  EXPECT_EQ(choose(list().front().uuid).uuid, list().front().uuid);
}

}  // namespace
}  // namespace promenade::study
