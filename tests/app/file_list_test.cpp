#include "app/file_list.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "motion/files.h"
#include "tests/test_folder.h"

namespace promenade::app {
namespace {

std::vector<std::string> names_of(const std::vector<ListedFile>& files) {
  std::vector<std::string> names;
  for (const ListedFile& file : files) names.push_back(file.name + (file.folder ? "/" : ""));
  return names;
}

using Names = std::vector<std::string>;

TEST(FileList, ShowsFoldersFirstAndOnlyWhatIsWanted) {
  const TestFolder folder;
  for (const char* name : {"b.bvh", "A.BVH", "notes.txt", ".hidden.bvh", "z/c.bvh", "Y/c.bvh"}) {
    write_file(folder.path() / name, "x");
  }
  EXPECT_EQ(names_of(list_folder(folder.path(), {".bvh"})),
            (Names{"../", "Y/", "z/", "A.BVH", "b.bvh"}));
}

TEST(FileList, OfAFolderThatCannotBeReadLeadsUp) {
  EXPECT_EQ(names_of(list_folder("/nowhere/at/all", {".bvh"})), (Names{"../"}));
}

TEST(FileList, OfTheRootLeadsNowhereUp) {
  for (const ListedFile& file : list_folder("/", {})) EXPECT_NE(file.name, "..");
}

}  // namespace
}  // namespace promenade::app
