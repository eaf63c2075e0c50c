// A stimulus in a session: what is shown when, what is stored of it, and what simulated people
// think of it.
#include "study/stimulus.h"

#include <gtest/gtest.h>

#include "folder.h"
#include "play.h"
#include "study/impressions.h"
#include "study/ratings.h"
#include "study/replay.h"
#include "study/simulate.h"
#include "study/store.h"
#include "toy_stimuli.h"

namespace promenade::study {
namespace {

// Two seconds at ten frames a second.
Stimulus two_seconds() {
  Stimulus stimulus;
  stimulus.take = motion::toy_take("a", 21);
  return stimulus;
}

TEST(Stimulus, StandsHalfASecondAtItsEndAndBeginsAgain) {
  const Stimulus stimulus = two_seconds();
  EXPECT_EQ(moment_of(stimulus, -1).seconds, 0);
  EXPECT_EQ(moment_of(stimulus, 1.25).seconds, 1.25);
  EXPECT_DOUBLE_EQ(moment_of(stimulus, 2.4).seconds, 2);
  EXPECT_EQ(moment_of(stimulus, 2.4).round, 0);
  EXPECT_DOUBLE_EQ(moment_of(stimulus, 3).seconds, 0.5);
  EXPECT_EQ(moment_of(stimulus, 3).round, 1);
}

// In the trial of the stimulus, whichever comes first.
struct Shown {
  Shown() {
    for (std::int64_t t = 1'000'000; !on_stimulus(); t += 1'000'000) {
      player.session.trial() ? rate(t) : void(player.at(t, Continue{}));
    }
    began_us = player.session.trial()->started_us;
  }
  bool on_stimulus() const {
    return player.session.trial() && player.session.trial()->stimulus != nullptr;
  }
  void rate(std::int64_t t_us) {
    for (const Item& item : player.session.questions()->items) {
      player.at(t_us, SetAnswer{item.name, 0});
    }
    player.at(t_us, Done{});
  }
  double seconds_at(std::int64_t later_us) const {
    return player.session.trial()->showing.seconds(player.session.trial_us(began_us + later_us));
  }

  StudyBundle bundle = toy::stimulus_bundle();
  toy::Player player{bundle};
  std::int64_t began_us = 0;
};

TEST(StimulusTrial, PlaysInTheTimeOfTheSession) {
  const Shown shown;
  EXPECT_EQ(shown.seconds_at(0), 0);
  EXPECT_DOUBLE_EQ(shown.seconds_at(1'500'000), 1.5);
}

TEST(StimulusTrial, CanBePausedSlowedDownAndScrubbed) {
  Shown shown;
  const std::int64_t began = shown.began_us;
  shown.player.at(began + 1'000'000, Playback{.playing = false, .speed = 1});
  EXPECT_DOUBLE_EQ(shown.seconds_at(3'000'000), 1);
  shown.player.at(began + 3'000'000, Playback{.playing = true, .speed = 0.5});
  EXPECT_DOUBLE_EQ(shown.seconds_at(5'000'000), 2);
  shown.player.at(began + 5'000'000, Playback{.playing = false, .speed = 0.5, .phase = 0.25});
  EXPECT_DOUBLE_EQ(shown.seconds_at(9'000'000),
                   0.25 * shown.player.session.trial()->stimulus->seconds());
}

TEST(StimulusTrial, StandsWhileTheSessionIsPaused) {
  Shown shown;
  const std::int64_t began = shown.began_us;
  shown.player.at(began + 1'000'000, Pause{});
  EXPECT_DOUBLE_EQ(shown.seconds_at(3'000'000), 1);
  shown.player.at(began + 4'000'000, Resume{});
  EXPECT_DOUBLE_EQ(shown.seconds_at(4'500'000), 1.5);
}

TEST(StimulusTrial, StoresWhichWalkWasShownAndNoWeights) {
  Shown shown;
  shown.player.at(shown.began_us + 1'000'000, StartOver{});
  for (const Sample& sample : shown.player.all<Sample>()) {
    EXPECT_NE(sample.trial, shown.player.session.trial()->index);
  }
  const Event start = shown.player.all<Event>().back();
  const auto events = shown.player.all<Event>();
  const auto begun = std::count_if(events.begin(), events.end(), [](const Event& event) {
    return event.kind == "start" && event.detail.starts_with(R"({"stimulus":{"seconds":)");
  });
  EXPECT_EQ(begun, 1);
}

TEST(SimulatedPeople, FeelAStimulusAsTheWalksOfItsLabels) {
  const StudyBundle bundle = toy::stimulus_bundle();
  Stimulus stimulus = *bundle.study.stimuli[0];
  const Eigen::MatrixXd& felt = bundle.impressions->of(bundle.space.set, "");
  stimulus.labels = {{0, 30, "near"}, {30, 40, "far"}};
  const Eigen::VectorXd wanted = 0.75 * felt.col(0) + 0.25 * felt.col(2);
  EXPECT_LT((felt_of(stimulus, bundle) - wanted).cwiseAbs().maxCoeff(), 1e-12);
  stimulus.labels = {{0, 30, "near"}, {30, 60, "nobody knows"}};
  EXPECT_LT((felt_of(stimulus, bundle) - 0.5 * felt.col(0)).cwiseAbs().maxCoeff(), 1e-12);
}

class StimulusCohort : public FolderTest {
 protected:
  void SetUp() override {
    Store store(file(), bundle_);
    Cohort cohort;
    cohort.participants = 3;
    simulate_cohort(bundle_, toy::registry(), store, cohort);
  }
  Audit audited() const {
    Database database(file(), Database::Mode::read_only);
    Audit result;
    for (const std::string& uuid : session_uuids(database)) {
      audit(bundle_, toy::registry(), read_session(database, uuid), result);
    }
    return result;
  }
  StudyBundle bundle_ = toy::stimulus_bundle();
};

TEST_F(StimulusCohort, IsReplayedAsItWas) {
  const Audit audit = audited();
  EXPECT_EQ(audit.sessions, 3);
  EXPECT_GE(audit.trials, 6);
  EXPECT_TRUE(audit.differences.empty()) << audit.differences[0].what;
}

TEST_F(StimulusCohort, IsFoundOutWhereAnotherWalkWasShown) {
  Database database(file(), Database::Mode::read_write);
  database.exec(
      "UPDATE event SET detail = replace(detail, '\"edges\":[', '\"edges\":[99,') WHERE kind = "
      "'start'");
  const Audit audit = audited();
  ASSERT_FALSE(audit.differences.empty());
  EXPECT_EQ(audit.differences[0].what, "what was shown");
}

TEST_F(StimulusCohort, HasItsRatingsApartFromThoseOfTheSet) {
  const RatingSelection selection{.include_simulated = true, .instrument = "impression"};
  const DatabaseRatings found = read_database_ratings(file(), selection);
  EXPECT_EQ(found.stimuli, std::vector<std::string>{"near_then_far"});
  EXPECT_EQ(found.table.motions, motion::names_of(bundle_.space.set));
  const std::vector<NamedRating> stimuli = read_stimulus_ratings(file(), selection);
  ASSERT_EQ(stimuli.size(), 3U * 4U);
  for (const NamedRating& one : stimuli) EXPECT_EQ(one.motion, "near_then_far");
}

}  // namespace
}  // namespace promenade::study
