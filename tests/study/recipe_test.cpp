#include "study/recipe.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "motion/bvh.h"
#include "motion/files.h"
#include "motion/set_file.h"
#include "study/load_study.h"
#include "tests/motion/walker.h"

namespace promenade::study {
namespace {

namespace fs = std::filesystem;

// A folder of the running test's own, empty at first.
fs::path own_folder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const fs::path folder = fs::path(testing::TempDir()) / "recipe_test" / test->name();
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

// All problems of a recipe, one a line, each without the folder that it lies in.
std::string problems_of(const std::string& text) {
  const fs::path folder = own_folder();
  write_file(folder / "r.toml", text);
  fs::create_directories(folder / "empty");
  std::string said;
  try {
    load_recipe((folder / "r.toml").string());
  } catch (const InputError& error) {
    said = error.what();
  }
  const std::string prefix = folder.string() + "/";
  for (std::size_t at; (at = said.find(prefix)) != said.npos;) said.erase(at, prefix.size());
  return said;
}

struct BrokenRecipe {
  const char* text;
  const char* said;
};

TEST(Recipe, ThatIsBrokenIsRefusedWithEveryPlaceAndReason) {
  const std::vector<BrokenRecipe> table = {
      {"name = 'x'\ncredit = 'y'\nfolder = 'nowhere'\n",
       "r.toml:3:10: error: there is no folder nowhere; give another one with --folder DIR"},
      {"name = 'x'\ncredit = 'y'\nfolder = 'empty'\nfiles = 'a*.bvh'\n",
       "r.toml:4:9: error: no file in empty fits \"a*.bvh\""},
      {"name = 'x'\ncredit = 'y'\nfolder = 'empty'\nfiles = 'sub/*.bvh'\n",
       "r.toml:4:9: error: is about names of files only; name the folder in `folder`"},
      {"name = 'x'\ncredit = 'y'\nfolder = 'empty'\nfiles = '*a*b*c*d*.bvh'\n",
       "r.toml:4:9: error: at most four * can stand in a pattern"},
      {"name = 'x'\ncredit = 'y'\nfolder = 'empty'\nfiles = '{style}_{style}.bvh'\n",
       "r.toml:4:9: error: {style} can stand only once in a pattern"},
      {"name = 'x'\ncredit = 'y'\nfolder = 'empty'\ncycle_per_take = 2\n",
       "r.toml:3:10: error: no file in empty fits \"*.bvh\"\n"
       "r.toml:4:1: error: unknown key \"cycle_per_take\"; did you mean \"cycles_per_take\"?"},
      {"name = ''\ncredit = 5\nfolder = 'empty'\ncycles_per_take = 21\nunit_m = 'cm'\nup = 'x'\n",
       "r.toml:1:8: error: \"name\" must not be empty\n"
       "r.toml:2:10: error: \"credit\" must be a text in quotes, but is a whole number\n"
       "r.toml:4:19: error: \"cycles_per_take\" is 21, but must be from 1 to 20\n"
       "r.toml:5:10: error: \"unit_m\" must be a number, but is a text\n"
       "r.toml:6:6: error: \"up\" is \"x\", but must be one of \"y\", \"z\"; did you mean \"y\"?"},
      {"folder = 'empty'\n",
       "r.toml:1:1: error: \"name\" is missing here\n"
       "r.toml:1:1: error: \"credit\" is missing here"},
      {"name = 'x'\ncredit = 'y'\nfolder = 'empty'\nmost_loop_error_m = nan\n",
       "r.toml:4:21: error: \"most_loop_error_m\" is nan, but must be from 0 to 1"},
  };
  for (const BrokenRecipe& broken : table) EXPECT_EQ(problems_of(broken.text), broken.said);
}

TEST(Recipe, ThatIsNoTomlSaysSoAndNothingElse) {
  const std::string said = problems_of("name = 'x'\ncredit = = 'y'\n");
  EXPECT_EQ(said.rfind("r.toml:2:10: error: not valid TOML: ", 0), 0U) << said;
  EXPECT_EQ(said.find('\n'), said.npos) << said;
}

TEST(Recipe, ThatIsNotThereIsAnInputError) {
  EXPECT_THROW(load_recipe("/nowhere/r.toml"), InputError);
}

TEST(StyleOf, IsWhatTheMarkStandsForOrTheWholeName) {
  EXPECT_EQ(style_of("walk_sad_1.bvh", "walk_{style}_*.bvh"), "sad");
  EXPECT_EQ(style_of("walk_not-so_sad_1.bvh", "walk_{style}_?.bvh"), "not-so_sad");
  EXPECT_EQ(style_of("sad.bvh", "*.bvh"), "sad");
  EXPECT_EQ(style_of("walk__1.bvh", "walk_{style}_1.bvh"), std::nullopt);
  EXPECT_EQ(style_of("sad.amc", "*.bvh"), std::nullopt);
}

TEST(StyleOf, TakesNoTimeWhereAPatternFitsInManyWays) {
  const std::string name(255, 'a');
  EXPECT_EQ(style_of(name, "*a*a*a*a*{style}*b"), std::nullopt);
  EXPECT_EQ(style_of(name + "b", "*a*a*a*a*{style}*b"), "a");
}

// Three generated walkers of four cycles each, as a laboratory would leave them, beside
// a recipe; and a file that the recipe does not want.
std::string walkers_recipe() {
  const fs::path folder = own_folder();
  const motion::MotionSet made = motion::builtin_set("A").value();
  for (const std::size_t i : {0U, 4U, 7U}) {
    const motion::Clip take = motion::walker_clip(made, made.cycles[i], 4);
    write_file(folder / "takes" / ("walk_" + made.cycles[i].style + "_001.bvh"),
               motion::bvh_text(take));
  }
  write_file(folder / "takes" / "notes.txt", "no capture");
  const std::string file = (folder / "r.toml").string();
  write_file(file,
             "name = 'walkers'\ncredit = 'nobody'\nfolder = 'takes'\n"
             "files = 'walk_{style}_*.bvh'\ncycles_per_take = 1\nunit_m = 1\nup = 'y'\n");
  return file;
}

TEST(Recipe, FindsItsTakesByNameAndStyle) {
  const Recipe recipe = load_recipe(walkers_recipe());
  const motion::MotionSet made = motion::builtin_set("A").value();
  ASSERT_EQ(recipe.takes.size(), 3U);
  for (const std::size_t i : {0U, 4U, 7U}) {
    const std::string& style = made.cycles[i].style;
    EXPECT_TRUE(std::any_of(recipe.takes.begin(), recipe.takes.end(), [&](const auto& take) {
      return take.style == style && take.label == "walk_" + style + "_001.bvh";
    })) << style;
  }
  EXPECT_TRUE(std::is_sorted(recipe.takes.begin(), recipe.takes.end(),
                             [](const auto& a, const auto& b) { return a.label < b.label; }));
  EXPECT_EQ(recipe.options.figure.z_up, false);
}

TEST(Recipe, BuildsASetOfClosedCyclesWhoseFeetStand) {
  const Recipe recipe = load_recipe(walkers_recipe());
  const motion::BuiltSet built = motion::build_set(recipe.takes, recipe.options);
  ASSERT_EQ(built.set.size(), 3);
  EXPECT_EQ(built.set.name, "walkers");
  for (std::size_t i = 0; i < 3; ++i) {
    const motion::Cycle& cycle = built.set.cycles[i];
    const motion::CycleReport& report = built.reports[i];
    EXPECT_EQ(cycle.name, cycle.style + "_1");
    EXPECT_EQ(cycle.source, recipe.takes[i].label);
    EXPECT_TRUE(std::is_sorted(cycle.keytimes.begin(), cycle.keytimes.end()));
    EXPECT_EQ(cycle.keytimes.back(), cycle.seconds);
    EXPECT_LT(report.seam.position_m, 1e-4);
    EXPECT_LT(report.seam.gap_m, 1.2 * report.seam.inside_m);
    EXPECT_LT(std::max(report.slide_left_m, report.slide_right_m), 0.008);
  }
}

TEST(Recipe, MakesASetThatAStudyCanName) {
  const fs::path folder = own_folder();
  const Recipe recipe = load_recipe(walkers_recipe());
  const motion::MotionSet set = motion::build_set(recipe.takes, recipe.options).set;
  write_file(folder / "walkers.set", motion::to_bytes(set));
  const motion::MotionSet back = load_motion_set((folder / "walkers.set").string(), "");
  EXPECT_EQ(motion::to_bytes(back), motion::to_bytes(set));
}

}  // namespace
}  // namespace promenade::study
