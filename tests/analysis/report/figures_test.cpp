#include "analysis/report/figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

// A map of `examples` on a spiral, seen with every interface, and their tree.
MapTimes made_up_map(int examples, int interfaces, const std::string& name) {
  MapTimes times;
  times.map.examples.resize(examples, 2);
  for (int i = 0; i < examples; ++i) {
    times.names.push_back(name + std::to_string(i + 1));
    times.map.examples.row(i) << (i + 1) * std::cos(2.4 * i), (i + 1) * std::sin(2.4 * i);
  }
  times.map.least.setConstant(-1.1 * examples);
  times.map.cell.setConstant(0.22 * examples);
  times.tree = motion::ward(times.map.examples.transpose());
  for (int k = 0; k < interfaces; ++k) {
    MapTime& time = times.times.emplace_back();
    time.interface = k;
    time.trials = 3;
    for (int cell = 0; cell < map_cells * map_cells; cell += k + 2) {
      time.seconds[static_cast<std::size_t>(cell)] = 60.0 / (cell + 1);
    }
    time.outside_s = 7;
  }
  return times;
}

const Figure* find(const std::vector<Figure>& figures, const std::string& name) {
  const auto found = std::find_if(figures.begin(), figures.end(),
                                  [&](const Figure& one) { return one.name == name; });
  return found == figures.end() ? nullptr : &*found;
}

TEST(Figures, ShowTheMapAndTheTreeOfTheMotions) {
  for (const auto& [examples, name] : {std::pair{1, "one"}, {2, "it's "}, {55, "歩き方"}}) {
    const TestFolder folder;
    fill(*std::make_unique<ToyLog>(folder.file("a.db")), 2, 0.001);
    Results results = results_of(folder);
    results.map_times = made_up_map(examples, 2, name);
    const auto figures = figures_of(results);
    ASSERT_TRUE(find(figures, "map_time")) << examples;
    EXPECT_EQ(find(figures, "dendrogram") != nullptr, examples > 1);
    draw_in(folder, figures, "figures");
    EXPECT_NE(read_file(folder.file("figures/map_time.svg")).find(name), std::string::npos);
  }
}

TEST(Figures, GiveTheSecondsOfEachCellOfTheMap) {
  const TestFolder folder;
  fill(*std::make_unique<ToyLog>(folder.file("a.db")), 2, 0.001);
  Results results = results_of(folder);
  results.map_times = made_up_map(3, 1, "walk");
  MapTime& time = results.map_times.times[0];
  time.seconds.fill(0);
  time.seconds[42] = 21;
  const auto figures = figures_of(results);
  const auto& rows = find(figures, "map_time")->data[0].rows;
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(std::get<std::int64_t>(rows[0][1]), 4) << "from the left";
  EXPECT_EQ(std::get<std::int64_t>(rows[0][2]), 2) << "from below";
  EXPECT_DOUBLE_EQ(std::get<double>(rows[0][3]), 0.75) << "of 28 seconds";
  EXPECT_DOUBLE_EQ(std::get<double>(rows[0][4]), 21);
}

TEST(Figures, DrawASetWithoutSpread) {
  const TestFolder folder;
  fill(*std::make_unique<ToyLog>(folder.file("a.db")), 2, 0.001);
  Results results = results_of(folder);
  results.map_times = made_up_map(3, 1, "walk");
  results.map_times.map.examples.setZero();
  results.map_times.map.least.setZero();
  results.map_times.map.cell.setZero();
  results.map_times.tree = motion::ward(Eigen::MatrixXd::Zero(2, 3));
  const auto figures = figures_of(results);
  EXPECT_FALSE(find(figures, "dendrogram")) << "all are the same";
  draw_in(folder, figures, "figures");
  EXPECT_TRUE(std::filesystem::exists(folder.file("figures/map_time.svg")));
}

// Like R's hclust: the tighter of two clusters comes first, at the top.
TEST(Figures, PutBracketsOfTheTreeBetweenTheirRows) {
  const TestFolder folder;
  fill(*std::make_unique<ToyLog>(folder.file("a.db")), 2, 0.001);
  Results results = results_of(folder);
  results.map_times = made_up_map(3, 0, "walk");
  Eigen::MatrixXd at(1, 3);
  at << 10, 0, 1;
  results.map_times.tree = motion::ward(at);
  const auto figures = figures_of(results);
  const auto& data = find(figures, "dendrogram")->data;
  const auto height = [&](std::size_t row) { return std::get<double>(data[0].rows[row][0]); };
  EXPECT_NEAR(height(1), 1, 1e-12);
  EXPECT_NEAR(height(6), std::sqrt(4.0 / 3) * 9.5, 1e-12);
  EXPECT_EQ(std::get<std::string>(data[1].rows[0][1]), "walk1");
  EXPECT_EQ(std::get<std::string>(data[1].rows[2][1]), "walk3");
}

TEST(Figures, OfMoreThanFortyPeopleAreRainclouds) {
  for (const int people : {40, 41}) {
    const TestFolder folder;
    fill(*std::make_unique<ToyLog>(folder.file("a.db")), people, 0.001);
    const auto figures = figures_of(results_of(folder));
    const Figure& dots = *find(figures, "d_final");
    EXPECT_EQ(dots.data.size(), people > 40 ? 3U : 2U);
    EXPECT_EQ(dots.caption.find("grey lines") == std::string::npos, people > 40);
    if (people > 40) draw_in(folder, {dots}, "figures");
  }
}

TEST(Figures, DrawRaincloudsOfPeopleWhoAllDidTheSame) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    for (int i = 0; i < 41; ++i) log.session({"P" + std::to_string(i)}).trial({});
  }
  draw_in(folder, figures_of(results_of(folder)), "figures");
  EXPECT_TRUE(std::filesystem::exists(folder.file("figures/d_final.svg")));
}

TEST(Figures, OfTheStudyOf2018ComeInThePrintedOrderFirst) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    study::Statement row(log.database(), "UPDATE study SET config_text = ?");
    row.bind(1, std::string("[study]\npublished = \"oshita-2018\"\n[[task]]\nname = "
                            "\"guess\"\nkind = \"guess\"\n[[task]]\nname = \"match\"\n"))
        .run();
    for (int i = 1; i <= 6; ++i) {
      log.session({"P" + std::to_string(i)});
      for (const char* interface : {"labels", "weights"}) {
        for (const char* task : {"guess", "match"}) {
          log.trial({interface, "happy", 10.0 + i, 0.02, "done", task, false, 300, 0.05});
        }
      }
    }
  }
  const auto figures = figures_of(results_of(folder));
  const std::vector<std::string> all = names(figures);
  EXPECT_EQ(std::vector<std::string>(all.begin(), all.begin() + 5),
            (std::vector<std::string>{"d_final_by_target-1-guess", "guessed-1-guess",
                                      "time_s_by_target-2-match", "time_s_to_reference-2-match",
                                      "failures-2-match"}));
  EXPECT_NE(figures[4].caption.find("As Figure 11 of [O]."), std::string::npos);
  EXPECT_EQ(figures[5].caption.find("As Figure"), std::string::npos);
}

}  // namespace
}  // namespace promenade::analysis
