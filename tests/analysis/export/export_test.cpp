#include "analysis/export/export.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "motion/files.h"
#include "motion/problem.h"
#include "study/csv.h"
#include "study/interface.h"
#include "tests/analysis/toy_log.h"

namespace promenade::analysis {
namespace {

namespace fs = std::filesystem;
using Rows = std::vector<std::map<std::string, std::string>>;

ExportNotes export_to(const TestFolder& folder, const std::string& out,
                      const SelectionOptions& selection = {}, bool is_public = false) {
  ExportOptions options;
  options.database = folder.file("a.db");
  options.folder = folder.file(out);
  options.selection = selection;
  options.is_public = is_public;
  return write_export(options, {});
}

Rows rows_in(const std::string& file) {
  const std::vector<study::CsvRow> lines = study::parse_csv(read_file(file));
  Rows rows;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].cells.size(), lines[0].cells.size()) << file << " " << i;
    rows.emplace_back();
    for (std::size_t k = 0; k < lines[i].cells.size(); ++k) {
      rows.back()[lines[0].cells[k]] = lines[i].cells[k];
    }
  }
  return rows;
}

Rows table_of(const TestFolder& folder, const std::string& table) {
  return rows_in(folder.file("out/data/description-" + table + "_data.csv"));
}

std::map<std::string, std::string> contents(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    files[fs::relative(entry.path(), folder).string()] = read_file(entry.path());
  }
  return files;
}

void make(const TestFolder& folder) {
  ToyLog log(folder.file("a.db"));
  fill(log, 3, 1.0 / 3);
}

TEST(Export, HasARowForEveryTrialWithItsExactValues) {
  const TestFolder folder;
  make(folder);
  export_to(folder, "out");
  const Rows trials = table_of(folder, "trial");
  ASSERT_EQ(trials.size(), 6u);
  EXPECT_EQ(trials[3].at("participant_code"), "P2");
  EXPECT_EQ(trials[3].at("interface"), "weights");
  EXPECT_EQ(study::parse_number(trials[3].at("d_final")), 0.01 * 2 + 0.02 + 1.0 / 3 * 2);
  EXPECT_EQ(trials[3].at("ended_us"), "22000000");
  EXPECT_EQ(trials[3].at("first_below_us"), "") << "no value is an empty cell";
}

TEST(Export, HasOneRowForEachPersonInTheWideTable) {
  const TestFolder folder;
  make(folder);
  export_to(folder, "out");
  const Rows people = rows_in(folder.file("out/people_wide.csv"));
  ASSERT_EQ(people.size(), 3u);
  EXPECT_EQ(people[1].at("participant_code"), "P2");
  EXPECT_EQ(people[1].at("time_s.match.labels"), "12");
  EXPECT_EQ(people[1].at("time_s.match.weights.happy"), "22");
}

TEST(Export, TakesTheMeanOverTargets) {
  const TestFolder folder;
  ToyLog(folder.file("a.db"))
      .session({})
      .trial({"labels", "happy", 10})
      .trial({"labels", "sad", 13});
  export_to(folder, "out");
  const Rows people = rows_in(folder.file("out/people_wide.csv"));
  EXPECT_EQ(people.at(0).at("time_s.match.labels"), "11.5");
  EXPECT_EQ(people.at(0).at("time_s.match.labels.sad"), "13");
}

TEST(Export, MarksPracticeAndRepeatedTrialsAndLeavesThemOutOfTheWideTable) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    log.session({}).trial({.seconds = 99, .practice = true}).trial({.seconds = 50});
    log.trial({.seconds = 20})
        .database()
        .exec("UPDATE trial SET superseded = 1 WHERE uuid = '1/2'");
  }
  export_to(folder, "out");
  std::vector<std::string> counts;
  for (const auto& trial : table_of(folder, "trial")) counts.push_back(trial.at("counts"));
  EXPECT_EQ(counts, (std::vector<std::string>{"0", "0", "1"}));
  EXPECT_EQ(rows_in(folder.file("out/people_wide.csv")).at(0).at("time_s.match.labels"), "20");
}

TEST(Export, KeepsSimulatedPeopleInTheTablesAndOutOfTheWideOne) {
  const TestFolder folder;
  ToyLog(folder.file("a.db")).session({"S1", "finished", true}).trial({});
  const ExportNotes notes = export_to(folder, "out");
  EXPECT_EQ(table_of(folder, "session").at(0).at("simulated"), "1");
  EXPECT_TRUE(rows_in(folder.file("out/people_wide.csv")).empty());
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.find("--include-simulated") != std::string::npos;
  }));
  export_to(folder, "out", {true, false, ""});
  EXPECT_EQ(rows_in(folder.file("out/people_wide.csv")).size(), 1u);
}

