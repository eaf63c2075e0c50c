#include "study/workshop.h"

#include <gtest/gtest.h>

#include "motion/set_file.h"
#include "study/capture_files.h"
#include "study/recipe.h"
#include "tests/study/walk_captures.h"

namespace promenade::study {
namespace {

class Takes : public testing::Test {
 protected:
  void bring() {
    workshop_.add(capture_files({captures_.folder()}));
    read_all(workshop_);
  }
  std::size_t take(const std::string& label) const {
    for (std::size_t t = 0; t < workshop_.takes().size(); ++t) {
      if (workshop_.label(t) == label) return t;
    }
    throw std::logic_error("there is no take " + label);
  }
  const Verdict& verdict(const std::string& label) const { return workshop_.verdict(take(label)); }
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const WalkPlace& walk : workshop_.walks()) {
      names.push_back(workshop_.takes()[walk.take].source.cycles[walk.cycle].name);
    }
    return names;
  }
  std::string recipe_file() const { return captures_.file("made/walks.recipe.toml"); }
  motion::BuiltSet make() {
    write_file(recipe_file(), recipe_text(workshop_, recipe_file()));
    return make_set(recipe_file(), captures_.file("made/walks.set"));
  }

  WalkCaptures captures_;
  Workshop workshop_;
};

using Names = std::vector<std::string>;

TEST_F(Takes, GiveEachItsBestLoopNamedByItsStyle) {
  captures_.add_walks();
  bring();
  EXPECT_EQ(names(), (Names{"happy_1", "happy_2", "sad_1"}));
  EXPECT_EQ(workshop_.refused(), 0U);
}

TEST_F(Takes, ThatCannotBeReadSayWhereReadingStopped) {
  captures_.add_walks();
  captures_.add_broken();
  bring();
  const Verdict& broken = verdict("walk_broken_001.bvh");
  EXPECT_EQ(broken.state, TakeState::unreadable);
  EXPECT_EQ(broken.line, WalkCaptures::lost_line);
  EXPECT_FALSE(broken.reason.empty());
  EXPECT_EQ(workshop_.walks().size(), 3U);
}

TEST_F(Takes, ThatTurnAndThoseOfOtherSkeletonsAreRefusedAsTheSetRefusesThem) {
  captures_.add_walks();
  captures_.add_turning();
  captures_.add_misfit();
  bring();
  const std::size_t round = take("walk_round_001.bvh");
  EXPECT_EQ(workshop_.verdict(round).state, TakeState::no_loop);
  EXPECT_EQ(workshop_.review(round)->kind, motion::TakeKind::turns);
  EXPECT_EQ(verdict("walk_stranger_001.bvh").state, TakeState::misfit);
  std::map<std::string, std::string> refusals;
  for (const motion::CycleReport& report : make().reports) refusals[report.file] = report.refusal;
  ASSERT_EQ(refusals.size(), 5U);
  for (const auto& [label, refusal] : refusals) EXPECT_EQ(verdict(label).reason, refusal) << label;
}

TEST_F(Takes, MakeTheVerySetThatTheirRecipeMakes) {
  captures_.add_walks();
  captures_.add_broken();
  captures_.add_turning();
  bring();
  workshop_.describe("mine", "Anna \"and\" Ben\\");
  workshop_.move_end({take("walk_sad_001.bvh"), 0}, true, 55.5, 1);
  workshop_.rename({take("walk_happy_002.bvh"), 0}, "merry");
  const motion::BuiltSet made = make();
  Recipe recipe = load_recipe(recipe_file());
  hash_takes(recipe);
  const motion::MotionSet again = motion::build_set(recipe.takes, recipe.options).set;
  EXPECT_EQ(read_file(captures_.file("made/walks.set")), motion::to_bytes(again));
  EXPECT_EQ(motion::names_of(made.set), (Names{"happy_1", "merry", "sad_1"}));
  EXPECT_EQ(made.set.credit, "Anna \"and\" Ben\\");
}

TEST_F(Takes, ComeBackFromTheirRecipeAsTheyWere) {
  captures_.add_walks();
  captures_.add_broken();
  bring();
  workshop_.rename({take("walk_happy_002.bvh"), 0}, "merry");
  workshop_.remove({take("walk_sad_001.bvh"), 0});
  workshop_.set_unit({take("walk_happy_001.bvh")}, 1);
  const std::string text = recipe_text(workshop_, recipe_file());
  write_file(recipe_file(), text);
  Workshop again;
  again.open(recipe_file());
  read_all(again);
  EXPECT_EQ(recipe_text(again, recipe_file()), text);
  EXPECT_EQ(again.takes().size(), 4U);
  EXPECT_EQ(again.walks().size(), 2U);
}

TEST_F(Takes, ThatARecipeTakesThePlaceOfComeBackByUndo) {
  captures_.add_walks();
  bring();
  write_file(recipe_file(), recipe_text(workshop_, recipe_file()));
  workshop_.rename({take("walk_sad_001.bvh"), 0}, "gloomy");
  const int step = workshop_.step();
  workshop_.open(recipe_file());
  read_all(workshop_);
  EXPECT_EQ(names(), (Names{"happy_1", "happy_2", "sad_1"}));
  EXPECT_EQ(workshop_.recipe(), recipe_file());
  EXPECT_NE(workshop_.step(), step);
  workshop_.undo();
  EXPECT_EQ(names(), (Names{"happy_1", "happy_2", "gloomy"}));
  EXPECT_EQ(workshop_.recipe(), "");
  EXPECT_EQ(workshop_.step(), step);
}

