#include "app/ethics_page.h"

#include <gtest/gtest.h>

#include "app/registry.h"
#include "study/load_study.h"
#include "study/schema.h"
#include "study/sqlite.h"

namespace promenade::app {
namespace {

bool says(const std::string& page, const std::string& part) {
  return page.find(part) != std::string::npos;
}

study::StudyBundle demo() { return study::load_study("configs/demo.toml", interfaces()); }

// Each with its meaning: what has none would not be told.
TEST(EthicsPage, TellsOfEveryColumn) {
  const std::string page = ethics_page(demo(), PageFormat::html);
  study::Database database(":memory:", study::Database::Mode::create);
  study::create_tables(database);
  study::Statement row(database,
                       "SELECT m.name, p.name, (SELECT meaning FROM dictionary WHERE table_name = "
                       "m.name AND column_name = p.name) FROM sqlite_schema m JOIN "
                       "pragma_table_info(m.name) p WHERE m.type = 'table'");
  int columns = 0;
  for (; row.step(); ++columns) {
    EXPECT_TRUE(says(page, "<h3>" + row.text(0) + "</h3>")) << row.text(0);
    EXPECT_TRUE(says(page, "<td>" + row.text(1) + "</td>")) << row.text(1);
    EXPECT_FALSE(row.text(2).empty()) << row.text(0) << "." << row.text(1);
  }
  EXPECT_GT(columns, 100);
}

TEST(EthicsPage, TellsWhatIsAskedInEveryLanguageOfTheStudy) {
  const study::StudyBundle bundle = demo();
  const std::string page = ethics_page(bundle, PageFormat::html);
  for (const std::string& language : bundle.study.languages) {
    const std::string consent = study::load_texts(language)("consent.text");
    EXPECT_TRUE(says(page, consent.substr(0, consent.find('\n')))) << language;
  }
  for (const study::Instrument& instrument : bundle.study.instruments) {
    for (const study::Item& item : instrument.items) EXPECT_TRUE(says(page, item.name));
  }
}

TEST(EthicsPage, TellsWhatAWithdrawalRemovesAndWhereCopiesGo) {
  study::StudyBundle bundle = demo();
  EXPECT_TRUE(says(ethics_page(bundle, PageFormat::html), "Every row of the person is deleted"));
  EXPECT_TRUE(says(ethics_page(bundle, PageFormat::html), "no second copy is made"));
  bundle.study.safety.withdrawal = study::Withdrawal::link;
  bundle.study.safety.copy_to = "/media/stick";
  EXPECT_TRUE(says(ethics_page(bundle, PageFormat::html), "Answers and trials stay"));
  EXPECT_TRUE(says(ethics_page(bundle, PageFormat::html), "/media/stick"));
}

TEST(EthicsPage, TellsHowLongTheDataAreKeptOrHowToSayIt) {
  const std::string unsaid = ethics_page(demo(), PageFormat::markdown);
  EXPECT_TRUE(says(unsaid, "the study file does not say"));
  EXPECT_TRUE(says(unsaid, "10 years after publication"));
  const std::string text =
      "[study]\nname = 'kept'\n[[interface]]\nname = 'labels'\n[[task]]\nname = 'match'\n"
      "kind = 'match'\ntargets = [{example = 'proud'}]\n[safety]\nkeep = 'until spring 2031'\n";
  const study::StudyBundle kept =
      study::read_study("kept.toml", text, interfaces(), study::load_motion_set);
  const std::string said = ethics_page(kept, PageFormat::markdown);
  EXPECT_TRUE(says(said, "until spring 2031"));
  EXPECT_FALSE(says(said, "the study file does not say"));
}

TEST(EthicsPage, LetsNoTextBecomeMarkup) {
  study::StudyBundle bundle = demo();
  bundle.study.title["en"] = "<script>alert(1)</script> & | *more*";
  bundle.study.consent["en"] = "<b>yes</b>\n\n| a | b |\n# big";
  const std::string html = ethics_page(bundle, PageFormat::html);
  EXPECT_FALSE(says(html, "<script>"));
  EXPECT_FALSE(says(html, "<b>"));
  const std::string markdown = ethics_page(bundle, PageFormat::markdown);
  EXPECT_FALSE(says(markdown, "<script>"));
  EXPECT_TRUE(says(markdown, "# &lt;script>alert(1)&lt;/script> &amp; \\| \\*more\\*\n"));
  EXPECT_FALSE(says(markdown, "\n# big"));
}

TEST(EthicsPage, HasTheSameTablesAsMarkdown) {
  const std::string page = ethics_page(demo(), PageFormat::markdown);
  EXPECT_TRUE(says(page, "| column | unit | meaning |\n| --- | --- | --- |\n"));
  EXPECT_TRUE(says(page, "### tombstone"));
}

}  // namespace
}  // namespace promenade::app
