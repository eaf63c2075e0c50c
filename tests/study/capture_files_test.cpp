#include "study/capture_files.h"

#include <gtest/gtest.h>

#include "motion/files.h"
#include "tests/test_folder.h"

namespace promenade::study {
namespace {

using Texts = std::vector<std::string>;

TEST(CaptureFiles, OfAFolderAreItsCapturesAndThoseBelow) {
  const TestFolder folder;
  for (const char* name : {"b.bvh", "a.BVH", "notes.txt", "below/c.amc", "below/c.asf"}) {
    write_file(folder.path() / name, "x");
  }
  EXPECT_EQ(capture_files({folder.path().string()}),
            (Texts{folder.file("a.BVH"), folder.file("b.bvh"), folder.file("below/c.amc")}));
}

TEST(CaptureFiles, NamedThemselvesAreTakenWhateverTheyAreAndOnce) {
  const TestFolder folder;
  write_file(folder.file("notes.txt"), "x");
  EXPECT_EQ(capture_files(
                {folder.file("notes.txt"), folder.file("notes.txt"), folder.file("missing.bvh")}),
            (Texts{folder.file("missing.bvh"), folder.file("notes.txt")}));
}

TEST(CaptureFiles, SayTheirStylesByTheWordsInWhichTheyDiffer) {
  EXPECT_EQ(styles_of({"/x/set-1_walk_happy_001.bvh", "/x/set-1_walk_not-confident_002.bvh"}),
            (Texts{"happy", "not-confident"}));
  EXPECT_EQ(styles_of({"/x/a_happy_walk_1.bvh", "/x/a_sad_walk_2.bvh"}), (Texts{"happy", "sad"}));
  EXPECT_EQ(styles_of({"/x/a_walk_1.bvh", "/x/a_sad_walk_2.bvh"}), (Texts{"walk", "sad"}));
  EXPECT_EQ(styles_of({"/x/walk_1.bvh", "/x/walk_2.bvh"}), (Texts{"walk", "walk"}));
  EXPECT_EQ(styles_of({"/x/02_01.bvh", "/x/07_01.bvh"}), (Texts{"02_01", "07_01"}));
  EXPECT_EQ(styles_of({"/x/angry walk.bvh"}), (Texts{"angry-walk"}));
}

TEST(CaptureFiles, OfSeveralSeriesInAHeapAreNamedWithinTheirOwn) {
  const Texts files = {"/x/07_01-walk.bvh", "/x/set_walk_happy_001.bvh", "/x/set_walk_sad_001.bvh",
                       "/y/set_walk_sad_001.bvh"};
  EXPECT_EQ(styles_of(files), (Texts{"07-01-walk", "happy", "sad", "sad"}));
  EXPECT_EQ(short_names(files),
            (Texts{"07_01-walk", "happy_001", "sad_001", "set_walk_sad_001.bvh"}));
  EXPECT_EQ(short_names({"/x/walk_1.bvh", "/x/walk_2.bvh"}), (Texts{"walk_1", "walk_2"}));
}

TEST(CaptureFiles, ShowTheLinesAroundOneThatIsWrong) {
  const TestFolder folder;
  write_file(folder.file("a.bvh"), "one\ntwo\nthree\tx 0123456789\n\nfive\n");
  const std::vector<FileLine> lines = lines_around(folder.file("a.bvh"), 3, 9, 1, 8);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0].text, "two");
  EXPECT_EQ(lines[1].number, 3);
  EXPECT_EQ(lines[1].text, "… e x 0123 …");
  EXPECT_TRUE(lines_around(folder.file("missing.bvh"), 3, 0, 1, 8).empty());
}

TEST(CaptureFiles, LieBelowTheirCommonFolder) {
  EXPECT_EQ(common_folder({"/a/b/c.bvh", "/a/b/d/e.bvh"}), "/a/b");
  EXPECT_EQ(common_folder({"/a/b/c.bvh", "/a/bc/e.bvh"}), "/a");
  EXPECT_EQ(common_folder({"/a/c.bvh", "/e.bvh"}), "/");
  EXPECT_EQ(common_folder({}), "");
}

}  // namespace
}  // namespace promenade::study
