// From takes to walks, by mouse and by keyboard; the set is what `promenade set build` makes.
#include "app/desk/takes/takes_page.h"

#include "app/desk/words.h"
#include "app/tool_page.h"
#include "motion/set_file.h"
#include "study/recipe.h"
#include "tests/app/hands.h"
#include "tests/study/walk_captures.h"

namespace promenade::app {
namespace {

namespace fs = std::filesystem;

class TakesDesk : public bench::HandsTest {
 protected:
  explicit TakesDesk(int width = 1280, int height = 720)
      : words_(desk_texts("en")), gui_(make_palette(false), {"日本語"}), page_(studies()) {
    bench::fit_without_card(gui_, width, height);
    frames(2);
  }
  std::string studies() const { return captures_.file("studies"); }
  void draw_frame() override {
    page_.advance(now_us_);
    tool_.frame(gui_, [this](const Ui& ui) {
      const ImVec2 size = ImGui::GetIO().DisplaySize;
      page_.draw(ui, words_, {0, 0, size.x, size.y});
    });
  }
  const WidgetMap& widgets() const override { return tool_.widgets(); }
  const Focus& focus() const override { return tool_.focus(); }
  void bring() {
    page_.dropped({captures_.folder()});
    settle();
  }
  void settle() {
    ASSERT_TRUE(wait_until([this] {
      return page_.work().to_read() == 0 && !page_.work().busy() && !page_.work().shop().uncut();
    }));
    frames(2);
  }
  void undo() { control(GLFW_KEY_Z); }
  bool shows(const std::string& text) const {
    const std::vector<std::string>& words = page_.shown_words();
    return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
      return word.find(text) != std::string::npos;
    });
  }
  std::vector<std::string> names() {
    std::vector<std::string> names;
    for (const study::WalkPlace& walk : page_.work().shop().walks()) {
      names.push_back(cycle(walk).name);
    }
    return names;
  }
  const motion::GivenCycle& cycle(const study::WalkPlace& walk) {
    return page_.work().shop().takes()[walk.take].source.cycles[walk.cycle];
  }
  double last_frame() { return cycle(*page_.work().walk()).frames.back(); }
  double first_frame() { return cycle(*page_.work().walk()).frames.front(); }

  study::WalkCaptures captures_;
  study::Texts words_;
  Gui gui_;
  ToolPage tool_{queue_};
  TakesPage page_;
};

using Names = std::vector<std::string>;

TEST_F(TakesDesk, TakesInWhatIsDroppedAndMakesWalksOfIt) {
  captures_.add_walks();
  captures_.add_broken();
  bring();
  EXPECT_TRUE(has("take", "walk_broken_001.bvh"));
  EXPECT_TRUE(has("tile", "walk_happy_001.bvh/0"));
  EXPECT_FALSE(has("tile", "walk_broken_001.bvh/0"));
  EXPECT_EQ(page_.work().listed().front(), 0U) << "what failed stands first";
}

TEST_F(TakesDesk, SaysInPlainWordsWhyATakeFailed) {
  captures_.add_walks();
  captures_.add_broken();
  captures_.add_turning();
  captures_.add_misfit();
  bring();
  const study::Workshop& shop = page_.work().shop();
  std::map<std::string, std::string> chips;
  for (std::size_t t = 0; t < shop.takes().size(); ++t) {
    chips[shop.label(t)] = chip_of(shop, t, words_).words;
    EXPECT_EQ(reason_of(shop, t, words_).empty(), !shop.verdict(t).refused());
  }
  EXPECT_EQ(chips["walk_broken_001.bvh"], "cannot read: line 150");
  EXPECT_EQ(chips["walk_round_001.bvh"], "turns, no straight walk");
  EXPECT_EQ(chips["walk_stranger_001.bvh"], "other skeleton");
  EXPECT_EQ(chips["walk_sad_001.bvh"], "3 loops");
  click("take", "walk_broken_001.bvh");
  EXPECT_FALSE(has("edge", "last")) << "there is nothing to cut";
  click("press", "forget");
  EXPECT_FALSE(has("take", "walk_broken_001.bvh"));
  undo();
  EXPECT_TRUE(has("take", "walk_broken_001.bvh"));
}

