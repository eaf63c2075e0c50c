#include "study/recipe.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "motion/bvh.h"
#include "motion/files.h"
#include "motion/set_file.h"
#include "study/load_study.h"
#include "tests/motion/walker.h"
#include "tests/source_dir.h"
#include "tests/test_folder.h"

namespace promenade::study {
namespace {

namespace fs = std::filesystem;

// A folder of the running test's own, empty at first.
fs::path own_folder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  static const TestFolder tests;
  const fs::path folder = tests.path() / test->name();
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
       "r.toml:4:9: error: no file in empty fits \"sub/*.bvh\""},
      {"name = 'x'\ncredit = 'y'\nfolder = 'empty'\nfiles = '../*.bvh'\n",
       "r.toml:4:9: error: a pattern is a path below `folder`, such as \"*/{style}_1.bvh\""},
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
       "r.toml:3:10: error: no file in empty fits \"*.bvh\"\n"
       "r.toml:4:19: error: \"cycles_per_take\" is 21, but must be from 1 to 20\n"
       "r.toml:5:10: error: \"unit_m\" must be a number, but is a text\n"
       "r.toml:6:6: error: \"up\" is \"x\", but must be one of \"y\", \"z\"; did you mean \"y\"?"},
      {"folder = 'empty'\n",
       "r.toml:1:1: error: \"name\" is missing here\n"
       "r.toml:1:1: error: \"credit\" is missing here\n"
       "r.toml:1:10: error: no file in empty fits \"*.bvh\""},
      {"name = 'x'\ncredit = 'y'\nfolder = 'empty'\nmost_loop_error_m = nan\n",
       "r.toml:3:10: error: no file in empty fits \"*.bvh\"\n"
       "r.toml:4:21: error: \"most_loop_error_m\" is nan, but must be from 0 to 1"},
  };
  for (const BrokenRecipe& broken : table) EXPECT_EQ(problems_of(broken.text), broken.said);
}

// A recipe that names takes, after three lines; a.bvh is there.
const std::string head = "name = 'x'\ncredit = 'y'\nfolder = 'full'\n";

std::string problems_with_takes(const std::string& text) {
  const fs::path folder = own_folder();
  write_file(folder / "full" / "a.bvh", "no capture, but a file");
  write_file(folder / "full" / "cuts.csv", "S,A,B\na,5,9\nb,x,9\n");
  write_file(folder / "r.toml", head + text);
  try {
    load_recipe((folder / "r.toml").string());
  } catch (const InputError& error) {
    std::string said = error.what();
    const std::string prefix = folder.string() + "/";
    for (std::size_t at; (at = said.find(prefix)) != said.npos;) said.erase(at, prefix.size());
    return said;
  }
  return {};
}

TEST(Recipe, OfNamedTakesIsRefusedWithEveryPlaceAndReason) {
  const std::vector<BrokenRecipe> table = {
      {"[[take]]\nfile = 'a.bvh'\n[[take]]\nfile = 'b.bvh'\n",
       "r.toml:7:8: error: there is no file full/b.bvh"},
      {"[[take]]\nfile = 'a.bvh'\n[[take]]\nfile = './a.bvh'\n",
       "r.toml:7:8: error: \"./a.bvh\" has a [[take]] already; give it several [[take.cycle]]"},
      {"[[take]]\nfile = 'a.bvh'\nfrom = 20\nto = 10\nstile = 'b'\n",
       "r.toml:7:6: error: the last frame must come after the first\n"
       "r.toml:8:1: error: unknown key \"stile\"; did you mean \"style\"?"},
      {"[[take]]\nfile = 'a.bvh'\n[[take.cycle]]\nfirst = 5\nlast = 25\nkeytimes = [9, 8, 12]\n",
       "r.toml:9:12: error: first, keytimes and last must ascend: they are frames of the file"},
      {"[[take]]\nfile = 'a.bvh'\n[[take.cycle]]\nfirst = 5\nlast = 25\nkeytimes = [9]\n",
       "r.toml:6:1: error: the cycle needs 3 keytimes between first and last: right foot on, left "
       "off, left on"},
      {"motion = 'other'\nkey_phases = [0, 0.5, 1]\n[[take]]\nfile = 'a.bvh'\n",
       "r.toml:6:1: error: a.bvh needs a [[take.cycle]]: keytimes of other motions than walks "
       "cannot "
       "be found, only loops without any between"},
      {"motion = 'other'\nkey_phases = [0, 0.6, 0.5, 1]\n[[take]]\nfile = 'a.bvh'\n"
       "[[take.cycle]]\nfirst = 1\nlast = 9\n",
       "r.toml:5:14: error: must ascend from 0 to 1\n"
       "r.toml:8:1: error: the cycle needs 2 keytimes between first and last as the others have"},
      {"[[take]]\nfile = 'a.bvh'\nasf = 'a.asf'\nframes_per_second = 0\n",
       "r.toml:6:7: error: there is no file full/a.asf\n"
       "r.toml:7:21: error: \"frames_per_second\" is 0, but must be from 1 to 1000"},
      {"skeleton = 'b.bvh'\n", "r.toml:4:12: error: is not one of the files that the recipe uses"},
      {"without = ['a.bvh']\n", "r.toml:3:10: error: no file in full fits \"*.bvh\""},
      {"[[take]]\nfile = 'a.bvh'\nuse = 'no'\n",
       "r.toml:6:7: error: \"use\" must be true or false, but is a text"},
  };
  for (const BrokenRecipe& broken : table) EXPECT_EQ(problems_with_takes(broken.text), broken.said);
}

