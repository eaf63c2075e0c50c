#include "study/load_instrument.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "motion/files.h"
#include "tests/test_folder.h"

namespace promenade::study {
namespace {

const std::string head = "name = 'n'\ntitle = { en = 'T', ja = '題' }\n";
const std::string item =
    "[[item]]\nname = 'a'\nkind = 'scale'\nquestion = { en = 'Q', ja = '問' }\n";

// All problems of an instrument, one a line.
std::string problems_of(const std::string& text) {
  try {
    read_instrument("i.toml", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

struct BrokenInstrument {
  std::string text;
  const char* said;
};

void expect_problems(const std::vector<BrokenInstrument>& table) {
  for (const BrokenInstrument& broken : table) EXPECT_EQ(problems_of(broken.text), broken.said);
}

TEST(InstrumentFile, ThatIsWholeHasNoProblems) { EXPECT_EQ(problems_of(head + item), ""); }

TEST(InstrumentFile, ThatIsBrokenIsRefusedWithEveryPlaceAndReason) {
  expect_problems({
      {"",
       "i.toml:1:1: error: \"name\" is missing here\n"
       "i.toml:1:1: error: \"title\" is missing here\n"
       "i.toml:1:1: error: an instrument needs at least one [[item]], or [pairs]"},
      {"name = 'a/b'\ntitel = 'T'\ntitle = { en = 'T', ja = '' }\nversion = 2\n" + item,
       "i.toml:1:8: error: \"name\" must have up to 80 characters, none of them \"/\" or a control "
       "character, and not begin with a dot\n"
       "i.toml:2:1: error: unknown key \"titel\"; did you mean \"title\"?\n"
       "i.toml:3:9: error: \"title\" must not be empty\n"
       "i.toml:4:11: error: \"version\" must be a text in quotes, but is a whole number"},
      {head + "text = {}\nlow = { fr = 'bas' }\n" + item,
       "i.toml:3:8: error: \"text\" must not be empty\n"
       "i.toml:4:7: error: \"low\" must not be empty\n"
       "i.toml:4:9: error: unknown key \"fr\""},
      {head + item + item, "i.toml:7:1: error: there is another item with the name \"a\" before"},
      {head + "[[item]]\nkind = 'scales'\nstep = 2\n",
       "i.toml:3:1: error: \"name\" is missing here\n"
       "i.toml:4:8: error: \"kind\" is \"scales\", but must be one of \"scale\", \"choice\", "
       "\"number\", \"text\", \"ranking\", \"agree\"; did you mean \"scale\"?"},
      {head + "[[item]]\nname = 'a'\nkind = 'text'\nlongest = 0\nleast = 1\n",
       "i.toml:3:1: error: \"question\" is missing here\n"
       "i.toml:6:11: error: \"longest\" is 0, but must be from 1 to 10000\n"
       "i.toml:7:1: error: unknown key \"least\""},
  });
}

TEST(InstrumentFile, NamesWhatIsWrongWithAScale) {
  expect_problems({
      {head + item + "least = 5\nmost = 1\n",
       "i.toml:8:8: error: a scale from 5 to 1 has no steps: \"least\" must be below \"most\""},
      {head + item + "least = 0\nmost = 100\nstep = 7\n",
       "i.toml:8:8: error: a scale from 0 to 100 cannot be cut into steps of 7"},
      {head + item + "most = 1000\n",
       "i.toml:7:8: error: a scale has up to 100 steps, but this one has 999"},
      {head + "most = 1\n" + item,
       "i.toml:3:8: error: a scale from 1 to 1 has no steps: \"least\" must be below \"most\""},
      {head + item + "most = nan\nstep = 0\n",
       "i.toml:7:8: error: \"most\" is nan, but must be from -1000000 to 1000000\n"
       "i.toml:8:8: error: \"step\" is 0, but must be from 0.001 to 1000000"},
      {head +
           "[[item]]\nname = 'a'\nkind = 'number'\nquestion = { en = 'Q', ja = '問' }\nmost = 0\n",
       "i.toml:3:1: error: \"least\" is missing here\n"
       "i.toml:7:8: error: \"most\" must be above \"least\""},
  });
}

std::string choice(const std::string& keys) {
  return head + "[[item]]\nname = 'a'\nkind = 'choice'\nquestion = { en = 'Q', ja = '問' }\n" +
         keys;
}

TEST(InstrumentFile, NamesWhatIsWrongWithChoices) {
  expect_problems({
      {choice(""), "i.toml:3:1: error: \"choices\" is missing here"},
      {choice("choices = [{ name = 'x', en = 'X', ja = 'X' }]\n"),
       "i.toml:7:11: error: there must be from 2 to 50 choices"},
      {choice(
           "choices = [{ name = 'x', en = 'X', ja = 'X' }, { name = 'x', en = '', ja = 'X' }]\n"),
       "i.toml:7:48: error: there is another choice with the name \"x\" before\n"
       "i.toml:7:67: error: \"en\" must not be empty"},
      {choice("interfaces = true\nchoices = []\n"),
       "i.toml:8:11: error: the choices are the interfaces of the study; leave these out, or "
       "\"interfaces = true\""},
      {head + "[pairs]\nchoices = [{ name = 'x', en = 'X', ja = 'X' }]\n",
       "i.toml:3:1: error: \"question\" is missing here\n"
       "i.toml:4:11: error: there must be from 2 to 15 choices"},
      {head +
           "[[item]]\nname = 'x-y'\nkind = 'agree'\nquestion = { en = 'Q', ja = '問' }\n[pairs]\n"
           "question = { en = 'Q', ja = '問' }\n"
           "choices = [{ name = 'x', en = 'X', ja = 'X' }, { name = 'y', en = 'Y', ja = 'Y' }]\n",
       "i.toml:9:11: error: there is another item with the name of the pair \"x-y\""},
  });
}

// Lines 7 to 10: a second item, from 0; then a score.
std::string scored(const std::string& keys) {
  return head + item +
         "[[item]]\nname = 'b'\nkind = 'text'\nquestion = { en = 'Q', ja = '問' }\n"
         "[[item]]\nname = 'zero'\nkind = 'scale'\nquestion = { en = 'Q', ja = '問' }\nleast = 0\n"
         "[[score]]\nname = 's'\n" +
         keys;
}

TEST(InstrumentFile, NamesWhatIsWrongWithAScore) {
  expect_problems({
      {scored(""), "i.toml:16:1: error: a score needs \"items\", \"reversed\" or \"weighted\""},
      {scored("items = ['zerro', 'b']\n"),
       "i.toml:18:10: error: there is no [[item]] with the name \"zerro\"; did you mean \"zero\"?\n"
       "i.toml:18:19: error: \"b\" is of kind \"text\", which is no number to be scored"},
      {scored("items = ['a', 'zero']\nreversed = ['a']\n"),
       "i.toml:18:15: error: \"zero\" goes from 0 to 7, but \"a\" from 1 to 7: the items of a "
       "score "
       "must have one range\n"
       "i.toml:19:13: error: \"a\" is in this score already"},
      {scored("items = ['a']\nrange = [100, 0]\ncombine = 'men'\n"),
       "i.toml:19:9: error: \"range\" must be two numbers that ascend, such as [0, 100]\n"
       "i.toml:20:11: error: \"combine\" is \"men\", but must be one of \"mean\", \"sum\"; did you "
       "mean \"mean\"?"},
      {scored("items = ['a']\nrange = [0, 100]\ncombine = 'sum'\n"),
       "i.toml:19:9: error: \"range\" is for means; leave out \"combine\""},
      {scored("weighted = { x = ['a'] }\n"),
       "i.toml:18:18: error: no item of kind \"choice\" and no pair offers \"x\""},
  });
}

TEST(InstrumentFile, WithALineThatIsNoTomlSaysWhatElseIsWrong) {
  const std::string said = problems_of("name = 'n\ntitle = 'T'\nversion = 1\n" + item);
  EXPECT_EQ(said.rfind("i.toml:1:", 0), 0U) << said;
  EXPECT_NE(said.find("i.toml:3:11: error: \"version\" must be a text"), said.npos) << said;
}

TEST(InstrumentFile, OfFarTooManyItemsIsRefusedInOneSentence) {
  std::string text = head;
  for (int i = 0; i < 201; ++i) text += "[[item]]\n";
  EXPECT_EQ(problems_of(text), "i.toml:3:1: error: an instrument has up to 200 items and pairs");
}

TEST(InstrumentFile, WarnsOfTextsThatALanguageLacks) {
  const std::string text = "name = 'n'\ntitle = 'T'\n" + item;
  EXPECT_TRUE(read_instrument("i.toml", text, {"en"}).warnings.empty());
  const auto warnings = read_instrument("i.toml", text, {"en", "ja"}).warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(to_text(warnings[0]),
            "i.toml:2:9: warning: \"title\" has no text in \"ja\"; \"T\" is shown");
}

TEST(InstrumentFile, SaysOnceWhatHoldsForAllItsScales) {
  const Instrument read =
      read_instrument("i.toml", head + "low = 'l'\nhigh = 'h'\nleast = 0\nmost = 10\nstep = 2\n" +
                                    item + "high = 'own'\nmost = 4\n")
          .instrument;
  const Item* scale = find_item(read, "a");
  ASSERT_TRUE(scale);
  EXPECT_EQ(text_in(scale->low, "en"), "l");
  EXPECT_EQ(text_in(scale->high, "en"), "own");
  EXPECT_EQ(scale->least, 0);
  EXPECT_EQ(scale->most, 4);
  EXPECT_EQ(scale->step, 2);
}

TEST(InstrumentFile, MakesAnItemOfEveryPair) {
  const Instrument read =
      read_instrument("i.toml", head +
                                    "[pairs]\nquestion = 'Q'\nchoices = [{ name "
                                    "= 'x' }, { name = 'y' }, { name = 'z' }]\n")
          .instrument;
  std::string names;
  for (const Item& one : read.items) names += one.name + " ";
  EXPECT_EQ(names, "x-y z-x y-z ");
  EXPECT_TRUE(read.items[1].pair);
  EXPECT_EQ(read.items[1].choices[0].name, "z");
}

TEST(InstrumentFile, IsFoundByItsNameOrBesideTheStudy) {
  EXPECT_EQ(load_instrument("sus", "nowhere").instrument.items.size(), 10U);
  const TestFolder folder;
  write_file(folder.file("own.toml"), head + item);
  const InstrumentFile own = load_instrument("own.toml", folder.path().string());
  EXPECT_EQ(own.instrument.name, "n");
  EXPECT_EQ(own.text, head + item);
}

TEST(InstrumentFile, ThatIsNotThereIsAnInputError) {
  EXPECT_THROW(load_instrument("none.toml", TestFolder().path().string()), InputError);
  try {
    load_instrument("suz", "");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean \"sus\"?"), std::string::npos);
  }
}

}  // namespace
}  // namespace promenade::study