TEST_F(TakesDesk, DragsAnEndOfALoopAndUndoesItAtOnce) {
  captures_.add_walks();
  bring();
  click("take", "walk_sad_001.bvh");
  const double before = last_frame();
  const Box edge = widget("edge", "last").box;
  const float frame = widget("edge", "last").unit_x;  // pixels
  const float hand = edge.x + 2;                      // well within the loop's own band
  move_to(hand, edge.middle_y());
  button(true);
  for (int k = 1; k <= 4; ++k) move_to(hand - static_cast<float>(k) * frame / 2, edge.y);
  button(false);
  EXPECT_NEAR(last_frame(), before - 2, 1 / frame + 0.01) << "a pixel";
  settle();
  const auto loop = page_.work().loop(*page_.work().walk());
  EXPECT_NEAR(loop->cut.keys.back(), last_frame(), 1e-9) << "the numbers follow";
  undo();
  EXPECT_EQ(last_frame(), before);
}

TEST_F(TakesDesk, MovesAnEndByAFrameWithTheArrowKeys) {
  captures_.add_walks();
  bring();
  const double before = first_frame();
  tab_to("edge", "first");
  key(GLFW_KEY_LEFT);
  EXPECT_NEAR(first_frame(), before - 1, 1e-9);
  key(GLFW_KEY_RIGHT);
  EXPECT_NEAR(first_frame(), before, 1e-9);
}

TEST_F(TakesDesk, GoesFromLoopToLoopWithTheArrowsUpAndDown) {
  captures_.add_walks();
  bring();
  tab_to("edge", "first");
  for (int k = 0; k < 5; ++k) key(GLFW_KEY_UP);
  const double first = first_frame();
  key(GLFW_KEY_DOWN);
  EXPECT_GT(first_frame(), first + 5);
  key(GLFW_KEY_UP);
  EXPECT_EQ(first_frame(), first);
}

TEST_F(TakesDesk, ChoosesAnotherLoopByAPress) {
  captures_.add_walks();
  bring();
  const double before = first_frame();
  for (const char* loop : {"0", "1"}) {
    click("loop", loop);
    if (first_frame() != before) break;
  }
  EXPECT_NE(first_frame(), before);
  undo();
  EXPECT_EQ(first_frame(), before);
}

TEST_F(TakesDesk, GivesASecondWalkOfATake) {
  captures_.add_walks();
  bring();
  click("take", "walk_sad_001.bvh");
  click("press", "another_loop");
  EXPECT_EQ(names().back(), "sad_2");
  EXPECT_EQ(page_.work().walk()->cycle, 1U);
  click("press", "leave_out");
  EXPECT_EQ(names(), (Names{"happy_1", "happy_2"}));
  click("press", "leave_out");
  EXPECT_EQ(names().size(), 4U);
}

TEST_F(TakesDesk, RenamesAndRemovesInPlace) {
  captures_.add_walks();
  bring();
  click("rename", "walk_sad_001.bvh/0");
  for (int k = 0; k < 10; ++k) key(GLFW_KEY_BACKSPACE);
  type("gloomy");
  key(GLFW_KEY_ENTER);
  EXPECT_EQ(names(), (Names{"happy_1", "happy_2", "gloomy"}));
  click("remove", "walk_happy_001.bvh/0");
  EXPECT_EQ(names(), (Names{"happy_2", "gloomy"}));
  undo();
  undo();
  EXPECT_EQ(names(), (Names{"happy_1", "happy_2", "sad_1"}));
}

