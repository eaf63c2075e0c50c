#include "study/outline.h"

#include <gtest/gtest.h>

namespace promenade::study {
namespace {

TEST(Outline, NamesInterfacesByNameElseByTypeInTheOrderOfTheFile) {
  const Outline outline = outline_of(
      "[[interface]]\ntype = \"weights\"\n[[task]]\nname = \"find\"\n"
      "[[interface]]\nname = \"a list\"\ntype = \"labels\"\n[[rating]]\nitem = \"ease\"\n");
  EXPECT_EQ(outline.interfaces, (std::vector<std::string>{"weights", "a list"}));
  EXPECT_EQ(outline.tasks, std::vector<std::string>{"find"});
  EXPECT_EQ(outline.ratings, std::vector<std::string>{"ease"});
}

TEST(Outline, NamesTargetsAndQualitiesOfAllTasksOnce) {
  const Outline outline = outline_of(
      "[[task]]\ntargets = [{ example = \"sad\" }, { name = \"mix\", weights = { a = 1 } }]\n"
      "practice = [{ example = \"happy\" }]\n"
      "[[task]]\nqualities = [{ name = \"tired\" }, { name = \"sad\" }]\n");
  EXPECT_EQ(outline.targets, (std::vector<std::string>{"sad", "mix", "tired"}));
}

TEST(Outline, NamesTheTasksInWhichOneGuesses) {
  const Outline outline = outline_of(
      "[[task]]\nname = \"a\"\nkind = \"guess\"\n[[task]]\nname = \"b\"\nkind = \"match\"\n"
      "[[task]]\nkind = \"guess\"\n[[task]]\nname = \"c\"\nkind = 3\n");
  EXPECT_EQ(outline.guesses, std::vector<std::string>{"a"});
}

TEST(Outline, OfWhatIsNoStudyIsEmpty) {
  for (const char* text : {"", "interface = 3", "[[interface]]\nname = 3", "{{{", "\xff\xfe"}) {
    EXPECT_TRUE(outline_of(text).interfaces.empty()) << text;
  }
}

}  // namespace
}  // namespace promenade::study
