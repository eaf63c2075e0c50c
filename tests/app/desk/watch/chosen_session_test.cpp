// Whom the buttons of the page are for.
#include "app/desk/watch/chosen_session.h"

#include <gtest/gtest.h>

namespace promenade::app {
namespace {

study::WatchedSession session(const std::string& uuid, bool ended = false) {
  study::WatchedSession one;
  one.uuid = uuid;
  one.state = ended ? study::WatchedState::ended : study::WatchedState::running;
  return one;
}

study::Watched with(std::vector<study::WatchedSession> sessions) {
  study::Watched now;
  now.sessions = std::move(sessions);
  return now;
}

TEST(ChosenSession, IsTheOnlyOneByItself) {
  ChosenSession chosen;
  chosen.follow(with({}));
  EXPECT_EQ(chosen.uuid(), "");
  chosen.follow(with({session("a"), session("z", true)}));
  EXPECT_EQ(chosen.uuid(), "a");
}

TEST(ChosenSession, IsNoneOfSeveralByItself) {
  ChosenSession chosen;
  chosen.follow(with({session("a"), session("b")}));
  EXPECT_EQ(chosen.uuid(), "");
  chosen.uuid() = "b";
  const study::Watched now = with({session("a"), session("b")});
  chosen.follow(now);
  ASSERT_NE(chosen.in(now), nullptr);
  EXPECT_EQ(chosen.in(now)->uuid, "b");
}

TEST(ChosenSession, DoesNotGoOverToAnotherPerson) {
  ChosenSession chosen;
  chosen.follow(with({session("a")}));
  chosen.follow(with({session("a"), session("b")}));
  EXPECT_EQ(chosen.uuid(), "a");
  chosen.follow(with({session("b"), session("a", true)}));
  EXPECT_EQ(chosen.uuid(), "");
  chosen.follow(with({session("b"), session("a", true)}));
  EXPECT_EQ(chosen.uuid(), "") << "until somebody chooses";
}

TEST(ChosenSession, IsTheNextOneWhenNobodyWasThereMeanwhile) {
  ChosenSession chosen;
  chosen.follow(with({session("a")}));
  chosen.follow(with({session("a", true)}));
  chosen.follow(with({session("b"), session("a", true)}));
  EXPECT_EQ(chosen.uuid(), "b");
}

}  // namespace
}  // namespace promenade::app
