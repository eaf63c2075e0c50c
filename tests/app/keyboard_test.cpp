// Every page of a session by keyboard alone.
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/app/session_bench.h"

namespace promenade::app {
namespace {

using bench::SessionBench;
using study::PageKind;

// Every interface that the built-in set can have, one task, one question, breaks.
std::string study_text() {
  std::string text =
      "[study]\nname = 'keys'\nlanguages = ['en', 'ja']\norder = 'fixed'\n"
      "[breaks]\nafter = 'block'\n";
  for (const study::InterfaceType& type : interfaces().all()) {
    text += "[[interface]]\nname = '" + type.name + "'\n";
  }
  return text +
         "[[task]]\nname = 'match'\nkind = 'match'\ntargets = [{example = 'proud'}]\n"
         "practice = [{example = 'happy'}]\n"
         "[[rating]]\nitem = 'one'\nquestion = 'One?'\npoints = 11\n"
         "[[rating]]\nitem = 'two'\nquestion = 'Two?'\n";
}

class ByKeyboard : public testing::Test {
 protected:
  bool tab_to(const std::string& kind, const std::string& target) {
    for (int k = 0; k < 400; ++k) {
      if (bench_.view().focus().on(kind, target)) return true;
      bench_.key(GLFW_KEY_TAB);
    }
    return false;
  }

  void do_trial() {
    bench_.frame();
    bench_.key(GLFW_KEY_TAB);
    for (const int key : {GLFW_KEY_ENTER, GLFW_KEY_RIGHT, GLFW_KEY_UP}) bench_.key(key);
    bench_.key(GLFW_KEY_ESCAPE);
    if (!bench_.session().paused()) bench_.key(GLFW_KEY_ESCAPE);  // a field is left first
    EXPECT_TRUE(bench_.session().paused());
    bench_.key(GLFW_KEY_ENTER);
    EXPECT_FALSE(bench_.session().paused());
    ASSERT_TRUE(tab_to("press", "done"));
    bench_.key(GLFW_KEY_SPACE);
  }

  void do_page(PageKind kind) {
    switch (kind) {
      case PageKind::language:
        ASSERT_TRUE(tab_to("press", "language:ja"));
        return bench_.key(GLFW_KEY_ENTER);
      case PageKind::welcome:
        bench_.type("P07");
        return bench_.key(GLFW_KEY_ENTER);
      case PageKind::consent:
        bench_.key(GLFW_KEY_ENTER);
        ASSERT_EQ(bench_.session().page().kind, PageKind::consent) << "nobody agrees by accident";
        ASSERT_TRUE(tab_to("press", "continue"));
        return bench_.key(GLFW_KEY_ENTER);
      case PageKind::trial:
        return do_trial();
      case PageKind::questionnaire:
        bench_.type("03");
        return bench_.key(GLFW_KEY_ENTER);
      default:
        return bench_.key(GLFW_KEY_ENTER);
    }
  }

  SessionBench bench_{"", 1, study_text()};
};

TEST_F(ByKeyboard, ASessionGoesFromTheChoiceOfLanguageToThanks) {
  std::set<PageKind> seen;
  for (int pages = 0; !bench_.view().ended(); ++pages) {
    ASSERT_LT(pages, 100);
    const study::Page* page = &bench_.session().page();
    seen.insert(page->kind);
    do_page(page->kind);
    ASSERT_TRUE(bench_.view().ended() || page != &bench_.session().page())
        << study::to_text(page->kind);
  }
  EXPECT_EQ(bench_.session().outcome(), study::Outcome::finished);
  EXPECT_EQ(bench_.session().language(), "ja");
  const bool several = interfaces().all().size() > 1;
  EXPECT_EQ(seen.size(), several ? 9U : 8U) << "language, welcome, consent, instructions, trial, "
                                               "intro, rating, break and thanks";
}

TEST_F(ByKeyboard, DigitsAnswerOneQuestionAfterTheOther) {
  while (bench_.session().page().kind != PageKind::questionnaire) do_page(bench_.session().page().kind);
  bench_.type("0");
  EXPECT_EQ(bench_.session().answers()[0].value, 10) << "0 stands for 10";
  EXPECT_FALSE(bench_.session().answers()[1].value);
  bench_.type("8");
  EXPECT_FALSE(bench_.session().answers()[1].value) << "the scale has seven points";
  bench_.type("7");
  EXPECT_EQ(bench_.session().answers()[1].value, 7);
  ASSERT_TRUE(tab_to("press", "answer:one:2"));
  bench_.type("4");
  EXPECT_EQ(bench_.session().answers()[0].value, 4) << "that of the question with the keyboard";
}

TEST_F(ByKeyboard, ADigitIsForTheNextQuestionAfterAnAnswerWithTheMouse) {
  while (bench_.session().page().kind != PageKind::questionnaire) do_page(bench_.session().page().kind);
  bench_.click("answer:one:5");
  bench_.type("3");
  EXPECT_EQ(bench_.session().answers()[0].value, 5);
  EXPECT_EQ(bench_.session().answers()[1].value, 3);
}

TEST_F(ByKeyboard, TheCameraTurnsTiltsMovesAndComesCloser) {
  while (bench_.session().trial() == nullptr) do_page(bench_.session().page().kind);
  ASSERT_TRUE(tab_to("stage", "stage"));
  const Eigen::VectorXd weights = bench_.session().trial()->weights;
  for (const int key : {GLFW_KEY_RIGHT, GLFW_KEY_UP, GLFW_KEY_PAGE_UP}) bench_.key(key);
  const Orbit turned = bench_.view().stage().orbit();
  EXPECT_GT(turned.yaw, 0);
  EXPECT_GT(turned.pitch, 0);
  EXPECT_GT(turned.zoom, 1);
  EXPECT_EQ(turned.right, 0);
  bench_.hold(GLFW_KEY_LEFT_SHIFT, true);
  for (const int key : {GLFW_KEY_RIGHT, GLFW_KEY_UP}) bench_.key(key);
  const Orbit moved = bench_.view().stage().orbit();
  EXPECT_GT(moved.right, 0);
  EXPECT_GT(moved.up, 0);
  EXPECT_EQ(moved.yaw, turned.yaw);
  EXPECT_EQ(bench_.session().trial()->weights, weights) << "the keys are the camera's";
}

TEST_F(ByKeyboard, EscapeClearsTheSearchBeforeItIsAPause) {
  SessionBench bench("en", 1,
                     "[study]\nname = 'list'\n[[interface]]\nname = 'labels'\n"
                     "[[task]]\nname = 'match'\nkind = 'match'\ntargets = [{example = 'proud'}]\n");
  ASSERT_TRUE(bench.play(5, [&] { return bench.session().trial() != nullptr; }));
  bench.type("sad");
  ASSERT_EQ(bench.view().widgets().find("pick", "old"), nullptr);
  bench.key(GLFW_KEY_ESCAPE);
  EXPECT_FALSE(bench.session().paused());
  EXPECT_NE(bench.view().widgets().find("pick", "old"), nullptr);
  bench.key(GLFW_KEY_ESCAPE);
  EXPECT_TRUE(bench.session().paused());
}

}  // namespace
}  // namespace promenade::app
