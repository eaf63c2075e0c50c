// The questions of instruments by mouse and by keyboard.
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/app/session_bench.h"

namespace promenade::app {
namespace {

using bench::SessionBench;
using study::PageKind;

// An instrument file of its own in a study with one short trial.
class Questions : public testing::Test {
 protected:
  void open(const std::string& items, const std::string& head = "") {
    file_ = std::filesystem::temp_directory_path() /
            ("promenade_items_" + std::to_string(getpid()) + ".toml");
    std::ofstream(file_) << "name = 'own'\ntitle = 'Own questions'\n" << head << items;
    bench_ = std::make_unique<SessionBench>(
        "en", 1,
        "[study]\nname = 'items'\n[[interface]]\nname = 'labels'\n"
        "[[interface]]\nname = 'weights'\n"
        "[[task]]\nname = 'match'\nkind = 'match'\ntargets = [{example = 'proud'}]\n"
        "[[questionnaire]]\ninstrument = '" +
            file_.string() + "'\nwhen = 'start'\n");
    ASSERT_TRUE(
        bench_->play(5, [&] { return bench_->session().page().kind == PageKind::questionnaire; }));
    bench_->frame();
    bench_->frame();
  }
  ~Questions() override { std::filesystem::remove(file_); }

  const study::ItemAnswer& answer(std::size_t item = 0) const {
    return bench_->session().answers()[item];
  }
  bool tab_to(const std::string& kind, const std::string& target) {
    for (int k = 0; k < 100 && !bench_->view().focus().on(kind, target); ++k) {
      bench_->key(GLFW_KEY_TAB);
    }
    return bench_->view().focus().on(kind, target);
  }
  void rest() {
    for (int k = 0; k < 60; ++k) bench_->frame();
  }

