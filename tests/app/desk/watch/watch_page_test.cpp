// The page on which sessions are watched and asked for things, without a window: a session plays in
// the same process, on pages of its own.
#include "app/desk/watch/watch_page.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <sstream>
#include <thread>

#include "app/desk/words.h"
#include "app/monitor_view.h"
#include "app/tool_page.h"
#include "study/sqlite.h"
#include "tests/app/session_bench.h"
#include "tests/test_folder.h"

namespace promenade::app {
namespace {

using bench::SessionBench;

constexpr const char* study_text =
    "[study]\nname = 'asked'\n[[interface]]\nname = 'labels'\n"
    "[[task]]\nname = 'match'\nkind = 'match'\nlimit_s = 60\n"
    "targets = [{example = 'proud'}, {example = 'sad'}]\npractice = [{example = 'happy'}]\n";

// A page in a window that is not there.
class PageBench {
 public:
  PageBench(const std::string& database, WatchControls::Resume on_resume,
            const std::string& language = "en")
      : page_(database, std::move(on_resume)), texts_(desk_texts(language)), tool_(queue_) {
    std::vector<std::string> words;
    for (const std::string& key : texts_.keys()) words.push_back(texts_(key));
    gui_ = std::make_unique<Gui>(make_palette(false), std::move(words));
    gui_->fit(1280, 720);
    unsigned char* pixels = nullptr;
    int wide = 0;
    int high = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &wide, &high);
  }
  void frame() {
    now_us_ += 16'667;
    page_.advance(now_us_);
    tool_.frame(*gui_,
                [&](const Ui& ui) { page_.draw(ui, texts_, ui.layout.box(0, 56, 1280, 620)); });
  }
  void push(const UiEvent& event) {
    queue_.push(event);
    frame();
  }
  void wait_with(const UiEvent& event) { queue_.push(event); }  // until the next frame
  void key(int code) {
    push({.kind = UiEvent::Kind::key, .code = code, .down = true});
    push({.kind = UiEvent::Kind::key, .code = code, .down = false});
  }
  void type(const std::string& text) {
    for (const char one : text) queue_.push({.kind = UiEvent::Kind::character, .code = one});
    frame();
    frame();
  }
  const Widget* find(const char* kind, const std::string& target) const {
    return tool_.widgets().find(kind, target);
  }
  void click(const char* kind, const std::string& target) {
    const Widget* widget = find(kind, target);
    if (widget == nullptr) throw std::logic_error("there is no " + target);
    push({.kind = UiEvent::Kind::move, .x = widget->box.middle_x(), .y = widget->box.middle_y()});
    push({.kind = UiEvent::Kind::button, .code = 0, .down = true});
    push({.kind = UiEvent::Kind::button, .code = 0, .down = false});
  }
  bool tab_to(const std::string& target) {
    for (int k = 0; k < 30; ++k) {
      if (tool_.focus().on("press", target)) return true;
      key(GLFW_KEY_TAB);
    }
    return false;
  }
  const WatchPage& page() const { return page_; }
  const Focus& focus() const { return tool_.focus(); }
  const WidgetMap& widgets() const { return tool_.widgets(); }

 private:
  WatchPage page_;
  study::Texts texts_;
  InputQueue queue_;
  ToolPage tool_;
  std::unique_ptr<Gui> gui_;
  std::int64_t now_us_ = 0;
};

class DeskWatch : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(session_.play(5, [&] {
      return session_.session().trial() != nullptr && session_.session().trial()->index == 1;
    }));
    ASSERT_TRUE(until([&] { return page_.find("press", "watch:pause") != nullptr; }));
  }
  // The thread of the page sees it in its own time.
  bool until(const std::function<bool()>& done, bool session_plays = true) {
    for (int k = 0; k < 5000 && !done(); ++k) {
      if (session_plays) session_.frame();
      page_.frame();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return done();
  }
  bool until_it_is(Asked::State state, bool session_plays = true) {
    const std::vector<Asked>& all = page_.page().asked().all();
    return until([&] { return !all.empty() && all.back().state == state; }, session_plays);
  }
  std::optional<study::Request> last_request() const {
    std::ifstream file(study::requests_file(session_.file().string()));
    std::string line, last;
    while (std::getline(file, line)) last = line.empty() ? last : line;
    return study::read_request(last);
  }
  std::string last_words() const {
    const auto request = last_request();
    return request ? request->words : "nothing";
  }
  const study::WatchedSession& seen() const { return page_.page().seen()->sessions.at(0); }
  void execute(const std::string& sql) const {
    study::Database(session_.file().string(), study::Database::Mode::read_write).exec(sql);
  }

  SessionBench session_{"en", 1, study_text};
  std::vector<std::string> resumed_;
  PageBench page_{session_.file().string(),
                  [this](const study::WatchedSession& one) { resumed_.push_back(one.uuid); }};
};

