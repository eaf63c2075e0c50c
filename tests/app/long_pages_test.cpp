// Pages with more than there is room for.
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "tests/app/session_bench.h"

namespace promenade::app {
namespace {

using bench::SessionBench;
using study::PageKind;

std::string study_text(int questions, const std::string& consent = "") {
  std::string text = "[study]\nname = 'long'\nlanguages = ['en']\n";
  if (!consent.empty()) text += "consent = {en = \"" + consent + "\"}\n";
  text +=
      "[[interface]]\nname = 'labels'\n[[task]]\nname = 'find'\nkind = 'find'\n"
      "qualities = [{name = 'proud', en = 'proud'}]\n";
  for (int k = 0; k < questions; ++k) {
    text += "[[rating]]\nitem = 'q" + std::to_string(k) +
            "'\nquestion = 'Well?'\nlow = 'no'\nhigh = 'yes'\n";
  }
  return text;
}

std::string item(int question, int point) {
  return "answer:q" + std::to_string(question) + ":" + std::to_string(point);
}

bool play_to(SessionBench& bench, PageKind kind) {
  const bool there = bench.play(10, [&] { return bench.session().page().kind == kind; });
  bench.frame();
  bench.frame();
  return there;
}

// A number that changes with the picture.
double picture() {
  double sum = 0;
  const ImDrawData& data = *ImGui::GetDrawData();
  for (int i = 0; i < data.CmdListsCount; ++i) {
    for (const ImDrawVert& vertex : data.CmdLists[i]->VtxBuffer) sum += vertex.pos.x + vertex.pos.y;
  }
  return sum;
}

TEST(LongPages, ThreeQuestionsFitAboveTheButton) {
  SessionBench bench("en", 1, study_text(3));
  ASSERT_TRUE(play_to(bench, PageKind::questionnaire));
  const WidgetMap& widgets = bench.view().widgets();
  const float button = widgets.find("press", "continue")->box.y;
  for (int k = 0; k < 3; ++k) {
    const Widget& last = *widgets.find("press", item(k, 7));
    EXPECT_TRUE(last.visible());
    EXPECT_LT(last.box.bottom() + 20, button) << "and the words under it";
  }
}

TEST(LongPages, ManyQuestionsScrollWithTheWheel) {
  SessionBench bench("en", 1, study_text(9));
  ASSERT_TRUE(play_to(bench, PageKind::questionnaire));
  const WidgetMap& widgets = bench.view().widgets();
  const float button = widgets.find("press", "continue")->box.y;
  EXPECT_FALSE(widgets.find("press", item(8, 1))->visible());
  EXPECT_LE(widgets.find("press", item(8, 1))->view.bottom(), button);
  bench.queue().push({.kind = UiEvent::Kind::move, .x = 500, .y = 400});
  for (int k = 0; k < 20; ++k) bench.wheel(-1);
  EXPECT_TRUE(widgets.find("press", item(8, 1))->visible());
}

TEST(LongPages, TheTabKeyBringsAQuestionIntoSight) {
  SessionBench bench("en", 1, study_text(9));
  ASSERT_TRUE(play_to(bench, PageKind::questionnaire));
  for (int k = 0; k < 100 && !bench.view().focus().on("press", item(8, 2)); ++k) {
    bench.key(GLFW_KEY_TAB);
  }
  EXPECT_TRUE(bench.view().widgets().find("press", item(8, 2))->visible());
  bench.key(GLFW_KEY_SPACE);
  EXPECT_EQ(bench.session().answers()[8].value, 2);
}

TEST(LongPages, TheAutopilotAnswersAllOfThem) {
  SessionBench bench("en", 1, study_text(9));
  ASSERT_TRUE(bench.play(30));
  EXPECT_EQ(bench.session().outcome(), study::Outcome::finished);
}

TEST(LongPages, AConsentOfManyLinesScrollsByKeyAndWheel) {
  std::string lines;
  for (int k = 0; k < 60; ++k) lines += "A further line of the consent. \\n";
  SessionBench bench("en", 1, study_text(0, lines));
  ASSERT_TRUE(play_to(bench, PageKind::consent));
  const double first = picture();
  bench.key(GLFW_KEY_PAGE_DOWN);
  const double second = picture();
  EXPECT_NE(first, second);
  bench.queue().push({.kind = UiEvent::Kind::move, .x = 500, .y = 400});
  bench.wheel(-1);
  EXPECT_NE(picture(), second);
  bench.key(GLFW_KEY_PAGE_UP);
  bench.key(GLFW_KEY_PAGE_UP);
  EXPECT_EQ(picture(), first);
}

// Every interface, and the task that is explained at greatest length.
std::string study_of_all_interfaces() {
  std::string text = "[study]\nname = 'all'\nlanguages = ['en', 'ja']\norder = 'fixed'\n";
  for (const study::InterfaceType& type : interfaces().all()) {
    text += "[[interface]]\nname = '" + type.name + "'\n";
  }
  return text +
         "[[task]]\nname = 'match'\nkind = 'match'\nthreshold = 0.02\nlimit_s = 2\n"
         "targets = [{example = 'proud'}]\npractice = [{example = 'happy'}]\n";
}

TEST(LongPages, OurOwnInstructionsNeedNoScrolling) {
  for (const char* language : {"en", "ja"}) {
    SessionBench bench(language, 1, study_of_all_interfaces());
    for (std::size_t k = 0; k < interfaces().all().size(); ++k) {
      ASSERT_TRUE(play_to(bench, PageKind::instructions));
      bench.queue().push({.kind = UiEvent::Kind::move, .x = 400, .y = 300});
      bench.frame();
      const double before = picture();
      bench.wheel(-1);
      EXPECT_EQ(picture(), before) << language << k;
      ASSERT_TRUE(play_to(bench, PageKind::trial));
    }
  }
}

TEST(LongPages, WhoeverPressesTooEarlyReadsWhatIsMissing) {
  SessionBench bench("en", 1, study_text(2));
  bench.frame();
  const double welcome = picture();
  bench.click("continue");
  EXPECT_NE(picture(), welcome);
  ASSERT_TRUE(play_to(bench, PageKind::questionnaire));
  const double rating = picture();
  bench.key(GLFW_KEY_ENTER);
  EXPECT_EQ(bench.session().page().kind, PageKind::questionnaire);
  EXPECT_NE(picture(), rating);
}

TEST(LongPages, NoPageOfTheFailureShowsAReason) {
  for (const char* language : {"en", "ja"}) {
    EXPECT_EQ(study::load_texts(language)("error.text").find('{'), std::string::npos);
  }
}

}  // namespace
}  // namespace promenade::app