TEST(Export, SaysTheSameInTheLongTable) {
  const TestFolder folder;
  make(folder);
  export_to(folder, "out");
  const auto wide = rows_in(folder.file("out/people_wide.csv"));
  int found = 0;
  for (const auto& row : table_of(folder, "peopleLong")) {
    if (row.at("measure") != "d_final" || row.at("participant_code") != "P3") continue;
    const std::string target = row.at("target").empty() ? "" : "." + row.at("target");
    EXPECT_EQ(row.at("value"), wide[2].at("d_final.match." + row.at("interface") + target));
    ++found;
  }
  EXPECT_EQ(found, 4) << "two interfaces, each over all targets and for the one";
}

TEST(Export, ReadsWeightsOfUnknownMotionsByNumber) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    log.session({}).trial({}).database().exec(
        "INSERT INTO sample(trial, t_us, d, weights) VALUES "
        "('1/1', 5, 0.25, x'000000000000e03f000000000000f0bf')");
  }
  export_to(folder, "out");
  const auto sample = table_of(folder, "sample").at(0);
  EXPECT_EQ(sample.at("weight.1"), "0.5");
  EXPECT_EQ(sample.at("weight.2"), "-1");
}

TEST(Export, KeepsTextsToTheLetter) {
  const TestFolder folder;
  const std::string text = "=1+1, \"ä\"\nline";
  {
    ToyLog log(folder.file("a.db"));
    log.session({}).trial({}).answer("why", 1);
    study::Statement put(log.database(), "UPDATE answer SET text = ?");
    put.bind(1, text).run();
  }
  export_to(folder, "out");
  EXPECT_EQ(table_of(folder, "answer").at(0).at("text"), text);
}

TEST(Export, IsTheSameByteForByteWhenMadeAgain) {
  const TestFolder folder;
  make(folder);
  export_to(folder, "one");
  export_to(folder, "two");
  EXPECT_EQ(contents(folder.file("one")), contents(folder.file("two")));
}

TEST(Export, DescribesEveryColumnOfItsData) {
  const TestFolder folder;
  make(folder);
  export_to(folder, "out");
  const auto json = nlohmann::json::parse(read_file(folder.file("out/dataset_description.json")));
  EXPECT_EQ(json["@context"], "https://schema.org");
  EXPECT_EQ(json["@type"], "Dataset");
  EXPECT_FALSE(json["name"].empty() || json["description"].empty());
  std::set<std::string> named;
  for (const auto& variable : json["variableMeasured"]) {
    EXPECT_EQ(variable["@type"], "PropertyValue");
    EXPECT_TRUE(named.insert(variable["name"]).second) << variable["name"];
  }
  for (const auto& entry : fs::directory_iterator(folder.file("out/data"))) {
    const std::vector<study::CsvRow> rows = study::parse_csv(read_file(entry.path()));
    for (const std::string& column : rows.at(0).cells) {
      EXPECT_TRUE(named.count(column)) << entry.path() << " " << column;
    }
  }
}

TEST(Export, SaysWhatEveryColumnMeans) {
  const TestFolder folder;
  make(folder);
  export_to(folder, "out");
  for (const auto& row : rows_in(folder.file("out/codebook.csv"))) {
    EXPECT_FALSE(row.at("meaning").empty()) << row.at("file") << " " << row.at("column");
  }
}

TEST(Export, ReplacesAnOlderOneAndLeavesOtherFilesAlone) {
  const TestFolder folder;
  make(folder);
  write_file(folder.file("out/README.md"), "old");
  write_file(folder.file("out/notes.txt"), "mine");
  export_to(folder, "out");
  EXPECT_NE(read_file(folder.file("out/README.md")), "old");
  EXPECT_EQ(read_file(folder.file("out/notes.txt")), "mine");
}

TEST(Export, StopsWhenAskedAndLeavesNothingBehind) {
  const TestFolder folder;
  make(folder);
  ExportOptions options;
  options.database = folder.file("a.db");
  options.folder = folder.file("out");
  options.progress = [](const std::string&, int done, int) { return done < 3; };
  EXPECT_THROW(write_export(options, {}), OutsideError);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.file("")), {}), 1) << "a.db alone";
}

TEST(Export, OfWhatIsNoDatabaseWritesNothing) {
  const TestFolder folder;
  EXPECT_THROW(export_to(folder, "out"), InputError) << "missing";
  write_file(folder.file("a.db"), "hello");
  EXPECT_THROW(export_to(folder, "out"), InputError);
  EXPECT_FALSE(fs::exists(folder.file("out")));
}

TEST(Export, DoesNotOverwriteAFile) {
  const TestFolder folder;
  make(folder);
  write_file(folder.file("out"), "precious");
  EXPECT_THROW(export_to(folder, "out"), InputError);
  EXPECT_EQ(read_file(folder.file("out")), "precious");
}

}  // namespace
}  // namespace promenade::analysis
