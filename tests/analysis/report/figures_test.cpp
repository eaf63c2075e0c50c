#include "analysis/report/figures.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "motion/files.h"
#include "tests/analysis/toy_log.h"

namespace promenade::analysis {
namespace {

Results results_of(const TestFolder& folder) { return compute_results({folder.file("a.db")}, {}); }

void draw_in(const TestFolder& folder, const std::vector<Figure>& figures, const char* name) {
  std::filesystem::create_directories(folder.file(name));
  draw(figures, folder.file(name));
}

std::vector<std::string> names(const std::vector<Figure>& figures) {
  std::vector<std::string> result;
  for (const Figure& figure : figures) result.push_back(figure.name);
  return result;
}

TEST(Figures, StandBesideTheirDataAndScripts) {
  const TestFolder folder;
  fill(*std::make_unique<ToyLog>(folder.file("a.db")), 7, 0.001);
  const auto figures = figures_of(results_of(folder));
  EXPECT_EQ(
      names(figures),
      (std::vector<std::string>{
          "d_final", "d_final_pairs", "d_final_by_target", "d_final_to_reference", "time_s",
          "time_s_pairs", "time_s_by_target", "time_s_to_reference", "failures", "survival"}));
  draw_in(folder, figures, "figures");
  for (const Figure& figure : figures) {
    for (const char* ending : {".svg", ".pdf", ".gp", ".csv"}) {
      EXPECT_TRUE(std::filesystem::exists(folder.file("figures/" + figure.name + ending)));
    }
  }
}

TEST(Figures, AreTheSameByteForByteAtAnotherTimeAndInAnotherOrder) {
  const TestFolder folder;
  fill(*std::make_unique<ToyLog>(folder.file("a.db")), 7, 0.001);
  auto figures = figures_of(results_of(folder));
  draw_in(folder, figures, "one");
  std::reverse(figures.begin(), figures.end());
  draw_in(folder, figures, "two");
  for (const Figure& figure : figures) {
    for (const char* ending : {".svg", ".pdf"}) {
      EXPECT_EQ(read_file(folder.file("one/" + figure.name + ending)),
                read_file(folder.file("two/" + figure.name + ending)))
          << figure.name;
    }
  }
}

// weights - labels is 0.004 m in the middle of the Walsh averages; c = 3 of 28 for n = 7.
TEST(Figures, HoldExactNumbersInTheirData) {
  const TestFolder folder;
  fill(*std::make_unique<ToyLog>(folder.file("a.db")), 7, 0.001);
  const auto figures = figures_of(results_of(folder));
  const auto& row = figures[1].data[0].rows.at(0);
  EXPECT_NEAR(std::get<double>(row[1]), 0.004, 1e-12);
  EXPECT_NEAR(std::get<double>(row[2]), 0.002, 1e-12);
  EXPECT_NEAR(std::get<double>(row[3]), 0.006, 1e-12);
  EXPECT_EQ(figure_numbers(figures).json["figures"][1]["data"][0]["rows"][0][1],
            std::get<double>(row[1]));
}

TEST(Figures, OfOnePersonOneInterfaceAndTimeoutsAloneAreDrawn) {
  for (const char* outcome : {"done", "timeout", "success"}) {
    const TestFolder folder;
    {
      ToyLog log(folder.file("a.db"));
      log.session({"P1"}).trial({.seconds = 0, .d_final = 0.0, .outcome = outcome});
    }
    draw_in(folder, figures_of(results_of(folder)), "figures");
    EXPECT_TRUE(std::filesystem::exists(folder.file("figures/d_final.svg"))) << outcome;
  }
}

TEST(Figures, ShowNamesAsTextWhateverTheyHold) {
  const TestFolder folder;
  const std::string evil = "it's \"`touch pwned`\", \\n #1\n!touch pwned";
  {
    ToyLog log(folder.file("a.db"));
    for (const char* code : {"P,1", "P\"2"}) {
      log.session({code})
          .trial({evil, evil, 5, 0.01})
          .trial({"歩き方、とても長い名前の", "x", 6, 0.02});
    }
  }
  draw_in(folder, figures_of(results_of(folder)), "figures");
  EXPECT_FALSE(std::filesystem::exists(folder.file("figures/pwned")));
}

TEST(Figures, TellGuessesFromWhatWasSeen) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    log.session({"P1"})
        .trial({.threshold_m = 0.06})
        .trial({.threshold_m = 0.06})
        .trial({.d_final = 0.07, .threshold_m = 0.06});
    log.database().exec(
        "UPDATE study SET config_text = '[[task]]\nname = \"match\"\nkind = \"guess\"'");
  }
  const auto figures = figures_of(results_of(folder));
  const auto found = std::find_if(figures.begin(), figures.end(),
                                  [](const Figure& one) { return one.name == "guessed"; });
  ASSERT_NE(found, figures.end());
  EXPECT_DOUBLE_EQ(std::get<double>(found->data[0].rows.at(0)[2]), 2.0 / 3);
}

}  // namespace
}  // namespace promenade::analysis
