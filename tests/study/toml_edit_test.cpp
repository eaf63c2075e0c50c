#include "study/toml_edit.h"

#include <gtest/gtest.h>

#include "motion/problem.h"
#include "study/toml_spans.h"

namespace promenade::study {
namespace {

std::string edited(const std::string& text, const TomlEdit& edit) {
  return edited_toml("a.toml", text, edit);
}

std::string set_in(const std::string& text, const char* path, const TomlValue& value) {
  return edited(text, set_value(toml_path(path), value));
}

std::string removed_from(const std::string& text, const char* path) {
  return edited(text, remove_value(toml_path(path)));
}

std::string refusal(const std::string& text, const TomlEdit& edit) {
  try {
    edited(text, edit);
  } catch (const InputError& error) {
    return error.problems().front().message;
  }
  return "";
}

TEST(TomlEdit, SetsAValueAndLeavesItsRemark) {
  EXPECT_EQ(set_in("a = 1   # one\nb = 2\n", "a", toml_integer(10)), "a = 10   # one\nb = 2\n");
  EXPECT_EQ(set_in("[t]\r\na = 'x' # one\r\n", "t.a", toml_text("y\"")),
            "[t]\r\na = \"y\\\"\" # one\r\n");
}

TEST(TomlEdit, KeepsTheMarkAtTheBeginningOfTheFile) {
  EXPECT_EQ(set_in("\xEF\xBB\xBF"
                   "a = 1\n",
                   "a", toml_integer(2)),
            "\xEF\xBB\xBF"
            "a = 2\n");
}

TEST(TomlEdit, FindsKeysWithDotsAndQuotes) {
  EXPECT_EQ(set_in("a . 'b c' = 1\n", "a.\"b c\"", toml_integer(2)), "a . 'b c' = 2\n");
  EXPECT_EQ(set_in("a.b = 1\n", "a.c", toml_integer(2)), "a.b = 1\na.c = 2\n");
  EXPECT_EQ(set_in("[t]\na.b = 1\n", "t.a.\"c d\"", toml_integer(2)),
            "[t]\na.b = 1\na.\"c d\" = 2\n");
}

TEST(TomlEdit, AddsAKeyBelowTheLastOneOfItsSection) {
  EXPECT_EQ(set_in("[s]\n  a = 1\n\n# about t\n[t]\nc = 1\n", "s.b", toml_boolean(true)),
            "[s]\n  a = 1\n  b = true\n\n# about t\n[t]\nc = 1\n");
  EXPECT_EQ(set_in("[[task]]\na = 1\n[task.sub]\nx = 1\n", "task[0].b", toml_integer(2)),
            "[[task]]\na = 1\nb = 2\n[task.sub]\nx = 1\n");
  EXPECT_EQ(set_in("# head\n[t]\n", "a", toml_integer(1)), "a = 1\n\n# head\n[t]\n");
  EXPECT_EQ(set_in("[t]\na = 1", "t.b", toml_integer(2)), "[t]\na = 1\nb = 2");
}

TEST(TomlEdit, AddsASectionAtTheEnd) {
  EXPECT_EQ(set_in("[s]\na = 1\n", "breaks.after", toml_text("block")),
            "[s]\na = 1\n\n[breaks]\nafter = \"block\"\n");
  EXPECT_EQ(set_in("[s.t]\na = 1\n", "s.b", toml_integer(2)), "[s]\nb = 2\n\n[s.t]\na = 1\n");
  EXPECT_EQ(set_in("[[task]]\na = 1\n", "task[0].sub.x", toml_integer(1)),
            "[[task]]\na = 1\nsub = { x = 1 }\n");
}

TEST(TomlEdit, ChangesInlineTables) {
  EXPECT_EQ(set_in("a = { en = \"x\" }  # no\n", "a.ja", toml_text("言葉")),
            "a = { en = \"x\", ja = \"言葉\" }  # no\n");
  EXPECT_EQ(set_in("a = {}\n", "a.b", toml_integer(1)), "a = { b = 1 }\n");
  EXPECT_EQ(removed_from("a = { b = 1, c = 2 }\n", "a.b"), "a = { c = 2 }\n");
  EXPECT_EQ(removed_from("a = { b = 1, c = 2 }\n", "a.c"), "a = { b = 1 }\n");
  EXPECT_EQ(removed_from("a = { b = 1 }\n", "a.b"), "a = {}\n");
}

TEST(TomlEdit, WritesATextOverSeveralLines) {
  EXPECT_EQ(set_in("a = \"\"\"\r\none\r\n\"\"\"\r\n", "a", toml_text("two\nthree\n")),
            "a = \"\"\"\r\ntwo\r\nthree\r\n\"\"\"\r\n");
  EXPECT_EQ(set_in("a = { en = \"x\" }\n", "a.en", toml_text("y\nz")), "a = { en = \"y\\nz\" }\n");
}

TEST(TomlEdit, RemovesAKeyWithItsLine) {
  EXPECT_EQ(removed_from("# head\na = [\n 1, # one\n]\nb = 2\n", "a"), "# head\nb = 2\n");
  EXPECT_EQ(removed_from("a.b = 1\nc = 1\na.d = 2\n", "a"), "c = 1\n");
}

TEST(TomlEdit, InsertsIntoAListOnOneLine) {
  const auto one = toml_integer(1);
  EXPECT_EQ(edited("a = []\n", insert_value(toml_path("a"), 0, one)), "a = [1]\n");
  EXPECT_EQ(edited("a = [2]\n", insert_value(toml_path("a"), 0, one)), "a = [1, 2]\n");
  EXPECT_EQ(edited("a = [ 2 ]\n", insert_value(toml_path("a"), 1, one)), "a = [ 2, 1 ]\n");
  EXPECT_EQ(edited("a = [ 2, ]\n", insert_value(toml_path("a"), 1, one)), "a = [ 2, 1, ]\n");
}

TEST(TomlEdit, InsertsIntoAListOverSeveralLines) {
  const auto one = toml_integer(1);
  EXPECT_EQ(edited("a = [\n  2, # two\n  3  # three\n]\n", insert_value(toml_path("a"), 2, one)),
            "a = [\n  2, # two\n  3,  # three\n  1\n]\n");
  EXPECT_EQ(edited("a = [\n  2, # two\n  3, # three\n]\n", insert_value(toml_path("a"), 2, one)),
            "a = [\n  2, # two\n  3, # three\n  1,\n]\n");
  EXPECT_EQ(edited("a = [\n  2, # two\n]\n", insert_value(toml_path("a"), 0, one)),
            "a = [\n  1,\n  2, # two\n]\n");
}

TEST(TomlEdit, RemovesFromLists) {
  EXPECT_EQ(removed_from("a = [1, 2, 3]\n", "a[1]"), "a = [1, 3]\n");
  EXPECT_EQ(removed_from("a = [1, 2]\n", "a[1]"), "a = [1]\n");
  EXPECT_EQ(removed_from("a = [ 1, ]\n", "a[0]"), "a = [  ]\n");
  EXPECT_EQ(removed_from("a = [\n  # these\n  2, # two\n  3, # three\n]\n", "a[0]"),
            "a = [\n  # these\n  3, # three\n]\n");
  EXPECT_EQ(removed_from("a = [\n  2, # two\n  3 # three\n]\n", "a[1]"), "a = [\n  2, # two\n]\n");
}

TEST(TomlEdit, MovesElementsWithTheirRemarks) {
  EXPECT_EQ(edited("a = [1, 2, 3]\n", move_value(toml_path("a"), 0, 2)), "a = [2, 3, 1]\n");
  EXPECT_EQ(edited("a = [\n  2, # two\n  3 # three\n]\n", move_value(toml_path("a"), 1, 0)),
            "a = [\n  3, # three\n  2 # two\n]\n");
}

constexpr const char* blocks =
    "# All of them.\n\n# The first.\n[[i]]\nname = \"a\"\n# b = 1\n\n"
    "# Between.\n\n[[i]]\nname = \"b\"\n[i.sub]\nx = 1\n\n# The end.\n\n[t]\n";

TEST(TomlEdit, MovesBlocksWithWhatTouchesThem) {
  EXPECT_EQ(edited(blocks, move_value(toml_path("i"), 1, 0)),
            "# All of them.\n\n[[i]]\nname = \"b\"\n[i.sub]\nx = 1\n\n"
            "# Between.\n\n# The first.\n[[i]]\nname = \"a\"\n# b = 1\n\n# The end.\n\n[t]\n");
}

TEST(TomlEdit, RemovesABlock) {
  EXPECT_EQ(removed_from(blocks, "i[0]"),
            "# All of them.\n\n# Between.\n\n[[i]]\nname = \"b\"\n[i.sub]\nx = 1\n\n"
            "# The end.\n\n[t]\n");
  EXPECT_EQ(removed_from("[s]\na = 1\n\n[[i]]\nb = 1\n", "i[0]"), "[s]\na = 1\n");
  // A remark between two belongs to what it stands above.
  EXPECT_EQ(removed_from("[[i]]\na = 1\n# Of b.\n[[i]]\nb = 1\n", "i[0]"),
            "# Of b.\n[[i]]\nb = 1\n");
}

TEST(TomlEdit, InsertsABlockBesideTheOthers) {
  const TomlValue c = toml_table({{"name", toml_text("c")}});
  EXPECT_EQ(edited("[[i]]\nname = \"a\"\n\n[t]\n", insert_value(toml_path("i"), 1, c)),
            "[[i]]\nname = \"a\"\n\n[[i]]\nname = \"c\"\n\n[t]\n");
  EXPECT_EQ(edited("[[i]]\nname = \"a\"\n", insert_value(toml_path("i"), 0, c)),
            "[[i]]\nname = \"c\"\n\n[[i]]\nname = \"a\"\n");
  EXPECT_EQ(edited("[t]\n", insert_value(toml_path("i"), 0, c)), "[t]\n\n[[i]]\nname = \"c\"\n");
}

TEST(TomlEdit, RefusesWhatItCannotDo) {
  EXPECT_EQ(refusal("[t]\na = 1\n", set_value(toml_path("t"), toml_integer(1))),
            "\"t\" has a section of its own in the file; change what is in it");
  EXPECT_EQ(refusal("a = 1\n", set_value(toml_path("a.b"), toml_integer(1))),
            "there is no \"a.b\" in the file");
  EXPECT_EQ(refusal("a = 1\n", remove_value(toml_path("b"))), "there is no \"b\" in the file");
  EXPECT_NE(refusal("a = = 1\n", remove_value(toml_path("a"))), "");
  EXPECT_EQ(refusal("[[i]]\n[t]\n[i.sub]\n[[i]]\n", move_value(toml_path("i"), 0, 1)),
            "the parts of \"i[0]\" stand in several places of the file");
}

TEST(TomlEdit, LeavesTheTextAloneWhereTheValueIsTheSame) {
  EXPECT_EQ(set_in("a = 0x10\n", "a", toml_integer(16)), "a = 0x10\n");
}

TEST(TomlPath, IsTheSameAfterBeingWritten) {
  for (const char* path : {"", "a", "task[0].targets[12].\"a.b\"", "a[0][1]", "\"\".x"}) {
    EXPECT_EQ(to_text(toml_path(path)), path);
  }
}

TEST(TomlSpans, TellWhatIsWrittenAtAPlace) {
  const std::string text =
      "[[task]]\nname = \"x\"\ntargets = [\n  { a = 1 },\n  { b = \"語\", c = 2 } ]\n";
  const TomlSpans spans = scan_toml(text);
  const auto at = [&](int line, int column) {
    return to_text(path_at(spans, byte_at(text, {line, column})));
  };
  EXPECT_EQ(at(1, 1), "task[0]");
  EXPECT_EQ(at(2, 8), "task[0].name");
  EXPECT_EQ(at(4, 3), "task[0].targets[0]");
  EXPECT_EQ(at(5, 18), "task[0].targets[1].c");
  EXPECT_EQ(line_at(text, span_of(spans, toml_path("task[0].targets[1].c"))->begin), 5);
}

}  // namespace
}  // namespace promenade::study
