#include "study/toml_reader.h"

#include <gtest/gtest.h>

namespace promenade::study {
namespace {

// All problems as text, one a line.
std::string problems_of(TomlReader& reader) {
  try {
    reader.finish();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(TomlReader, GivesTypedValues) {
  TomlReader reader("a.toml", "word = 'sad'\nlimit = 45\nfast = true\nlist = ['x', 'y']\n");
  const TomlTable root = reader.root();
  EXPECT_EQ(root.text("word"), "sad");
  EXPECT_EQ(root.number("limit", 0, 100), 45.0);
  EXPECT_EQ(root.boolean("fast"), true);
  EXPECT_EQ(root.texts("list").at(1).text, "y");
  EXPECT_EQ(root.text("absent"), std::nullopt);
  EXPECT_EQ(problems_of(reader), "");
}

TEST(TomlReader, NamesTheKeyThatWasMeant) {
  TomlReader reader("a.toml", "[task]\nlimt_s = 45\n");
  reader.root().table("task")->number("limit_s", 0, 100);
  EXPECT_EQ(problems_of(reader),
            "a.toml:2:1: error: unknown key \"limt_s\"; did you mean \"limit_s\"?");
}

TEST(TomlReader, ReportsAllProblemsInTheOrderOfTheFile) {
  TomlReader reader("a.toml", "a = 1\nb = 'x'\nc = 900\n");
  reader.root().number("c", 0, 100);
  reader.root().text("a");
  EXPECT_EQ(problems_of(reader),
            "a.toml:1:5: error: \"a\" must be a text in quotes, but is a whole number\n"
            "a.toml:2:1: error: unknown key \"b\"; did you mean \"a\"?\n"
            "a.toml:3:5: error: \"c\" is 900, but must be from 0 to 100");
}

TEST(TomlReader, RefusesNotANumberAsOutOfRange) {
  TomlReader reader("a.toml", "a = nan\n");
  EXPECT_EQ(reader.root().number("a", 0, 1), std::nullopt);
  EXPECT_EQ(problems_of(reader), "a.toml:1:5: error: \"a\" is nan, but must be from 0 to 1");
}

TEST(TomlReader, SaysOfABrokenFileNothingAboutWhatItLacks) {
  TomlReader reader("a.toml", "a = 1\nb = = 2\n");
  reader.root().required_text("name");
  reader.root().scalar("a");
  const std::string text = problems_of(reader);
  EXPECT_EQ(text.rfind("a.toml:2:5: error: not valid TOML: ", 0), 0U) << text;
  EXPECT_EQ(text.find('\n'), std::string::npos) << text;
}

TEST(TomlReader, LeavesOutLinesThatAreNoTomlAndReadsTheOthers) {
  TomlReader reader("a.toml", "a = 'x\n[t]\nb = [1, 2\nc = 3 4\nd = true\n");
  EXPECT_FALSE(reader.parsed());  // the list is open: nothing behind it is certain
  TomlReader other("a.toml", "a = 'x\n[t]\nc = 3 4\nd = true\n");
  EXPECT_TRUE(other.parsed());
  EXPECT_FALSE(other.whole());
  EXPECT_EQ(other.root().table("t").value_or(other.empty()).boolean("d"), true);
  const std::string text = problems_of(other);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
  EXPECT_NE(text.find("a.toml:3:"), std::string::npos) << text;
}

TEST(TomlReader, NamesWrongElementsOfAListAtTheirPlace) {
  TomlReader reader("a.toml", "list = ['x', 7]\n");
  EXPECT_EQ(reader.root().texts("list").size(), 1U);
  EXPECT_EQ(problems_of(reader),
            "a.toml:1:14: error: \"list\" must be a list of texts, but is a whole number here");
}

TEST(TomlReader, KeepsKeysInTheOrderOfTheFile) {
  TomlReader reader("a.toml", "z = 1\na = 2\nm = 3\n");
  EXPECT_EQ(reader.root().keys(), (std::vector<std::string>{"z", "a", "m"}));
}

TEST(TomlReader, ReturnsWarningsWhenNothingIsWrong) {
  TomlReader reader("a.toml", "a = 'x'\n");
  reader.root().text("a");
  reader.root().warning("a", "is odd");
  EXPECT_EQ(to_text(reader.finish().at(0)), "a.toml:1:5: warning: is odd");
}

std::string repeated(const std::string& text, int times) {
  std::string whole;
  for (int i = 0; i < times; ++i) whole += text;
  return whole;
}

TEST(TomlReader, RefusesWhatWouldOverflowTheStack) {
  constexpr int many = 200'000;
  const std::string dots = repeated("a.", many) + "a";
  for (const std::string& text :
       {dots + " = 1", "[" + dots + "]", "[[" + dots + "]]", "x = {" + dots + " = 1}",
        repeated("'a' . ", many) + "a = 1", "x = {y = \"\"\"z\"\"\"\"\", " + dots + " = 1}",
        "x = " + repeated("[", many),
        "x = " + repeated("{x = ", many) + "1" + repeated("}", many)}) {
    TomlReader reader("a.toml", text);
    EXPECT_NE(problems_of(reader).find(" must not "), std::string::npos) << text.substr(0, 20);
  }
}

TEST(TomlReader, SaysWhereAKeyHasTooManyParts) {
  TomlReader reader("a.toml", "a = 1\n'\u00e9'." + repeated("b.", 31) + "b = 1\n");
  EXPECT_EQ(problems_of(reader), "a.toml:2:66: error: a key must not have more than 32 parts");
}

TEST(TomlReader, TakesDeepKeysAndDotsAndBracketsInTextsAndComments) {
  const std::string noise = repeated(".[{", 100);
  TomlReader reader("a.toml", repeated("a.", 31) + "a = 1.5 # " + noise +
                                  "\n[b]\nc = [1.5, \"\\\"" + noise + "\", '" + noise +
                                  "', \"\"\"\n" + noise + "\n\"\"\", " + repeated("[", 60) +
                                  repeated("]", 60) + "]\n");
  EXPECT_TRUE(reader.ok());
}

TEST(TomlReader, SurvivesEveryTruncationOfAFile) {
  const std::string whole = "[a]\nb = {c = [1, 2.5], d = '''x'''}\n[[e]]\nf = 1979-05-27\n";
  for (std::size_t n = 0; n <= whole.size(); ++n) {
    TomlReader reader("a.toml", std::string_view(whole).substr(0, n));
    reader.root().tables("e");
    problems_of(reader);
  }
}

}  // namespace
}  // namespace promenade::study
