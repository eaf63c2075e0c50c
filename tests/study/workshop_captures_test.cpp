// The workshop on real captures, where they are at hand.
#include <set>

#include "motion/set_file.h"
#include "study/capture_files.h"
#include "study/recipe.h"
#include "tests/motion/captures.h"
#include "tests/study/walk_captures.h"

namespace promenade::study {
namespace {

namespace fs = std::filesystem;

class CapturedTakes : public motion::Captures {
 protected:
  void SetUp() override {
    motion::Captures::SetUp();
    if (!IsSkipped() && !fs::is_directory(folder())) GTEST_SKIP() << "There are no such captures.";
  }
  static fs::path folder() { return motion::data_folder() / "bandai-namco-walk"; }
  static std::string path(const std::string& name) {
    return (folder() / ("dataset-1_walk_" + name + ".bvh")).string();
  }
  void bring(const std::vector<std::string>& files) {
    workshop_.add(capture_files(files));
    read_all(workshop_);
  }

  TestFolder own_;
  Workshop workshop_;
};

TEST_F(CapturedTakes, AreNamedByTheirStylesAndAllWalk) {
  bring({path("happy_001"), path("happy_002"), path("old_001"), path("not-confident_001")});
  std::set<std::string> names;
  for (const WalkPlace& walk : workshop_.walks()) {
    names.insert(workshop_.takes()[walk.take].source.cycles[walk.cycle].name);
  }
  EXPECT_EQ(names, (std::set<std::string>{"happy_1", "happy_2", "not-confident_1", "old_1"}));
  for (std::size_t t = 0; t < 4; ++t) {
    EXPECT_TRUE(workshop_.review(t)->unit_guessed);
    EXPECT_EQ(workshop_.review(t)->figure.unit_m, 0.01);
    EXPECT_TRUE(workshop_.review(t)->gaps.empty()) << workshop_.label(t);
  }
}

TEST_F(CapturedTakes, MakeTheSetOfTheirRecipeByteForByte) {
  const std::string broken = own_.file("broken.bvh"), recipe_file = own_.file("w.recipe.toml");
  write_file(broken, damaged(read_file(path("sad_001")), 214));
  bring({path("happy_001"), path("old_001"), broken});
  EXPECT_EQ(workshop_.refused(), 1U);
  write_file(recipe_file, recipe_text(workshop_, recipe_file));
  make_set(recipe_file, own_.file("w.set"));
  Recipe recipe = load_recipe(recipe_file);
  hash_takes(recipe);
  EXPECT_EQ(read_file(own_.file("w.set")),
            motion::to_bytes(motion::build_set(recipe.takes, recipe.options).set));
}

TEST_F(CapturedTakes, OfAnotherSkeletonAreRefused) {
  const std::string other = (motion::data_folder() / "cmu" / "142_08-walk_happy.bvh").string();
  if (!fs::exists(other)) GTEST_SKIP() << "There is no " << other;
  bring({path("happy_001"), path("old_001"), other});
  int misfits = 0;
  for (std::size_t t = 0; t < 3; ++t) {
    misfits += workshop_.verdict(t).state == TakeState::misfit ? 1 : 0;
  }
  EXPECT_EQ(misfits, 1);
  EXPECT_EQ(workshop_.walks().size(), 2U);
}

}  // namespace
}  // namespace promenade::study