TEST(Recipe, KnowsTakesThatItDoesNotUseWhateverBecameOfTheirFiles) {
  const fs::path folder = own_folder();
  write_file(folder / "full" / "a.bvh", "no capture, but a file");
  write_file(folder / "full" / "b.bvh", "another");
  write_file(folder / "r.toml", head +
                                    "files = '*.bvh'\n[[take]]\nfile = 'b.bvh'\nuse = false\n"
                                    "[[take]]\nfile = 'gone.bvh'\nuse = false\n");
  const Recipe recipe = load_recipe((folder / "r.toml").string());
  ASSERT_EQ(recipe.takes.size(), 1U);
  EXPECT_EQ(recipe.takes[0].label, "a.bvh");
  ASSERT_EQ(recipe.left_out.size(), 2U);
  EXPECT_EQ(recipe.left_out[1].label, "gone.bvh");
}

TEST(Recipe, WithoutItsFolderKnowsTheKeysOfTakesAndCutsAllTheSame) {
  EXPECT_EQ(problems_of("name = 'x'\ncredit = 'y'\nfolder = 'nowhere'\n"
                        "[[take]]\nfile = 'a.bvh'\nstlye = 'b'\n"
                        "[[take.cycle]]\nfrist = 1\nlast = 9\n"
                        "[cuts]\nfile = 'c.csv'\nstyle = 's'\nform = 'f'\nto = 't'\n"),
            "r.toml:3:10: error: there is no folder nowhere; give another one with --folder DIR\n"
            "r.toml:6:1: error: unknown key \"stlye\"; did you mean \"style\"?\n"
            "r.toml:7:1: error: \"first\" is missing here\n"
            "r.toml:8:1: error: unknown key \"frist\"; did you mean \"first\"?\n"
            "r.toml:10:1: error: \"from\" is missing here\n"
            "r.toml:13:1: error: unknown key \"form\"; did you mean \"from\"?");
}

TEST(Recipe, WithALineThatIsNoTomlSaysWhatElseIsWrong) {
  const std::string said = problems_of(
      "name = 'x\ncredit = 'y'\nfolder = 'nowhere'\ncycles_per_take = 99\nskelton = 'a'\n");
  EXPECT_EQ(said.rfind("r.toml:1:", 0), 0U) << said;
  EXPECT_NE(said.find("r.toml:4:19: error: \"cycles_per_take\" is 99"), said.npos) << said;
  EXPECT_NE(said.find("r.toml:5:1: error: unknown key \"skelton\""), said.npos) << said;
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 2) << said;
}

TEST(Recipe, NamesWhatIsWrongWithATableOfCuts) {
  const std::string good = "[cuts]\nfile = 'cuts.csv'\nstyle = 'S'\nfrom = 'A'\nto = 'B'\n";
  EXPECT_EQ(problems_with_takes(good), "");
  EXPECT_EQ(problems_with_takes("[cuts]\nfile = 'no.csv'\nstyle = 'S'\nfrom = 'A'\nto = 'B'\n"),
            "r.toml:5:8: error: there is no file full/no.csv");
  EXPECT_EQ(problems_with_takes("[cuts]\nfile = 'cuts.csv'\nstyle = 'S'\nfrom = 'C'\nto = 'B'\n"),
            "r.toml:7:8: error: full/cuts.csv has no column \"C\"");
  EXPECT_EQ(problems_with_takes("[[take]]\nfile = 'a.bvh'\nstyle = 'b'\n" + good),
            "full/cuts.csv:3:3: error: does not say from which to which frame a.bvh is good");
  EXPECT_EQ(problems_with_takes("[[take]]\nfile = 'a.bvh'\nstyle = 'z'\n" + good),
            "full/cuts.csv: error: has no row for the style \"z\"");
}

