// Sessions with every instrument and every kind of task, by the autopilot's mouse.
#include <gtest/gtest.h>

#include "study/embedded.h"
#include "study/sqlite.h"
#include "tests/app/session_bench.h"

namespace promenade::app {
namespace {

using bench::SessionBench;
using study::PageKind;

const std::string head =
    "[study]\nname = 'all'\nlanguages = ['en', 'ja']\norder = 'fixed'\n"
    "[[interface]]\nname = 'labels'\n[[interface]]\nname = 'weights'\n";

std::string questionnaire(const std::string& instrument, const std::string& when) {
  return "[[questionnaire]]\ninstrument = '" + instrument + "'\nwhen = '" + when + "'\n";
}

std::string with_every_instrument() {
  std::string text = head +
                     "[[task]]\nname = 'match'\nkind = 'match'\nlimit_s = 3\n"
                     "targets = [{example = 'proud'}]\n";
  for (const std::string& name : study::embedded_names("instruments")) {
    text += questionnaire(name, name == "consent" || name == "demographics" ? "start" : "end");
  }
  return text;
}

std::int64_t count(const SessionBench& bench, const std::string& rows) {
  study::Database database(bench.file().string(), study::Database::Mode::read_only);
  study::Statement statement(database, "SELECT count(*) FROM " + rows);
  statement.step();
  return statement.integer(0);
}

class EveryInstrument : public testing::TestWithParam<const char*> {};

TEST_P(EveryInstrument, IsAnsweredByTheAutopilotsMouse) {
  SessionBench bench(GetParam(), 7, with_every_instrument());
  ASSERT_TRUE(bench.play(120));
  EXPECT_EQ(bench.session().outcome(), study::Outcome::finished);
  const auto instruments = study::embedded_names("instruments").size();
  EXPECT_EQ(count(bench, "(SELECT DISTINCT instrument FROM answer)"),
            static_cast<std::int64_t>(instruments));
  EXPECT_EQ(count(bench, "answer WHERE item LIKE 'order:%' AND instrument = 'ranking'"), 2);
}

INSTANTIATE_TEST_SUITE_P(Texts, EveryInstrument, testing::Values("en", "ja"));

TEST(EveryKindOfTask, IsFinishedByTheAutopilotsMouse) {
  SessionBench bench(
      "ja", 3,
      head +
          "[practice]\nuntil = 'released'\n"
          "[[task]]\nname = 'look'\nkind = 'rate'\ninstrument = 'impression'\n"
          "reference = 'normal'\ntargets = [{example = 'sad'}]\n"
          "[[task]]\nname = 'first'\nkind = 'guess'\ntargets = [{example = 'proud'}]\n"
          "threshold = 0.05\npractice = [{example = 'happy'}]\n"
          "[[task]]\nname = 'then'\nkind = 'match'\nstart = 'first'\nthreshold = 0.05\n"
          "done = false\nlimit_s = 20\n"
          "[[task]]\nname = 'find'\nkind = 'find'\n"
          "qualities = [{name = 'proud', en = 'proud', ja = '誇らしい'}]\n");
  ASSERT_TRUE(bench.play(60));
  EXPECT_EQ(bench.session().outcome(), study::Outcome::finished);
  EXPECT_EQ(count(bench, "event WHERE kind = 'release' AND actor = 'experimenter'"),
            count(bench, "event WHERE kind = 'page' AND target = 'release'"));
  EXPECT_GT(count(bench, "event WHERE kind = 'release'"), 0);
  EXPECT_EQ(count(bench, "answer WHERE instrument = 'impression'"), 4);
}

}  // namespace
}  // namespace promenade::app
