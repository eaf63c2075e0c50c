// The page of a rate trial: 41 pairs by keyboard, the way back, and going on another day.
#include <gtest/gtest.h>

#include "study/sqlite.h"
#include "tests/app/session_bench.h"

namespace promenade::app {
namespace {

using bench::SessionBench;
using study::PageKind;

std::string study_text(const std::string& instrument, const std::string& more = "") {
  return "[study]\nname = 'rated'\norder = 'fixed'\n[[task]]\nname = 'judge'\nkind = 'rate'\n"
         "instrument = '" +
         instrument +
         "'\nreference = 'normal'\ntargets = [{example = 'sad'}, {example = 'happy'}]\n" + more;
}

struct Page {
  explicit Page(const std::string& instrument, const std::string& more = "")
      : bench("en", 1, study_text(instrument, more)) {}

  bool to_trial() {
    return bench.play(5, [&] { return bench.session().trial() != nullptr; });
  }
  int open() const {
    int count = 0;
    for (const study::ItemAnswer& one : bench.session().answers()) count += one.given() ? 0 : 1;
    return count;
  }
  // The first row without an answer, from the top.
  std::string next_item() const {
    const study::Session& session = bench.session();
    for (const int i : session.item_order()) {
      if (session.answers()[static_cast<std::size_t>(i)].given()) continue;
      return session.questions()->items[static_cast<std::size_t>(i)].name;
    }
    return "";
  }
  bool sees(const std::string& target) const {
    const Widget* widget = bench.view().widgets().find("press", target);
    return widget != nullptr && widget->visible();
  }

  SessionBench bench;
};

TEST(RatePage, TakesAllPairsFromTheKeyboardAndFollows) {
  Page page("adjectives");
  ASSERT_TRUE(page.to_trial());
  page.bench.frame();
  page.bench.frame();
  for (int k = 0; k < 41; ++k) {
    const std::string item = page.next_item();
    EXPECT_TRUE(page.sees("answer:" + item + ":-2")) << k << " " << item;
    EXPECT_TRUE(page.sees("answer:" + item + ":2")) << k << " " << item;
    page.bench.type(std::to_string(1 + k % 5));
    page.bench.frame();
    page.bench.frame();
    ASSERT_EQ(page.open(), 40 - k);
  }
  page.bench.click("done");
  EXPECT_EQ(page.bench.session().page().kind, PageKind::intro);
}

// Who answers in another order stays there.
TEST(RatePage, StaysWhereSomebodyAnswersInAnotherOrder) {
  Page page("adjectives");
  ASSERT_TRUE(page.to_trial());
  page.bench.frame();
  const std::string first = page.next_item();
  page.bench.type("1");
  page.bench.frame();
  const std::vector<int>& order = page.bench.session().item_order();
  const auto third = static_cast<std::size_t>(order[2]);
  const std::string item = page.bench.session().questions()->items[third].name;
  page.bench.click("answer:" + item + ":1");
  page.bench.frame();
  EXPECT_TRUE(page.sees("answer:" + first + ":-2"));
}

TEST(RatePage, LeadsBackToTheMotionBeforeFromTheIntroductionAndFromTheTrial) {
  Page page("impression");
  ASSERT_TRUE(page.to_trial());
  page.bench.frame();
  EXPECT_FALSE(page.sees("back")) << "there is none before";
  page.bench.type("1111");
  page.bench.frame();
  page.bench.click("done");
  page.bench.click("back");
  ASSERT_NE(page.bench.session().trial(), nullptr);
  EXPECT_EQ(page.bench.session().trial()->index, 0);
  EXPECT_EQ(page.open(), 0);
  page.bench.click("done");
  page.bench.click("continue");
  ASSERT_EQ(page.bench.session().trial()->index, 1);
  page.bench.type("2");
  page.bench.click("back");
  EXPECT_EQ(page.bench.session().trial()->index, 0);
}

TEST(LeavePage, EndsTheProgramAndNotTheSession) {
  Page page("impression", "[safety]\nleave = true\n");
  ASSERT_TRUE(page.bench.play(
      5, [&] { return page.bench.session().page().kind == PageKind::instructions; }));
  page.bench.click("leave");
  EXPECT_TRUE(page.bench.session().left());
  EXPECT_FALSE(page.bench.view().ended());
  EXPECT_FALSE(page.sees("pause"));
  page.bench.click("continue");
  EXPECT_TRUE(page.bench.view().ended());
  EXPECT_EQ(page.bench.session().outcome(), study::Outcome::running);
  study::Database database(page.bench.file().string(), study::Database::Mode::read_only);
  study::Statement last(database, "SELECT kind FROM event ORDER BY seq DESC LIMIT 1");
  ASSERT_TRUE(last.step());
  EXPECT_EQ(last.text(0), "leave");
}

TEST(LeavePage, ClosesWithTheWindow) {
  Page page("impression", "[safety]\nleave = true\n");
  ASSERT_TRUE(page.bench.play(
      5, [&] { return page.bench.session().page().kind == PageKind::instructions; }));
  page.bench.click("leave");
  page.bench.close_window();
  EXPECT_TRUE(page.bench.view().ended());
  EXPECT_EQ(page.bench.session().outcome(), study::Outcome::running);
}

TEST(LeavePage, IsOfferedOnlyWhereTheStudySaysSo) {
  Page page("impression");
  ASSERT_TRUE(page.bench.play(
      5, [&] { return page.bench.session().page().kind == PageKind::instructions; }));
  page.bench.frame();
  EXPECT_FALSE(page.sees("leave"));
  EXPECT_TRUE(page.sees("pause"));
}

}  // namespace
}  // namespace promenade::app