TEST_F(DeskWatch, ShowsWhatASessionDoes) {
  EXPECT_NE(page_.find("session", seen().uuid), nullptr);
  EXPECT_NE(page_.find("plot", seen().uuid), nullptr);
  EXPECT_NE(page_.find("ring", seen().uuid), nullptr);
  EXPECT_EQ(page_.find("press", "watch:start"), nullptr);
  EXPECT_EQ(page_.find("press", "watch:release"), nullptr) << "nobody waits for that";
}

TEST_F(DeskWatch, LeadsFromEachButtonToItsRequest) {
  struct Row {
    const char* button;
    const char* what;
    bool words, block, page;
  };
  for (const Row& row :
       {Row{"pause", "pause", false, false, false}, Row{"skip", "skip", true, false, true},
        Row{"repeat_trial", "repeat", true, false, true},
        Row{"repeat_block", "repeat", true, true, true}, Row{"note", "note", true, false, false},
        Row{"stop", "stop", true, false, false}}) {
    page_.click("press", std::string("watch:") + row.button);
    if (row.words) page_.type("the phone rang");
    if (row.words) page_.key(GLFW_KEY_ENTER);
    const auto request = last_request();
    ASSERT_TRUE(request) << row.button;
    EXPECT_EQ(request->what, row.what);
    EXPECT_EQ(request->session, seen().uuid);
    EXPECT_EQ(request->words, row.words ? "the phone rang" : "");
    EXPECT_EQ(request->block, row.block);
    EXPECT_EQ(request->page, row.page ? session_.session().page_index() : -1);
  }
}

TEST_F(DeskWatch, PausesAndGoesOnAndShowsThatItWasDone) {
  page_.click("press", "watch:pause");
  EXPECT_EQ(page_.page().asked().all().back().state, Asked::State::asked);
  EXPECT_TRUE(until_it_is(Asked::State::done));
  EXPECT_TRUE(session_.session().paused());
  ASSERT_TRUE(until([&] { return page_.find("press", "watch:resume") != nullptr; }));
  page_.click("press", "watch:resume");
  EXPECT_TRUE(until_it_is(Asked::State::done));
  EXPECT_FALSE(session_.session().paused());
}

TEST_F(DeskWatch, WorksByKeyboardAlone) {
  ASSERT_TRUE(page_.tab_to("watch:skip"));
  page_.key(GLFW_KEY_ENTER);
  ASSERT_NE(page_.find("type", "watch:words"), nullptr);
  page_.type("by key");
  page_.key(GLFW_KEY_ENTER);
  EXPECT_TRUE(page_.focus().on("press", "watch:skip")) << "where it was before";
  EXPECT_TRUE(until_it_is(Asked::State::done));
  EXPECT_EQ(last_words(), "by key");
}

TEST_F(DeskWatch, IsReachedWhollyByTab) {
  for (std::size_t i = 0; i < page_.widgets().size(); ++i) {
    const Widget widget = page_.widgets()[i];
    if (widget.kind != "press") continue;
    EXPECT_TRUE(page_.tab_to(widget.target)) << widget.target;
  }
  ASSERT_TRUE(page_.tab_to("watch:note"));
  page_.key(GLFW_KEY_SPACE);
  EXPECT_TRUE(page_.tab_to("watch:send"));
  EXPECT_TRUE(page_.tab_to("watch:give_up"));
  page_.key(GLFW_KEY_ENTER);
  EXPECT_NE(page_.find("press", "watch:note"), nullptr);
}

TEST_F(DeskWatch, AsksForNothingWithoutAReason) {
  page_.click("press", "watch:skip");
  page_.key(GLFW_KEY_ENTER);
  page_.type(" ");
  page_.click("press", "watch:send");
  EXPECT_NE(page_.find("type", "watch:words"), nullptr);
  EXPECT_FALSE(last_request());
  page_.type("now there is one");
  page_.key(GLFW_KEY_ENTER);
  EXPECT_TRUE(last_request());
}

