// The way back in rate tasks: what is filled in again, and what counts.
#include <gtest/gtest.h>

#include "play.h"
#include "study/ratings.h"
#include "study/replay.h"
#include "study/sqlite.h"
#include "study/store.h"
#include "tests/test_folder.h"
#include "toy.h"

namespace promenade::study {
namespace {

using toy::Player;

std::string text_with(const std::string& keys, const std::string& more = "") {
  return "[study]\nname = 'judged'\norder = 'fixed'\n[[task]]\nname = 'judge'\nkind = 'rate'\n"
         "instrument = 'impression'\ntargets = [{example = 'far'}, {example = 'near'}, {example = "
         "'side'}]\n" +
         keys + more;
}

void answer_all(Player& player, std::int64_t t, double value) {
  const std::vector<Item> items = player.session.questions()->items;
  for (const Item& item : items) player.at(t, SetAnswer{item.name, value});
}

// Rates the motion that is open or comes next, and goes on to the page behind it.
void rate(Player& player, std::int64_t t, double value) {
  player.to_trial(t);
  answer_all(player, t + 1, value);
  player.at(t + 2, Done{});
}

int page_trial(const Player& player) { return player.session.page().trial; }

TEST(Back, OpensTheMotionBeforeWithItsAnswers) {
  const StudyBundle bundle = toy::bundle(text_with(""));
  Player player(bundle);
  player.to_trial(0);
  EXPECT_FALSE(player.session.can_go_back()) << "it is the first one";
  rate(player, 100, 2);
  EXPECT_TRUE(player.session.can_go_back()) << "from the page before the next one";
  player.at(200, Back{});
  ASSERT_NE(player.session.trial(), nullptr);
  EXPECT_EQ(player.session.trial()->index, 0);
  EXPECT_EQ(player.session.trial()->attempt, 2);
  EXPECT_TRUE(player.session.answered());
  EXPECT_EQ(player.session.answers()[0].value, 2);
}

TEST(Back, KeepsWhatWasAnsweredOnThePageThatIsLeft) {
  const StudyBundle bundle = toy::bundle(text_with(""));
  Player player(bundle);
  rate(player, 100, 2);
  player.to_trial(200);
  const std::string item = player.session.questions()->items[1].name;
  player.at(201, SetAnswer{item, -1});
  const std::vector<int> order = player.session.item_order();
  player.at(202, Back{});
  EXPECT_EQ(page_trial(player), 0);
  player.at(203, Done{});
  player.to_trial(204);
  EXPECT_EQ(player.session.trial()->index, 1);
  EXPECT_EQ(player.session.answers()[1].value, -1);
  EXPECT_FALSE(player.session.answered());
  EXPECT_EQ(player.session.item_order(), order) << "as it was";
}

TEST(Back, LeadsAsFarAsTheFirstMotionOfTheTask) {
  const StudyBundle bundle = toy::bundle(text_with(""));
  Player player(bundle);
  rate(player, 100, 2);
  rate(player, 200, 1);
  player.to_trial(300);
  player.at(301, Back{});
  player.at(302, Back{});
  EXPECT_EQ(page_trial(player), 0);
  EXPECT_EQ(player.session.answers()[0].value, 2);
  player.at(303, Back{});
  EXPECT_EQ(page_trial(player), 0);
  player.at(304, Done{});
  player.to_trial(305);
  EXPECT_EQ(player.session.answers()[0].value, 1) << "the second is whole, too";
  EXPECT_TRUE(player.session.answered());
}

TEST(Back, IsClosedByWhatStandsBetween) {
  const struct {
    const char *keys, *more;
  } closed[] = {{"limit_s = 60\n", ""},
                {"", "[breaks]\nevery = 1\n"},
                {"",
                 "[[questionnaire]]\ninstrument = 'comment'\nwhen = 'trial'\ntasks = "
                 "['judge']\n"}};
  for (const auto& one : closed) {
    const StudyBundle bundle = toy::bundle(text_with(one.keys, one.more));
    Player player(bundle);
    rate(player, 100, 2);
    player.to_trial(200);
    ASSERT_EQ(page_trial(player), 1);
    EXPECT_FALSE(player.session.can_go_back()) << one.keys << one.more;
    EXPECT_TRUE(player.at(201, Back{}).empty());
    EXPECT_EQ(page_trial(player), 1);
  }
}

TEST(Back, IsClosedFromOneTaskToAnotherAndToPractice) {
  const std::string other =
      "[[task]]\nname = 'more'\nkind = 'rate'\ninstrument = 'impression'\npractice = [{example = "
      "'far'}, {example = 'near'}]\ntargets = [{example = 'far'}]\n";
  const StudyBundle bundle = toy::bundle(text_with("", other));
  Player player(bundle);
  for (int i = 0; i < 6; ++i) {
    player.to_trial(100 * i);
    ASSERT_EQ(page_trial(player), i);
    const bool free = i == 1 || i == 2 || i == 4;  // 3 and 4 are practice of the other task
    EXPECT_EQ(player.session.can_go_back(), free) << i;
    rate(player, 100 * i + 1, 1);
  }
}

TEST(Back, DoesNotReopenWhatTheExperimenterSkipped) {
  const StudyBundle bundle = toy::bundle(text_with(""));
  Player player(bundle);
  player.to_trial(100);
  player.at(101, Skip{"too long"});
  player.to_trial(102);
  ASSERT_EQ(page_trial(player), 1);
  EXPECT_FALSE(player.session.can_go_back());
}

// What the experimenter begins anew is empty.
TEST(Back, FillsInNothingThatIsRepeated) {
  const StudyBundle bundle = toy::bundle(text_with(""));
  Player player(bundle);
  rate(player, 100, 2);
  player.at(200, Repeat{false, "again"});
  player.to_trial(201);
  ASSERT_EQ(page_trial(player), 0);
  EXPECT_FALSE(player.session.answers()[0].given());
}

struct Stored {
  TestFolder folder;
  StudyBundle bundle = toy::bundle(text_with(""));
  std::string file = folder.file("back.db");