TEST_F(TakesDesk, IsWorkedByTheKeyboardAlone) {
  captures_.add_walks();
  tab_to("type", "path");
  type(captures_.folder());
  key(GLFW_KEY_ENTER);
  settle();
  ASSERT_EQ(names().size(), 3U);
  tab_to("tile", "walk_happy_002.bvh/0");
  key(GLFW_KEY_ENTER);
  type("x");
  key(GLFW_KEY_ENTER);
  EXPECT_NE(names()[1], "happy_2");
  key(GLFW_KEY_DELETE);
  EXPECT_EQ(names(), (Names{"happy_1", "sad_1"}));
  tab_to("take", "walk_happy_002.bvh");
  key(GLFW_KEY_UP);
  EXPECT_TRUE(tool_.focus().on("take", "walk_sad_001.bvh"));
  const bool playing = page_.work().playing();
  key(GLFW_KEY_SPACE);
  EXPECT_NE(page_.work().playing(), playing);
}

TEST_F(TakesDesk, ConfirmsTheUnitOfAllTakesAtOnce) {
  captures_.add_walks();
  bring();
  click("press", "unit_right");
  for (const study::WorkshopTake& take : page_.work().shop().takes()) {
    EXPECT_EQ(take.source.figure.unit_m, 1.0) << take.source.file;
  }
  EXPECT_FALSE(has("press", "unit_right"));
}

TEST_F(TakesDesk, MakesTheSetThatTheProgramMakesOfTheRecipe) {
  captures_.add_walks();
  captures_.add_broken();
  bring();
  click("press", "make");
  ASSERT_TRUE(wait_until([this] { return page_.work().made().done(); }))
      << page_.work().made().trouble;
  const std::string set = studies() + "/sets/walks.set";
  EXPECT_EQ(page_.work().made().file, set);
  EXPECT_EQ(page_.work().made().walks, 3);
  EXPECT_FALSE(page_.work().changed_since_made());
  study::Recipe recipe = study::load_recipe(study::recipe_beside(set));
  study::hash_takes(recipe);
  EXPECT_EQ(read_file(set), motion::to_bytes(motion::build_set(recipe.takes, recipe.options).set));
  click("remove", "walk_sad_001.bvh/0");
  EXPECT_TRUE(page_.work().changed_since_made());
}

TEST_F(TakesDesk, OpensItsRecipeAgain) {
  captures_.add_walks();
  bring();
  click("remove", "walk_happy_001.bvh/0");
  click("press", "make");
  ASSERT_TRUE(wait_until([this] { return page_.work().made().done(); }));
  TakesPage again(studies());
  again.dropped({studies() + "/sets/walks.recipe.toml"});
  EXPECT_EQ(again.foot().file(), studies() + "/sets/walks.set");
  EXPECT_EQ(again.work().shop().takes().size(), 3U);
}

TEST_F(TakesDesk, IsUnsavedUntilTheSetIsMade) {
  captures_.add_walks();
  EXPECT_FALSE(page_.unsaved());
  bring();
  EXPECT_TRUE(page_.unsaved());
  click("press", "make");
  ASSERT_TRUE(wait_until([this] { return page_.work().made().done(); }));
  EXPECT_FALSE(page_.unsaved());
  click("remove", "walk_sad_001.bvh/0");
  EXPECT_TRUE(page_.unsaved());
  undo();
  EXPECT_FALSE(page_.unsaved());
}

TEST_F(TakesDesk, SavesItsRecipeWhereNoOtherLies) {
  captures_.add_walks();
  bring();
  page_.save();
  EXPECT_FALSE(page_.unsaved());
  TakesPage again(studies());
  EXPECT_EQ(again.foot().file(), studies() + "/sets/walks-2.set");
  again.dropped({studies() + "/sets/walks.recipe.toml"});
  EXPECT_EQ(again.work().shop().takes().size(), 3U);
  EXPECT_FALSE(again.unsaved());
}