TEST_F(Takes, OfARecipeThatFindsItsCyclesGiveTheSameOnesAtTheDesk) {
  captures_.add_walks();
  const std::string file = captures_.file("plain.toml");
  write_file(file,
             "name = 'x'\ncredit = 'y'\nfolder = 'captures'\n"
             "files = 'walk_{style}_*.bvh'\ncycles_per_take = 2\n");
  workshop_.open(file);
  read_all(workshop_);
  const Recipe recipe = load_recipe(file);
  const motion::MotionSet set = motion::build_set(recipe.takes, recipe.options).set;
  EXPECT_EQ(names(), motion::names_of(set));
  for (std::size_t k = 0; k < set.cycles.size(); ++k) {
    const WalkPlace walk = workshop_.walks()[k];
    const std::vector<double>& frames =
        workshop_.takes()[walk.take].source.cycles[walk.cycle].frames;
    EXPECT_NEAR(set.cycles[k].first_frame, frames.front(), 0.51);
  }
}

TEST_F(Takes, OfWhichOnlyAPartIsUsedKeepTheFramesOfTheirFiles) {
  captures_.add_walks();
  const std::string file = captures_.file("part.toml");
  write_file(file,
             "name = 'x'\ncredit = 'y'\nfolder = 'captures'\n"
             "[[take]]\nfile = 'walk_sad_001.bvh'\nfrom = 60\n");
  workshop_.open(file);
  read_all(workshop_);
  ASSERT_EQ(workshop_.walks().size(), 1U);
  const std::vector<double> frames = workshop_.takes()[0].source.cycles[0].frames;
  EXPECT_GE(frames.front(), 60);
  workshop_.move_end({0, 0}, false, workshop_.order_of({0, 0}).keys.front() - 1, 1);
  EXPECT_EQ(workshop_.takes()[0].source.cycles[0].frames.front(), frames.front() - 1);
  EXPECT_NEAR(make().set.cycles[0].first_frame, frames.front() - 1, 0.51);
}

TEST_F(Takes, AreUndoneStepByStepAndADragAtOnce) {
  captures_.add_walks();
  bring();
  const WalkPlace walk{take("walk_sad_001.bvh"), 0};
  const std::vector<double> before = workshop_.takes()[walk.take].source.cycles[0].frames;
  for (int k = 1; k < 5; ++k) workshop_.move_end(walk, true, before.back() - 0.5 * k, 7);
  workshop_.rename(walk, "gloomy");
  workshop_.remove(walk);
  EXPECT_EQ(names(), (Names{"happy_1", "happy_2"}));
  workshop_.undo();
  EXPECT_EQ(names(), (Names{"happy_1", "happy_2", "gloomy"}));
  workshop_.undo();
  EXPECT_EQ(names(), (Names{"happy_1", "happy_2", "sad_1"}));
  workshop_.undo();
  EXPECT_EQ(workshop_.takes()[walk.take].source.cycles[0].frames, before);
  for (int k = 0; k < 3; ++k) workshop_.redo();
  EXPECT_EQ(names(), (Names{"happy_1", "happy_2"}));
  EXPECT_FALSE(workshop_.can_redo());
}

TEST_F(Takes, AreNamedOnceOnly) {
  captures_.add_walks();
  bring();
  EXPECT_FALSE(workshop_.rename({0, 0}, "sad_1"));
  EXPECT_FALSE(workshop_.rename({0, 0}, ""));
  EXPECT_FALSE(workshop_.can_undo() && (workshop_.undo(), workshop_.takes().size() == 3U))
      << "only bringing them is undone";
}

TEST_F(Takes, ThatComeTwiceAreThereOnce) {
  captures_.add_walks();
  bring();
  EXPECT_EQ(workshop_.add(capture_files({captures_.folder()})), 0);
  EXPECT_EQ(workshop_.takes().size(), 3U);
}

TEST_F(Takes, WhoseUnitIsSaidNeedNotBeReadAgainUnlessItIsAnother) {
  captures_.add_walks();
  bring();
  EXPECT_TRUE(workshop_.review(0)->unit_guessed);
  workshop_.set_unit({0, 1, 2}, 1);
  EXPECT_FALSE(workshop_.unread());
  workshop_.set_unit({0}, 0.01);
  EXPECT_TRUE(workshop_.unread());
}

TEST_F(Takes, GiveSeveralLoopsIfSomebodyWantsThem) {
  captures_.add_walks();
  bring();
  const auto review = workshop_.review(2);
  const auto& loops = review->search.candidates;
  ASSERT_GE(loops.size(), 2U);
  workshop_.add_loop(2, loops[1].keys);
  EXPECT_EQ(names().back(), "sad_2");
  workshop_.remove({2, 0});
  EXPECT_EQ(names().back(), "sad_2");
  EXPECT_EQ(names().size(), 3U);
}

TEST_F(Takes, StopWithoutASetWhenSomebodyWantsThat) {
  captures_.add_walks();
  bring();
  write_file(recipe_file(), recipe_text(workshop_, recipe_file()));
  const auto stop = [](int step, int steps) {
    EXPECT_EQ(steps, 6);
    if (step == 4) throw OutsideError("stopped");
  };
  EXPECT_THROW(make_set(recipe_file(), captures_.file("made/walks.set"), stop), OutsideError);
  EXPECT_FALSE(std::filesystem::exists(captures_.file("made/walks.set")));
}

}  // namespace
}  // namespace promenade::study