  // Rates two motions, goes back and changes one answer; then to the end.
  explicit Stored(bool to_the_end) {
    Store store(file, bundle);
    Player player(bundle);
    SessionHeader header;
    header.participant = "P1";
    store.begin_session(header, player.session.plan());
    rate(player, 100, 2);
    rate(player, 200, 1);
    player.at(300, Back{});
    player.at(301, Back{});
    player.at(302, SetAnswer{"quickness", -2});
    player.at(303, Done{});
    if (to_the_end) {
      rate(player, 400, 1);
      rate(player, 500, 0);
      while (!player.session.ended()) player.at(600, Continue{});
    }
    store.write(player.records);
    store.flush();
  }
};

TEST(Back, LeavesOnlyTheLastWordInWhatCounts) {
  const Stored stored(true);
  const RatingSelection selection{.instrument = "impression"};
  const RatingsTable table =
      read_database_ratings(stored.file, selection, &stored.bundle.space.set).table;
  EXPECT_EQ(table.ratings.size(), 12U);
  std::map<std::string, double> quick;
  for (const motion::Rating& one : table.ratings) {
    if (table.pairs[static_cast<std::size_t>(one.pair)] == "quickness") {
      quick[table.motions[static_cast<std::size_t>(one.motion)]] = one.value;
    }
  }
  EXPECT_EQ(quick, (std::map<std::string, double>{{"far", -2}, {"near", 1}, {"side", 0}}));
}

TEST(Back, IsReplayedAndPassesTheAudit) {
  for (const bool to_the_end : {false, true}) {
    const Stored stored(to_the_end);
    Database database(stored.file, Database::Mode::read_only);
    const LoggedSession log = read_session(database, session_uuids(database).at(0));
    Audit found;
    audit(stored.bundle, toy::registry(), log, found);
    EXPECT_TRUE(found.differences.empty()) << found.differences[0].what;
    const Session again = replay(stored.bundle, toy::registry(), log);
    EXPECT_EQ(again.ended(), to_the_end);
    if (!to_the_end) {
      EXPECT_EQ(again.page().trial, 1);
    }
    EXPECT_EQ(log.trials.size(), to_the_end ? 6U : 4U);
  }
}

}  // namespace
}  // namespace promenade::study
