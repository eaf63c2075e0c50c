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
  EXPECT_EQ(styles_of({"/x/walk_1.bvh", "/x/walk_2.bvh"}), (Texts{"walk", "walk"}));
  EXPECT_EQ(styles_of({"/x/02_01.bvh", "/x/07_01.bvh"}), (Texts{"02_01", "07_01"}));
  EXPECT_EQ(styles_of({"/x/angry walk.bvh"}), (Texts{"angry-walk"}));
}

TEST(CaptureFiles, LieBelowTheirCommonFolder) {
  EXPECT_EQ(common_folder({"/a/b/c.bvh", "/a/b/d/e.bvh"}), "/a/b");
  EXPECT_EQ(common_folder({"/a/b/c.bvh", "/a/bc/e.bvh"}), "/a");
  EXPECT_EQ(common_folder({"/a/c.bvh", "/e.bvh"}), "/");
  EXPECT_EQ(common_folder({}), "");
}

}  // namespace
}  // namespace promenade::study