TEST_F(TakesDesk, StaysUnsavedWhereNothingCanBeWritten) {
  captures_.add_walks();
  bring();
  write_file(studies() + "/sets", "in the way");
  page_.save();
  EXPECT_FALSE(page_.work().made().trouble.empty());
  EXPECT_TRUE(page_.unsaved());
  fs::remove(studies() + "/sets");
  page_.save();
  EXPECT_EQ(page_.work().made().trouble, "");
  EXPECT_FALSE(page_.unsaved());
}

TEST_F(TakesDesk, BringsBackWhatARecipeTookThePlaceOf) {
  captures_.add_walks();
  bring();
  page_.work().save(captures_.file("other/old.set"));
  click("remove", "walk_sad_001.bvh/0");
  page_.dropped({captures_.file("other/old.recipe.toml")});
  settle();
  EXPECT_EQ(names().size(), 3U);
  EXPECT_EQ(page_.foot().file(), captures_.file("other/old.set"));
  undo();
  EXPECT_EQ(names().size(), 2U);
  EXPECT_EQ(page_.foot().file(), studies() + "/sets/walks.set");
  EXPECT_TRUE(page_.unsaved());
}

TEST_F(TakesDesk, SaysWhyASetCannotBeMade) {
  captures_.add_walks();
  bring();
  for (const char* name : {"walk_happy_001.bvh", "walk_happy_002.bvh", "walk_sad_001.bvh"}) {
    fs::remove(captures_.folder() + "/" + name);
  }
  click("press", "make");
  ASSERT_TRUE(wait_until([this] { return !page_.work().made().working; }));
  EXPECT_FALSE(page_.work().made().trouble.empty());
  EXPECT_FALSE(fs::exists(studies() + "/sets/walks.set"));
}

TEST_F(TakesDesk, HasTheCharactersOfATroubleAndOfWhatIsWritten) {
  EXPECT_FALSE(shows("無"));
  page_.dropped({captures_.file("無.toml")});
  EXPECT_TRUE(shows("無"));
  click("type", "credit");
  type("歩");
  EXPECT_TRUE(shows("歩"));
  click("type", "path");
  type("道");
  EXPECT_TRUE(shows("道"));
  write_file(studies() + "/sets", "in the way");
  page_.save();
  EXPECT_TRUE(shows(page_.work().made().trouble));
}

TEST_F(TakesDesk, HasTheCharactersOfTheLinesOfABrokenFile) {
  captures_.add_walks();
  captures_.add_broken();
  bring();
  const std::string line = study::lines_around(captures_.folder() + "/walk_broken_001.bvh",
                                               study::WalkCaptures::lost_line, 1, 3, 64)
                               .front()
                               .text;
  click("take", "walk_broken_001.bvh");
  EXPECT_TRUE(shows(line));
}

TEST_F(TakesDesk, PutsASetIntoAFolderThatIsNamedFromHere) {
  const TakesPage page("nowhere/studies");
  EXPECT_EQ(page.foot().file(), (fs::current_path() / "nowhere/studies/sets/walks.set").string());
}

TEST_F(TakesDesk, FindsCapturesInItsFolders) {
  captures_.add_walks();
  click("press", "browse_first");
  ASSERT_TRUE(has("press", "add_folder"));
  click("press", "browse_end");
  EXPECT_FALSE(has("press", "add_folder"));
}

class LargeTakesDesk : public TakesDesk {
 protected:
  LargeTakesDesk() : TakesDesk(2560, 1440) {}
};

TEST_F(LargeTakesDesk, HasRoomForTheSameThings) {
  captures_.add_walks();
  bring();
  for (const auto& [kind, target] : {std::pair{"edge", "first"},
                                     {"press", "make"},
                                     {"tile", "walk_sad_001.bvh/0"},
                                     {"slide", "time"}}) {
    EXPECT_TRUE(widget(kind, target).visible()) << target;
  }
}

}  // namespace
}  // namespace promenade::app
