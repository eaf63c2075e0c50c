#include "analysis/report/gnuplot.h"

#include <gtest/gtest.h>

#include "motion/files.h"
#include "motion/problem.h"
#include "tests/analysis/toy_log.h"

namespace promenade::analysis {
namespace {

TEST(Gnuplot, RunsInTheFolderAndLeavesNothingButTheFigure) {
  const TestFolder folder;
  run_gnuplot("set terminal svg\nset output 'x.svg'\nplot x\n", folder.file(""));
  EXPECT_NE(read_file(folder.file("x.svg")).find("</svg>"), std::string::npos);
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.file(""))) {
    files += entry.is_regular_file() ? 1 : 0;
  }
  EXPECT_EQ(files, 1);
}

TEST(Gnuplot, SaysWhatItRefused) {
  const TestFolder folder;
  try {
    run_gnuplot("plot nonsense_that_is_not_defined\n", folder.file(""));
    FAIL() << "that is no plot";
  } catch (const OutsideError& error) {
    EXPECT_NE(std::string(error.what()).find("nonsense"), std::string::npos);
  }
}

TEST(GnuplotText, CannotBeEndedExpandedOrExecuted) {
  const TestFolder folder;
  const std::string evil =
      "it's `touch pwned` @x \"$(touch pwned)\" \\n'; !touch pwned\n!touch pwned";
  run_gnuplot("set terminal svg noenhanced\nset output 'x.svg'\nset xlabel " + gnuplot_text(evil) +
                  "\nplot x\n",
              folder.file(""));
  EXPECT_FALSE(std::filesystem::exists(folder.file("pwned")));
  EXPECT_NE(read_file(folder.file("x.svg")).find("it's `touch pwned` @x"), std::string::npos);
}

TEST(CreationDate, IsReplacedByOneOfTheSameLength) {
  EXPECT_EQ(without_creation_date("a/CreationDate (D:20261122162722Z)b"),
            "a/CreationDate (D:20000101000000Z)b");
  EXPECT_EQ(without_creation_date("none"), "none");
  EXPECT_EQ(without_creation_date("/CreationDate (D:20"), "/CreationDate (D:20");
}

}  // namespace
}  // namespace promenade::analysis
