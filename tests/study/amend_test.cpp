#include "study/amend.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "play.h"
#include "study/identity.h"
#include "study/sqlite.h"
#include "study/store.h"
#include "study/stored_study.h"
#include "study/versions.h"
#include "toy.h"

namespace promenade::study {
namespace {

namespace fs = std::filesystem;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

// The toy study with a longer limit; its orders stay.
StudyBundle longer(const std::string& limit = "60") {
  return toy::bundle(replaced(toy::study_text(), "limit_s = 45", "limit_s = " + limit));
}

// The toy study with its interfaces the other way round: its orders are others.
StudyBundle turned() {
  return toy::bundle(replaced(toy::study_text(), "name = \"pick\"\n[[interface]]\nname = \"mix\"",
                              "name = \"mix\"\n[[interface]]\nname = \"pick\""));
}

class AmendTest : public testing::Test {
 protected:
  AmendTest() { fs::remove_all(folder_), fs::create_directories(folder_); }
  ~AmendTest() override { fs::remove_all(folder_); }
  std::string file() const { return (folder_ / "toy.db").string(); }

  Amended amend(const StudyBundle& changed, const std::string& reason = "too short") const {
    return amend_study(file(), changed, toy::registry(), reason);
  }

  // What is said instead; empty: it was amended.
  std::string refusal(const StudyBundle& changed, const std::string& reason = "too short") const {
    try {
      amend(changed, reason);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  std::string refusal_to_run(const StudyBundle& bundle) const {
    try {
      Store store(file(), bundle);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  std::vector<StudyVersion> versions() const {
    Database database(file(), Database::Mode::read_only);
    return study_versions(database);
  }

  void finish_session(const StudyBundle& bundle, const std::string& code) const {
    Store store(file(), bundle);
    toy::Player player(bundle, store.next_sequence(false, false));
    player.whole_session();
    store.begin_session(header(code), player.session.plan());
    store.write(player.records);
    store.end_session("2026-11-22T17:00:00Z");
  }

  static SessionHeader header(const std::string& code) {
    SessionHeader header;
    header.participant = code;
    header.started_utc = "2026-11-22T16:00:00Z";
    return header;
  }

  int next_sequence(const StudyBundle& bundle) const {
    return Store(file(), bundle).next_sequence(false, false);
  }

  const StudyBundle study_ = toy::bundle();
  fs::path folder_ =
      fs::temp_directory_path() / ("promenade_amend_" + std::to_string(::getpid()) + "_" +
                                   testing::UnitTest::GetInstance()->current_test_info()->name());
};

bool says(const std::string& message, const std::string& part) {
  return message.find(part) != std::string::npos;
}

TEST_F(AmendTest, KeepsEveryVersionWithItsReasonAndDate) {
  { Store store(file(), study_); }
  amend(longer(), "the limit was too short");
  amend(turned(), "the list came first too often");
  const std::vector<StudyVersion> all = versions();
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].sha256, study_.sha256);
  EXPECT_EQ(all[0].reason, "");
  EXPECT_EQ(all[1].reason, "the limit was too short");
  EXPECT_EQ(all[1].previous, all[0].uuid);
  EXPECT_EQ(all[2].sha256, turned().sha256);
  EXPECT_EQ(all[2].previous, all[1].uuid);
  EXPECT_EQ(all[2].amended_utc.size(), utc_now().size());
}

TEST_F(AmendTest, LeavesEverySessionTheVersionThatItWasOf) {
  finish_session(study_, "P01");
  amend(longer());
  finish_session(longer(), "P02");
  Database database(file(), Database::Mode::read_only);
  Statement row(database,
                "SELECT code, study_sha256, limit_s FROM session "
                "JOIN participant ON participant.uuid = session.participant "
                "JOIN study ON study.uuid = session.study JOIN trial ON trial.session = "
                "session.uuid WHERE task = 'copy' GROUP BY code ORDER BY code");
  ASSERT_TRUE(row.step());
  EXPECT_EQ(row.text(1), study_.sha256);
  EXPECT_EQ(row.real(2), 45);
  ASSERT_TRUE(row.step());
  EXPECT_EQ(row.text(1), longer().sha256);
  EXPECT_EQ(row.real(2), 60);
}

TEST_F(AmendTest, KeepsEveryVersionWhole) {
  { Store store(file(), study_); }
  amend(longer());
  Database database(file(), Database::Mode::read_only);
  for (const StudyVersion& version : versions()) {
    const StudyBundle stored = read_stored_study(database, version.uuid, toy::registry());
    EXPECT_EQ(stored.config_text, version.config_text);
    EXPECT_EQ(stored.sha256, version.sha256);
    EXPECT_EQ(stored.parts.size(), 1U);
  }
}

TEST_F(AmendTest, LetsOnlyTheNewestVersionRunAndNamesReasonAndDate) {
  { Store store(file(), study_); }
  EXPECT_TRUE(says(refusal_to_run(longer()), "`promenade amend`"));
  amend(longer());
  EXPECT_EQ(refusal_to_run(longer()), "");
  const std::string message = refusal_to_run(study_);
  EXPECT_TRUE(says(message, "since " + versions()[1].amended_utc + " (too short)")) << message;
}

TEST_F(AmendTest, RefusesWhatIsNoChangeOfThisStudy) {
  EXPECT_TRUE(says(refusal(longer()), "does not exist"));
  { Store store(file(), study_); }
  EXPECT_TRUE(says(refusal(longer(), " \n"), "say why"));
  EXPECT_TRUE(says(refusal(longer(), std::string(2001, 'x')), "2000 characters"));
  EXPECT_TRUE(says(refusal(study_), "is already the study in"));
  const StudyBundle other = toy::bundle(replaced(toy::study_text(), "\"toy\"", "\"toys\""));
  EXPECT_TRUE(says(refusal(other), "holds another study, \"toy\""));
  EXPECT_EQ(versions().size(), 1U);
}

TEST_F(AmendTest, GoesBackOnlyUnderAnotherVersion) {
  { Store store(file(), study_); }
  amend(longer());
  EXPECT_TRUE(says(refusal(study_), "give it another \"version\""));
  amend(toy::bundle(replaced(toy::study_text(), "seed", "version = \"3\"\nseed")));
  EXPECT_EQ(versions().back().version, "3");
}

TEST_F(AmendTest, WaitsForASessionThatRuns) {
  Store store(file(), study_);
  store.begin_session(header("P01"), make_plan(study_.study, 0));
  EXPECT_THROW(amend(longer()), OutsideError);
  EXPECT_EQ(versions().size(), 1U);
}

TEST_F(AmendTest, CountsSessionsThatCanNoLongerBeResumed) {
  { Store store(file(), study_); }
  const pid_t child = ::fork();
  if (child == 0) {
    Store store(file(), study_);
    store.begin_session(header("P01"), make_plan(study_.study, 0));
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(amend(longer()).interrupted, 1);
  EXPECT_EQ(amend(longer("70")).interrupted, 0) << "it is of an older version";
}

TEST_F(AmendTest, StopsAStoreThatWasOpenedBefore) {
  Store store(file(), study_);
  amend(longer());
  EXPECT_THROW(store.begin_session(header("P01"), make_plan(study_.study, 0)), OutsideError);
}

TEST_F(AmendTest, LetsThoseCountWhoFinishedTheSameOrders) {
  finish_session(study_, "P01");
  finish_session(study_, "P02");
  EXPECT_TRUE(amend(longer()).same_orders);
  EXPECT_EQ(next_sequence(longer()), 2);
  finish_session(longer(), "P03");
  EXPECT_TRUE(amend(longer("70")).same_orders);
  EXPECT_EQ(next_sequence(longer("70")), 3);
}

TEST_F(AmendTest, BeginsTheBalanceAnewWithOtherOrders) {
  finish_session(study_, "P01");
  EXPECT_FALSE(amend(turned()).same_orders);
  EXPECT_EQ(next_sequence(turned()), 0);
  finish_session(turned(), "P02");
  EXPECT_EQ(next_sequence(turned()), 1);
}

TEST(SameOrders, AreThoseOfTheSameInterfacesInTheSameDesign) {
  const Study study = toy::bundle().study;
  EXPECT_TRUE(same_orders(study, longer().study));
  EXPECT_FALSE(same_orders(study, turned().study));
  Study other = study;
  other.order = Order::latin;
  EXPECT_FALSE(same_orders(study, other));
  other = study;
  other.interfaces.pop_back();
  EXPECT_FALSE(same_orders(study, other));
}

TEST(SameOrders, FollowFromTheSeedOnlyWhereTheyAreDrawn) {
  Study study = toy::bundle().study;
  Study other = study;
  other.seed = study.seed + 1;
  EXPECT_TRUE(same_orders(study, other));
  study.order = other.order = Order::random;
  EXPECT_FALSE(same_orders(study, other));
}

}  // namespace
}  // namespace promenade::study
