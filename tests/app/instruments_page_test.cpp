#include "app/instruments_page.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "study/load_instrument.h"
#include "tests/source_dir.h"

namespace promenade::app {
namespace {

const std::string file = (source_dir() / "docs/instruments.md").string();

std::string known_list() {
  std::vector<study::Instrument> all;
  for (const std::string& name : study::known_instruments()) {
    all.push_back(study::load_instrument(name, "").instrument);
  }
  return instruments_list(all);
}

// What is written by hand, with the mark behind it.
std::string first_part(const std::string& page) {
  const std::size_t mark = page.find(instruments_mark);
  EXPECT_NE(mark, std::string::npos) << "docs/instruments.md lacks the line of instruments_mark";
  return page.substr(0, mark) + instruments_mark;
}

std::string page_text() {
  std::stringstream page;
  page << std::ifstream(file).rdbuf();
  return page.str();
}

// tools/docs sets PROMENADE_WRITE_DOCS: then the list is written first.
TEST(InstrumentsPage, IsWhatTheFilesSay) {
  const std::string wanted = first_part(page_text()) + known_list();
  if (std::getenv("PROMENADE_WRITE_DOCS") != nullptr) std::ofstream(file) << wanted;
  EXPECT_EQ(page_text(), wanted) << "run tools/docs and commit docs/instruments.md";
}

// Between the first two lines of ```.
std::string example_of(const std::string& page) {
  const std::size_t begin = page.find("```\n") + 4;
  return page.substr(begin, page.find("```\n", begin) - begin);
}

TEST(InstrumentsPage, BeginsWithAnExampleThatCanBeRead) {
  const study::InstrumentFile read = study::read_instrument("example", example_of(page_text()));
  EXPECT_TRUE(read.warnings.empty());
  EXPECT_EQ(read.instrument.scores.size(), 1U);
}

TEST(InstrumentsPage, NamesItemsAndScores) {
  const std::string list = known_list();
  EXPECT_NE(list.find("- Items: 6 scale, 15 pairs\n"), std::string::npos);
  EXPECT_NE(list.find("- Scores: `sus` (0 to 100)\n"), std::string::npos);
}

}  // namespace
}  // namespace promenade::app