// The layout of 100STYLE: a folder for each style, and a table of good frames.
TEST(Recipe, FindsTakesInFoldersAndCutsThemByATable) {
  const fs::path folder = own_folder();
  for (const char* file : {"Angry/Angry_FW.bvh", "Angry/Angry_BW.bvh", "Old/Old_FW.bvh"}) {
    write_file(folder / "100STYLE" / file, "");
  }
  write_file(
      folder / "100STYLE" / "Frame_Cuts.csv",
      "STYLE_NAME,BW_START,BW_STOP,FW_START,FW_STOP\nAngry,1,2,163,4800\nOld,N/A,N/A,7,900\n");
  write_file(folder / "r.toml",
             "name = 'x'\ncredit = 'y'\nfolder = '100STYLE'\nfiles = '*/{style}_FW.bvh'\n"
             "[cuts]\nfile = 'Frame_Cuts.csv'\nstyle = 'STYLE_NAME'\nfrom = 'FW_START'\n"
             "to = 'FW_STOP'\n");
  const Recipe recipe = load_recipe((folder / "r.toml").string());
  ASSERT_EQ(recipe.takes.size(), 2U);
  EXPECT_EQ(recipe.takes[0].label, "Angry/Angry_FW.bvh");
  EXPECT_EQ(recipe.takes[0].style, "Angry");
  EXPECT_EQ(recipe.takes[0].from, 163);
  EXPECT_EQ(recipe.takes[1].to, 900);
}

TEST(Recipe, SaysMoreAboutSomeOfTheFilesOfAPattern) {
  const fs::path folder = own_folder();
  for (const char* file : {"sad.bvh", "old.bvh", "test.bvh"}) write_file(folder / file, "abc");
  write_file(folder / "r.toml",
             "name = 'x'\ncredit = 'y'\nfolder = '.'\nfiles = '*.bvh'\nwithout = ['test*']\n"
             "most_turn_deg = 90\nskeleton = 'sad.bvh'\n"
             "[[take]]\nfile = 'old.bvh'\nstyle = 'aged'\nunit_m = 0.0254\nup = 'z'\n"
             "[[take.cycle]]\nname = 'slow'\nfirst = 10\nlast = 50\nkeytimes = [20, 25.5, 40]\n");
  Recipe recipe = load_recipe((folder / "r.toml").string());
  hash_takes(recipe);
  ASSERT_EQ(recipe.takes.size(), 2U);
  EXPECT_EQ(recipe.takes[0].style, "aged");
  EXPECT_EQ(recipe.takes[0].figure.z_up, true);
  EXPECT_EQ(recipe.takes[0].cycles[0].frames, (std::vector<double>{10, 20, 25.5, 40, 50}));
  EXPECT_EQ(recipe.takes[1].style, "sad");
  EXPECT_NEAR(recipe.options.search.most_turn, M_PI / 2, 1e-12);
  // SHA-256 of "abc" is the first example of FIPS 180-2.
  EXPECT_EQ(recipe.takes[1].sha256,
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Recipe, OfEverySetThatComesWithTheProgramIsReadUpToItsFolder) {
  for (const auto& entry : fs::directory_iterator(source_dir() / "configs/sets")) {
    try {
      load_recipe(entry.path().string(), (own_folder() / "nowhere").string());
      FAIL() << entry.path();
    } catch (const InputError& error) {
      ASSERT_EQ(error.problems().size(), 1U) << error.what();
      EXPECT_NE(error.problems()[0].message.find("there is no folder"), std::string::npos);
    }
  }
}

TEST(Recipe, ThatIsNoTomlSaysSoAndNothingElse) {
  const std::string said = problems_of("name = 'x'\ncredit = = 'y'\n");
  EXPECT_EQ(said.rfind("r.toml:2:10: error: not valid TOML: ", 0), 0U) << said;
  EXPECT_EQ(said.find('\n'), said.npos) << said;
}

TEST(Recipe, ThatIsNotThereIsAnInputError) {
  EXPECT_THROW(load_recipe("/nowhere/r.toml"), InputError);
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