  std::filesystem::path file_;
  std::unique_ptr<SessionBench> bench_;
};

std::string item(const std::string& kind, const std::string& more) {
  return "[[item]]\nname = 'i0'\nkind = '" + kind + "'\nquestion = 'Well?'\n" + more + "\n";
}

TEST_F(Questions, AChoiceIsPressedByMouseDigitOrEnter) {
  open(item("choice", "choices = [{name = 'a', en = 'A'}, {name = 'b', en = 'B'}]"));
  bench_->click("answer:i0:2");
  EXPECT_EQ(answer().value, 2);
  EXPECT_EQ(answer().text, "b");
  ASSERT_TRUE(tab_to("press", "answer:i0:1"));
  bench_->key(GLFW_KEY_ENTER);
  EXPECT_EQ(answer().text, "a");
  bench_->type("2");
  EXPECT_EQ(answer().text, "b");
}

TEST_F(Questions, AFreeChoiceTakesThePersonsOwnWords) {
  open(item("choice",
            "choices = [{name = 'a', en = 'A'}, {name = 'other', en = 'Other', free = true}]"));
  bench_->click("answer:i0:2");
  EXPECT_EQ(answer().text, "other");
  bench_->type("mine");
  rest();
  EXPECT_EQ(answer().value, 2);
  EXPECT_EQ(answer().text, "mine");
  bench_->click("answer:i0:1");
  EXPECT_EQ(answer().text, "a");
}

TEST_F(Questions, ATextIsToldWhenNobodyTypesAndWhenItIsLeft) {
  open(item("text", ""));
  ASSERT_TRUE(tab_to("type", "words:i0"));
  bench_->type("so");
  EXPECT_FALSE(answer().given()) << "not letter by letter";
  rest();
  EXPECT_EQ(answer().text, "so");
  bench_->type(" it is");
  bench_->key(GLFW_KEY_TAB);
  EXPECT_EQ(answer().text, "so it is");
}

TEST_F(Questions, TheEscapeKeyTakesNothingBackThatWasWritten) {
  open(item("text", ""));
  ASSERT_TRUE(tab_to("type", "words:i0"));
  bench_->type("kept");
  bench_->key(GLFW_KEY_ESCAPE);
  bench_->frame();
  EXPECT_EQ(answer().text, "kept");
  EXPECT_FALSE(bench_->session().paused());
  bench_->key(GLFW_KEY_ESCAPE);
  EXPECT_TRUE(bench_->session().paused());
}

TEST_F(Questions, WhatIsBeingWrittenOutlivesTheExperimentersPanel) {
  open(item("text", ""));
  ASSERT_TRUE(tab_to("type", "words:i0"));
  bench_->type("half a sen");
  bench_->chord();
  bench_->click("experimenter:back");
  EXPECT_EQ(answer().text, "half a sen");
  bench_->click_on("type", "words:i0");
  bench_->type("tence");
  rest();
  EXPECT_EQ(answer().text, "half a sentence");
}

TEST_F(Questions, ALongTextIsBrokenIntoLinesAndStoredWithoutThem) {
  open(item("text", ""));
  ASSERT_TRUE(tab_to("type", "words:i0"));
  std::string words;
  for (int k = 0; k < 30; ++k) words += "several words ";
  bench_->type(words + "end");
  rest();
  EXPECT_EQ(answer().text, words + "end");
}

TEST_F(Questions, ANumberMustLieInItsRange) {
  open(item("number", "least = 18\nmost = 99"));
  ASSERT_TRUE(tab_to("type", "words:i0"));
  bench_->type("17");
  bench_->key(GLFW_KEY_TAB);
  EXPECT_FALSE(answer().given());
  ASSERT_TRUE(tab_to("type", "words:i0"));
  bench_->key(GLFW_KEY_BACKSPACE);
  bench_->type("8,5");
  bench_->key(GLFW_KEY_TAB);
  EXPECT_EQ(answer().value, 18.5) << "with a comma, too";
}

const char* const three =
    "choices = [{name = 'a', en = 'A'}, {name = 'b', en = 'B'}, {name = 'c', en = 'C'}]";

TEST_F(Questions, ARankingIsAnAnswerOnceItIsComplete) {
  open(item("ranking", three));
  bench_->click("rank:i0:b");
  bench_->click("rank:i0:a");
  EXPECT_FALSE(answer().given());
  bench_->click("rank:i0:c");
  EXPECT_EQ(answer().text, "b\na\nc");
  bench_->click("rank:i0:b");
  EXPECT_FALSE(answer().given()) << "it is taken out again";
  bench_->click("rank:i0:b");
  EXPECT_EQ(answer().text, "a\nc\nb");
}

TEST_F(Questions, ARankingIsTypedWithDigitsToo) {
  open(item("ranking", three));
  bench_->type("312");
  EXPECT_EQ(answer().text, "c\na\nb");
}

TEST_F(Questions, ABoxIsTickedAndTheTickTakenBack) {
  open(item("agree", ""));
  ASSERT_TRUE(tab_to("press", "agree:i0"));
  bench_->key(GLFW_KEY_SPACE);
  EXPECT_EQ(answer().value, 1);
  EXPECT_TRUE(bench_->session().can_continue());
  bench_->click("agree:i0");
  EXPECT_FALSE(answer().given());
}

TEST_F(Questions, WhatMayBeDeclinedCanBeDeclined) {
  open(item("scale", "can_decline = true"));
  bench_->click("decline:i0");
  EXPECT_TRUE(answer().declined);
  EXPECT_TRUE(bench_->session().can_continue());
  bench_->click("answer:i0:3");
  EXPECT_FALSE(answer().declined);
  EXPECT_EQ(answer().value, 3);
}

TEST_F(Questions, TheArrowKeysMoveAlongALongScaleWithOneStopForTab) {
  open(item("scale", "least = 0\nmost = 100\nstep = 5"));
  ASSERT_TRUE(tab_to("press", "answer:i0:0"));
  for (int k = 0; k < 3; ++k) bench_->key(GLFW_KEY_RIGHT);
  EXPECT_EQ(answer().value, 15);
  bench_->key(GLFW_KEY_END);
  EXPECT_EQ(answer().value, 100);
  bench_->key(GLFW_KEY_TAB);
  EXPECT_FALSE(bench_->view().focus().on_first("press", "answer:"));
}

TEST_F(Questions, OppositeWordsAreCountedFromTheLeftByDigits) {
  open("[[item]]\nname = 'i0'\nkind = 'scale'\nlow = 'slow'\nhigh = 'fast'\n",
       "least = -2\nmost = 2\n");
  bench_->type("5");
  EXPECT_EQ(answer().value, 2);
  bench_->click("answer:i0:-1");
  EXPECT_EQ(answer().value, -1);
}

TEST_F(Questions, AScaleThatHasAZeroTakesTheDigitZero) {
  open(item("scale", "least = 0\nmost = 10"));
  bench_->type("0");
  EXPECT_EQ(answer().value, 0);
}

TEST_F(Questions, ContinueTooEarlyLeadsToWhatIsMissing) {
  std::string items;
  for (int k = 0; k < 20; ++k) {
    items += "[[item]]\nname = 'q" + std::to_string(k) + "'\nkind = 'scale'\nquestion = 'Well?'\n";
  }
  open(items);
  for (int k = 0; k < 15; ++k) bench_->type("4");
  ASSERT_FALSE(bench_->view().widgets().find("press", "answer:q15:1")->visible());
  bench_->click("continue");
  bench_->frame();
  EXPECT_EQ(bench_->session().page().kind, PageKind::questionnaire);
  EXPECT_TRUE(bench_->view().widgets().find("press", "answer:q15:1")->visible());
}

}  // namespace
}  // namespace promenade::app
