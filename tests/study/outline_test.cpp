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

TEST(Outline, KnowsGuessesAndTheOrderOfTheInterfaces) {
  const Outline outline = outline_of(
      "[study]\norder = \"latin\"\n[[task]]\nname = \"blind\"\nkind = \"guess\"\n"
      "[[task]]\nname = \"match\"\nkind = \"match\"\n");
  EXPECT_EQ(outline.guesses, std::vector<std::string>{"blind"});
  EXPECT_EQ(outline.order, "latin");
  EXPECT_EQ(outline_of("[study]\n").order, "williams") << "what a study has that says nothing";
  EXPECT_EQ(outline_of("").order, "");
}

TEST(Outline, KnowsTypesThePublishedStudyAndWhatIsDrawn) {
  const Outline outline = outline_of(
      "[study]\npublished = \"oshita-2018\"\n[[interface]]\nname = \"a list\"\ntype = "
      "\"labels\"\n[[interface]]\nname = \"map\"\n"
      "[[task]]\nname = \"make\"\ntargets = [{ random = \"adjectives\" }, { example = \"sad\" }, "
      "{ random = \"adjectives\", name = \"b\" }]\n"
      "[[task]]\nname = \"rate\"\nkind = \"rate\"\ntargets = [{ random = \"pca\" }]\n");
  EXPECT_EQ(outline.types, (std::vector<std::string>{"labels", "map"}));
  EXPECT_EQ(outline.published, "oshita-2018");
  ASSERT_EQ(outline.draws.size(), 1U);
  EXPECT_EQ(outline.draws[0].task, "make");
  EXPECT_EQ(outline.draws[0].model, "adjectives");
}

TEST(Outline, OfWhatIsNoStudyIsEmpty) {
  for (const char* text : {"", "interface = 3", "[[interface]]\nname = 3", "{{{", "\xff\xfe"}) {
    EXPECT_TRUE(outline_of(text).interfaces.empty()) << text;
  }
}

}  // namespace
}  // namespace promenade::study