TEST_F(DeskWatch, GivesUpWithTheEscapeKey) {
  page_.click("press", "watch:stop");
  page_.type("no, not");
  page_.key(GLFW_KEY_ESCAPE);
  EXPECT_EQ(page_.find("type", "watch:words"), nullptr);
  EXPECT_FALSE(last_request());
  page_.click("press", "watch:skip");
  page_.type("yes");
  page_.key(GLFW_KEY_ENTER);
  EXPECT_EQ(last_words(), "yes") << "what was given up is gone";
}

// While a session plays beside, the desk draws a few times a second.
TEST_F(DeskWatch, LosesNothingOfWhatIsTypedAtOnce) {
  const Box box = page_.find("press", "watch:note")->box;
  page_.push({.kind = UiEvent::Kind::move, .x = box.middle_x(), .y = box.middle_y()});
  page_.wait_with({.kind = UiEvent::Kind::button, .code = 0, .down = true});
  page_.wait_with({.kind = UiEvent::Kind::button, .code = 0, .down = false});
  for (const char one : std::string("at once")) {
    page_.wait_with({.kind = UiEvent::Kind::character, .code = one});
  }
  page_.wait_with({.kind = UiEvent::Kind::key, .code = GLFW_KEY_ENTER, .down = true});
  page_.push({.kind = UiEvent::Kind::key, .code = GLFW_KEY_ENTER, .down = false});
  EXPECT_EQ(last_words(), "at once");
}

TEST_F(DeskWatch, ShowsARefusalAndItsReason) {
  session_.chord();
  ASSERT_TRUE(until([&] { return page_.find("press", "watch:resume") != nullptr; }));
  page_.click("press", "watch:resume");
  EXPECT_TRUE(until_it_is(Asked::State::refused));
  EXPECT_EQ(asked_words(desk_texts("en"), page_.page().asked().all().back()),
            "S001, Go on: refused, the experimenter's panel is open there");
}

TEST_F(DeskWatch, SaysThatNobodyAnswers) {
  page_.click("press", "watch:pause");
  EXPECT_TRUE(until_it_is(Asked::State::silent, false));
}

TEST_F(DeskWatch, OffersToGoOnWithASessionWhoseProgramDied) {
  execute("UPDATE session SET process_start = 'another'");
  ASSERT_TRUE(until([&] { return page_.find("press", "watch:start") != nullptr; }, false));
  EXPECT_EQ(page_.find("press", "watch:pause"), nullptr);
  page_.click("press", "watch:start");
  page_.click("press", "watch:start");
  EXPECT_EQ(resumed_, std::vector<std::string>{seen().uuid}) << "once, until its window is there";
}

TEST_F(DeskWatch, EndsASessionAndKeepsWhatWasAsked) {
  page_.click("press", "watch:stop");
  page_.type("unwell");
  page_.key(GLFW_KEY_ENTER);
  EXPECT_TRUE(until_it_is(Asked::State::done));
  EXPECT_EQ(session_.session().outcome(), study::Outcome::stopped);
  EXPECT_TRUE(until([&] { return page_.find("ended", seen().uuid) != nullptr; }));
  EXPECT_EQ(page_.find("press", "watch:pause"), nullptr);
}

TEST_F(DeskWatch, SaysThatNothingCanBeWritten) {
  const std::string control = study::requests_file(session_.file().string());
  std::filesystem::create_directory(control);
  page_.click("press", "watch:skip");
  page_.type("a long reason");
  page_.key(GLFW_KEY_ENTER);
  EXPECT_NE(page_.find("type", "watch:words"), nullptr) << "the words stay";
  EXPECT_TRUE(page_.page().asked().all().empty());
}

TEST(DeskWatchOfAFile, IsCalmWithoutOneAndSaysWhatIsWrongWithIt) {
  const TestFolder folder;
  std::ofstream(folder.file("wrong.db")) << "no database at all, but text that is long enough\n";
  for (const bool wrong : {false, true}) {
    PageBench page(folder.file(wrong ? "wrong.db" : "none.db"), {}, "ja");
    for (int k = 0; k < 5000 && page.page().seen() == nullptr; ++k) {
      page.frame();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    page.frame();
    ASSERT_NE(page.page().seen(), nullptr);
    EXPECT_EQ(page.page().seen()->waits, !wrong);
    EXPECT_EQ(page.page().seen()->is_input_error, wrong);
    EXPECT_EQ(page.find("press", "watch:pause"), nullptr);
  }
}

}  // namespace
}  // namespace promenade::app
