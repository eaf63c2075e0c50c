// What leaves the planned order: guesses, practice to a criterion, skips, repeats, resumes.
#include <gtest/gtest.h>

#include <set>

#include "play.h"
#include "toy.h"

namespace promenade::study {
namespace {

using toy::Player;

constexpr std::int64_t second = 1'000'000;

const std::string head = "[study]\nname = 'flow'\n[[interface]]\nname = 'pick'\n";
const std::string copy =
    "[[task]]\nname = 'copy'\nkind = 'match'\ntargets = [{example = 'far'}, {example = "
    "'side'}]\nthreshold = 'auto'\n";
const std::string guess_and_match =
    "[[task]]\nname = 'first'\nkind = 'guess'\ntargets = [{example = 'far'}]\nthreshold = 0.1\n"
    "[[task]]\nname = 'then'\nkind = 'match'\nstart = 'first'\nthreshold = 0.1\ndone = false\n"
    "limit_s = 300\n";

const char* kind_of(const Player& player) { return to_text(player.session.page().kind).data(); }

int count_events(const Player& player, const std::string& kind) {
  int count = 0;
  for (const Event& event : player.all<Event>()) count += event.kind == kind ? 1 : 0;
  return count;
}

TEST(Guess, IsBlindAndNamesWhatTheNextTaskBeginsFrom) {
  const StudyBundle bundle = toy::bundle(head + guess_and_match);
  EXPECT_TRUE(bundle.study.tasks[0].blind);
  EXPECT_EQ(bundle.study.tasks[1].start_guess, 0);
  EXPECT_EQ(bundle.study.tasks[1].targets.size(), 1U);
}

TEST(Guess, ThatMissesIsWhereTheMatchBegins) {
  const StudyBundle bundle = toy::bundle(head + guess_and_match);
  Player player(bundle);
  player.to_trial(0);
  player.at(1 * second, toy::pick("side"));
  const double guessed = *player.session.trial()->d;
  player.at(2 * second, Done{});
  player.to_trial(3 * second);
  ASSERT_NE(player.session.trial(), nullptr);
  EXPECT_EQ(*player.all<TrialStarted>().at(1).d_first, guessed);
  EXPECT_EQ(player.session.trial()->weights(1), 1);
  player.at(4 * second, Done{});  // there is no Done
  ASSERT_NE(player.session.trial(), nullptr);
  player.at(304 * second, Tick{});
  EXPECT_EQ(player.all<TrialEnded>().at(1).outcome, TrialOutcome::timeout);
}

TEST(Guess, ThatHitsMakesTheMatchASuccessAtOnceWithoutItsPages) {
  const StudyBundle bundle = toy::bundle(head + guess_and_match);
  Player player(bundle);
  player.to_trial(0);
  player.at(1 * second, toy::pick("far"));
  player.at(2 * second, Done{});
  EXPECT_STREQ(kind_of(player), "thanks");
  const TrialEnded won = player.all<TrialEnded>().at(1);
  EXPECT_EQ(won.outcome, TrialOutcome::success);
  EXPECT_EQ(won.t_us, player.all<TrialStarted>().at(1).t_us);
  EXPECT_EQ(count_events(player, "won_by_guess"), 1);
}

TEST(Guess, StartOverGoesBackToTheGuessAndNotToTheAverage) {
  const StudyBundle bundle = toy::bundle(head + guess_and_match);
  Player player(bundle);
  player.to_trial(0);
  player.at(1 * second, toy::pick("side"));
  player.at(2 * second, Done{});
  player.to_trial(3 * second);
  player.at(4 * second, toy::pick("near"));
  player.at(5 * second, StartOver{});
  EXPECT_EQ(player.session.trial()->weights(1), 1);
}

TEST(Success, AndTimeoutAreEventsOfTheSystem) {
  const StudyBundle bundle = toy::bundle(head + copy + "limit_s = 20\n");
  Player player(bundle);
  player.to_trial(0);
  const int target = player.session.plan().trials[0].target;
  player.at(1 * second, toy::pick(target == 0 ? "far" : "side"));
  player.at(9 * second, Tick{});
  player.to_trial(10 * second);
  player.at(99 * second, Tick{});
  std::vector<Event> found;
  for (const Event& event : player.all<Event>()) {
    if (event.kind == "won" || event.kind == "timeout") found.push_back(event);
  }
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].t_us, 1 * second + 500'000);
  EXPECT_EQ(found[1].t_us, 30 * second);
  EXPECT_EQ(found[0].actor, Actor::system);
}

// Practice of one trial with 'far', until it is a success.
std::string until_criterion(int most_rounds) {
  return head + copy + "practice = [{example = 'far'}]\n[practice]\nuntil = 'criterion'\n" +
         "most_rounds = " + std::to_string(most_rounds) + "\n";
}

TEST(Practice, IsRepeatedUntilItIsGoodEnough) {
  const StudyBundle bundle = toy::bundle(until_criterion(5));
  Player player(bundle);
  player.to_trial(0);
  player.at(1 * second, Done{});
  EXPECT_STREQ(kind_of(player), "instructions");
  EXPECT_EQ(player.all<TrialSuperseded>().size(), 1U);
  player.to_trial(2 * second);
  EXPECT_EQ(player.all<TrialStarted>().back().attempt, 2);
  player.at(3 * second, toy::pick("far"));
  player.at(9 * second, Tick{});
  player.to_trial(10 * second);
  EXPECT_FALSE(player.session.plan().trials[1].practice);
  EXPECT_EQ(player.session.trial()->index, 1);
  EXPECT_EQ(count_events(player, "practice_over"), 1);
}

TEST(Practice, IsOverAfterTheMostRounds) {
  const StudyBundle bundle = toy::bundle(until_criterion(2));
  Player player(bundle);
  for (std::int64_t t = 1; t < 5; ++t) {
    player.to_trial(t * second);
    if (player.session.trial()->index > 0) break;
    player.at(t * second, Done{});
  }
  EXPECT_EQ(player.session.trial()->index, 1);
  EXPECT_EQ(player.all<TrialStarted>().size(), 3U);
}

TEST(Practice, WaitsForTheExperimenter) {
  const StudyBundle bundle = toy::bundle(head + copy +
                                         "practice = [{example = 'far'}]\n[practice]\nuntil = "
                                         "'released'\n");
  Player player(bundle);
  player.to_trial(0);
  player.at(1 * second, Done{});
  EXPECT_STREQ(kind_of(player), "release");
  player.at(2 * second, Continue{});
  EXPECT_STREQ(kind_of(player), "release");
  player.at(3 * second, Release{});
  EXPECT_STREQ(kind_of(player), "intro");
}

TEST(Skip, LeavesOutTheTrialAndTheQuestionsAboutIt) {
  const StudyBundle bundle =
      toy::bundle(head + copy + "[[rating]]\nitem = 'liked'\nquestion = 'Well?'\n");
  Player player(bundle);
  player.to_trial(0);
  player.at(1 * second, Skip{"the fire alarm"});
  EXPECT_STREQ(kind_of(player), "intro");
  EXPECT_EQ(player.all<TrialEnded>().at(0).outcome, TrialOutcome::skipped);
  EXPECT_TRUE(player.all<Answer>().empty());
  player.at(2 * second, Skip{"again"});  // before it has begun
  EXPECT_STREQ(kind_of(player), "thanks");
  EXPECT_EQ(player.all<TrialStarted>().size(), 2U);
  EXPECT_EQ(player.all<TrialEnded>().at(1).outcome, TrialOutcome::skipped);
}

TEST(Repeat, BeginsTheTrialAnewAndTheOldOneDoesNotCount) {
  const StudyBundle bundle = toy::bundle(head + copy);
  Player player(bundle);
  player.to_trial(0);
  player.at(1 * second, Repeat{false, "somebody came in"});
  EXPECT_STREQ(kind_of(player), "instructions");
  EXPECT_EQ(player.all<TrialEnded>().at(0).outcome, TrialOutcome::aborted);
  EXPECT_EQ(player.all<TrialSuperseded>().at(0).trial, 0);
  player.to_trial(2 * second);
  EXPECT_EQ(player.all<TrialStarted>().at(1).attempt, 2);
}

TEST(Repeat, OfABlockBeginsWithItsFirstTrial) {
  const StudyBundle bundle = toy::bundle(head + copy);
  Player player(bundle);
  player.to_trial(0);
  player.at(1 * second, Done{});
  player.to_trial(2 * second);
  player.at(3 * second, Repeat{true, "wrong glasses"});
  EXPECT_EQ(player.all<TrialSuperseded>().size(), 2U);
  player.to_trial(4 * second);
  EXPECT_EQ(player.session.trial()->index, 0);
}

// Two guesses, then their matches; both guesses hit.
Player two_won_matches(const StudyBundle& bundle) {
  Player player(bundle);
  for (std::int64_t t = 1; player.session.page().kind != PageKind::thanks; t += 2) {
    if (!player.session.trial()) player.to_trial(t * second);
    const auto index = static_cast<std::size_t>(player.session.trial()->index);
    player.at(t * second,
              toy::pick(player.session.plan().trials[index].target == 0 ? "far" : "side"));
    player.at((t + 1) * second, Done{});
  }
  return player;
}

const std::string two_guesses =
    "[[task]]\nname = 'first'\nkind = 'guess'\ntargets = [{example = 'far'}, {example = 'side'}]\n"
    "threshold = 0.1\n"
    "[[task]]\nname = 'then'\nkind = 'match'\nstart = 'first'\nthreshold = 0.1\ndone = false\n"
    "limit_s = 300\n";

TEST(Repeat, OfAMatchThatItsGuessHasWonIsAnotherGuess) {
  const StudyBundle bundle = toy::bundle(head + two_guesses);
  Player player = two_won_matches(bundle);
  ASSERT_STREQ(kind_of(player), "thanks");
  const std::vector<PlannedTrial>& trials = player.session.plan().trials;
  const int guess = trials[0].target == trials[3].target ? 0 : 1;
  player.at(20 * second, Repeat{false, "a child at the mouse"});
  EXPECT_EQ(player.all<Event>().at(player.all<Event>().size() - 2).target, "guess");
  EXPECT_EQ(player.session.page().trial, guess);
  ASSERT_EQ(player.all<TrialSuperseded>().size(), 2U);
  player.to_trial(21 * second);
  player.at(22 * second, toy::pick("near"));
  player.at(23 * second, Done{});
  EXPECT_EQ(player.session.page().trial, 3) << "what stands between is left as it is";
  player.to_trial(24 * second);
  ASSERT_NE(player.session.trial(), nullptr);
  EXPECT_EQ(player.session.trial()->weights(0), 1);
  EXPECT_EQ(player.all<TrialStarted>().size(), 6U);
}

TEST(Repeat, OfAMatchAsAnOldLogHasItStaysWithTheMatch) {
  const StudyBundle bundle = toy::bundle(head + guess_and_match);
  Player player(bundle);
  player.to_trial(0);
  player.at(1 * second, toy::pick("far"));
  player.at(2 * second, Done{});
  player.at(3 * second, Repeat{false, "why", false});
  EXPECT_EQ(player.all<TrialSuperseded>().size(), 1U);
  EXPECT_EQ(count_events(player, "won_by_guess"), 2);
}

TEST(Repeat, OfTheBlockWhileAGuessIsDoneAgainTakesInItsMatch) {
  const StudyBundle bundle = toy::bundle(head + two_guesses);
  Player player = two_won_matches(bundle);
  player.at(20 * second, Repeat{false, "a child at the mouse"});
  player.to_trial(21 * second);
  player.at(22 * second, Repeat{true, "and again"});
  player.to_trial(23 * second);
  EXPECT_EQ(player.session.trial()->index, 0);
  std::set<int> superseded;
  for (const TrialSuperseded& one : player.all<TrialSuperseded>()) superseded.insert(one.trial);
  EXPECT_EQ(superseded, (std::set<int>{0, 1, 2, 3}));
}

TEST(Note, ChangesNothingNotEvenAPause) {
  const StudyBundle bundle = toy::bundle(head + copy);
  Player player(bundle);
  player.to_trial(0);
  player.at(1 * second, Pause{});
  player.at(2 * second, Note{"a phone rang"});
  EXPECT_TRUE(player.session.paused());
  EXPECT_EQ(player.all<Event>().back().kind, "note");
  EXPECT_EQ(player.all<Event>().back().detail, R"({"text":"a phone rang"})");
}

TEST(Interrupted, ContinuesFromAPauseInWhichTheClockStood) {
  const StudyBundle bundle = toy::bundle(head + copy + "limit_s = 20\n");
  Player player(bundle);
  player.to_trial(0);
  player.at(15 * second, toy::pick("near"));
  player.at(15 * second, Interrupted{600 * second, ResumePolicy::continue_});
  EXPECT_TRUE(player.session.paused());
  player.at(40 * second, Resume{});
  ASSERT_NE(player.session.trial(), nullptr);
  EXPECT_EQ(player.session.trial()->weights(0), 1);
  player.at(46 * second, Tick{});
  EXPECT_EQ(player.all<TrialEnded>().at(0).t_us, 45 * second);
  EXPECT_EQ(player.all<TrialEnded>().at(0).paused_us, 25 * second);
}

TEST(Interrupted, RedoesTheTrialOrTheBlockByThePolicy) {
  const StudyBundle bundle = toy::bundle(head + copy);
  for (const ResumePolicy policy : {ResumePolicy::redo_trial, ResumePolicy::redo_block}) {
    Player player(bundle);
    player.to_trial(0);
    player.at(1 * second, Done{});
    player.to_trial(2 * second);
    player.at(3 * second, Interrupted{second, policy});
    const std::size_t again = policy == ResumePolicy::redo_trial ? 1U : 2U;
    EXPECT_EQ(player.all<TrialSuperseded>().size(), again);
    player.to_trial(4 * second);
    EXPECT_EQ(player.session.trial()->index, again == 1U ? 1 : 0);
  }
}

}  // namespace
}  // namespace promenade::study
