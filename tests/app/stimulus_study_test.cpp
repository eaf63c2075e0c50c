// A study with a stimulus from its file to its report, by the commands.
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "analysis/report/report_sections.h"
#include "app/commands.h"
#include "motion/files.h"
#include "motion/graph/graph_file.h"
#include "tests/app/walks_graph.h"
#include "tests/test_folder.h"

namespace promenade::app {
namespace {

using Json = nlohmann::json;

constexpr const char* study_text = R"(
[study]
name = "changes"
[[stimulus]]
name = "happy_then_sad"
graph = "walks.graph"
parts = [{ label = "happy", seconds = 3 }, { label = "sad", seconds = 3 }]
[[task]]
name = "judge"
kind = "rate"
instrument = "adjectives"
targets = [{ all = true }, { stimulus = "happy_then_sad" }]
each = 8
repeats = 1
)";

class StimulusStudy : public testing::Test {
 protected:
  StimulusStudy() {
    write_file(folder_.file("walks.graph"), motion::to_bytes(bench::walks_graph()));
    write_file(folder_.file("study.toml"), study_text);
  }
  // What it prints.
  static std::string call(std::vector<std::string> arguments) {
    CLI::App program;
    for (const auto& add :
         {add_check_command, add_simulate_command, add_pack_command, add_replay_command}) {
      add(Command(&program));
    }
    std::reverse(arguments.begin(), arguments.end());
    testing::internal::CaptureStdout();
    program.parse(arguments);
    return testing::internal::GetCapturedStdout();
  }
  Json json(std::vector<std::string> arguments) const {
    arguments.emplace_back("--json");
    return Json::parse(call(std::move(arguments)));
  }
  std::string file(const std::string& name) const { return folder_.file(name); }

  TestFolder folder_;
};

TEST_F(StimulusStudy, IsChecked) {
  const Json study = json({"check", file("study.toml")})["studies"][0];
  ASSERT_EQ(study["stimuli"].size(), 1U);
  const Json& stimulus = study["stimuli"][0];
  EXPECT_EQ(stimulus["name"], "happy_then_sad");
  EXPECT_NEAR(stimulus["seconds"], 6, 2);
  EXPECT_EQ(stimulus["parts"].front()["label"], "happy");
  EXPECT_EQ(stimulus["parts"].back()["label"], "sad");
  EXPECT_NE(call({"check", file("study.toml")}).find("stimulus happy_then_sad: "),
            std::string::npos);
}

TEST_F(StimulusStudy, IsSimulatedReplayedAndReported) {
  call({"pack", file("study.toml"), "--out", file("changes.study")});
  std::filesystem::remove(file("walks.graph"));
  call({"simulate", file("changes.study"), "--participants", "11", "--seed", "1", "--db",
        file("s.db")});
  EXPECT_NO_THROW(call({"replay", file("s.db"), "--audit"})) << "it tells of differences";
  analysis::SelectionOptions options;
  options.include_simulated = true;
  const analysis::Section section =
      analysis::ratings_section(analysis::compute_results({file("s.db")}, options));
  const Json& ratings = section.json["ratings"];
  EXPECT_EQ(ratings["motions_in_set"], 10);
  ASSERT_EQ(ratings["stimuli"].size(), 41U);
  EXPECT_EQ(ratings["stimuli"][0]["stimulus"], "happy_then_sad");
  EXPECT_GT(ratings["stimuli"][0]["raters"], 4);
  EXPECT_NE(section.html.code.find("happy_then_sad"), std::string::npos);
}

}  // namespace
}  // namespace promenade::app
