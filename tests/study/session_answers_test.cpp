// Questionnaires in a session: what is taken, what is stored, and about what.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "play.h"
#include "toy.h"

namespace promenade::study {
namespace {

using toy::Player;

const std::string head =
    "[study]\nname = 'asked'\n[[interface]]\nname = 'pick'\n[[interface]]\nname = 'mix'\n"
    "[[task]]\nname = 'copy'\nkind = 'match'\ntargets = [{example = 'far'}]\n";

std::string with(const std::string& instrument, const std::string& when) {
  return head + "[[questionnaire]]\ninstrument = '" + instrument + "'\nwhen = '" + when + "'\n";
}

void to_questions(Player& player) {
  for (std::int64_t t = 1; player.session.page().kind != PageKind::questionnaire; ++t) {
    if (player.session.trial()) {
      player.at(t, Done{});
    } else {
      player.at(t, Continue{});
    }
  }
}

TEST(Questions, WaitForWhatIsNeeded) {
  const StudyBundle bundle = toy::bundle(with("preference", "end"));
  Player player(bundle);
  to_questions(player);
  ASSERT_NE(player.session.questions(), nullptr);
  EXPECT_FALSE(player.session.can_continue());
  player.at(100, SetAnswer{"preferred", 3, "tap"});  // there is no third
  EXPECT_FALSE(player.session.can_continue());
  player.at(101, SetAnswer{"preferred", 2, "mix"});
  EXPECT_TRUE(player.session.can_continue()) << "a reason is not needed";
  player.at(102, SetAnswer{"preferred"});
  EXPECT_FALSE(player.session.can_continue()) << "it was taken back";
}

TEST(Questions, StoreEveryItemAndWhetherItWasTouched) {
  const StudyBundle bundle = toy::bundle(with("preference", "end"));
  Player player(bundle);
  to_questions(player);
  player.at(101, SetAnswer{"preferred", 2, "mix"});
  player.at(105, Continue{});
  const std::vector<Answer> answers = player.all<Answer>();
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0].value, 2);
  EXPECT_EQ(answers[0].text, "mix");
  EXPECT_EQ(answers[0].t_us, 101);
  EXPECT_TRUE(answers[0].touched);
  EXPECT_FALSE(answers[1].touched);
  EXPECT_EQ(answers[1].value, std::nullopt);
  EXPECT_EQ(answers[0].about, -1);
  EXPECT_EQ(answers[0].when, Questionnaire::When::end);
}

TEST(Questions, OfABlockAreAboutItsLastTrial) {
  const StudyBundle bundle = toy::bundle(with("comment", "block"));
  Player player(bundle);
  to_questions(player);
  player.at(100, Continue{});
  EXPECT_EQ(player.all<Answer>().at(0).trial, -1);
  EXPECT_EQ(player.all<Answer>().at(0).about, 0);
}

TEST(Questions, CanBeDeclinedWhereTheItemAllowsIt) {
  const StudyBundle bundle = toy::bundle(with("demographics", "start"));
  Player player(bundle);
  to_questions(player);
  for (const Item& item : player.session.questions()->items) {
    player.at(100, SetAnswer{item.name, {}, "", true});
  }
  EXPECT_TRUE(player.session.can_continue());
  player.at(101, Continue{});
  for (const Answer& answer : player.all<Answer>()) EXPECT_TRUE(answer.declined);
}

TEST(Questions, OfARankingAreARowForEachRank) {
  const StudyBundle bundle = toy::bundle(with("ranking", "end"));
  Player player(bundle);
  to_questions(player);
  const Item& item = player.session.questions()->items[0];
  player.at(100, SetAnswer{item.name, {}, "mix"});  // not all of them
  EXPECT_FALSE(player.session.can_continue());
  player.at(101, SetAnswer{item.name, {}, "mix\npick"});
  player.at(102, Continue{});
  const std::vector<Answer> answers = player.all<Answer>();
  ASSERT_GE(answers.size(), 2U);
  EXPECT_EQ(answers[0].item, item.name + ":mix");
  EXPECT_EQ(answers[0].value, 1);
  EXPECT_EQ(answers[1].item, item.name + ":pick");
  EXPECT_EQ(answers[1].value, 2);
}

TEST(Questions, AreShuffledAnewForEachPersonAndKeepTheirPlaces) {
  const StudyBundle bundle = toy::bundle(with("nasa-tlx", "end"));
  std::set<std::vector<int>> orders;
  for (int sequence = 0; sequence < 4; ++sequence) {
    Player player(bundle, sequence);
    to_questions(player);
    orders.insert(player.session.item_order());
  }
  EXPECT_GT(orders.size(), 1U);
}

TEST(RateTrial, KeepsItsAnswersWhenTheTimeIsOver) {
  const StudyBundle bundle = toy::bundle(
      "[study]\nname = 'rated'\n[[task]]\nname = 'judge'\nkind = 'rate'\ninstrument = "
      "'impression'\nlimit_s = 5\ntargets = [{example = 'far'}]\n");
  Player player(bundle);
  player.to_trial(0);
  const Item& item = player.session.questions()->items[0];
  player.at(1'000'000, SetAnswer{item.name, item.most});
  player.at(9'000'000, Tick{});
  EXPECT_EQ(player.all<TrialEnded>().at(0).outcome, TrialOutcome::timeout);
  const std::vector<Answer> answers = player.all<Answer>();
  ASSERT_EQ(answers.size(), 4U);
  EXPECT_EQ(std::count_if(answers.begin(), answers.end(),
                          [](const Answer& answer) { return answer.touched; }),
            1);
}

TEST(RateTrial, AsksItsInstrumentInPlaceOfAnInterface) {
  const StudyBundle bundle = toy::bundle(
      "[study]\nname = 'rated'\n[[task]]\nname = 'judge'\nkind = 'rate'\ninstrument = "
      "'impression'\nreference = 'near'\ntargets = [{example = 'far'}]\n");
  Player player(bundle);
  player.to_trial(0);
  ASSERT_NE(player.session.trial(), nullptr);
  EXPECT_EQ(player.session.trial()->weights(2), 1) << "the motion that is rated is shown";
  EXPECT_EQ(player.session.trial()->d, std::nullopt);
  player.at(1, Done{});
  ASSERT_NE(player.session.trial(), nullptr) << "nothing was answered";
  for (const Item& item : player.session.questions()->items) {
    player.at(2, SetAnswer{item.name, item.least});
  }
  player.at(3, toy::pick("near"));  // there are no controls
  player.at(4, Done{});
  EXPECT_EQ(player.all<TrialEnded>().at(0).outcome, TrialOutcome::done);
  EXPECT_EQ(player.all<TrialEnded>().at(0).changes, 0);
  for (const Answer& answer : player.all<Answer>()) EXPECT_EQ(answer.trial, 0);
  EXPECT_EQ(player.all<Answer>().size(), 4U);
}

}  // namespace
}  // namespace promenade::study
