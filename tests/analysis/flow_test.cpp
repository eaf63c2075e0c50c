#include "analysis/flow.h"

#include <gtest/gtest.h>

#include "tests/analysis/toy_log.h"

namespace promenade::analysis {
namespace {

void place(ToyLog& log, const std::string& code, const std::string& state) {
  log.database().exec("INSERT INTO roster VALUES ('" + code + "', '1', 0, '" + state +
                      "', NULL, '')");
}

void grave(ToyLog& log, const std::string& person, const std::string& removed) {
  log.database().exec("INSERT INTO tombstone VALUES ('" + person + "', '', '" + removed + "')");
}

Flow flow_in(const Log& log) { return flow_of(log, select(log, {})); }

TEST(Flow, CountsThePlacesOfTheRoster) {
  const TestFolder folder;
  ToyLog log(folder.file("a.db"));
  fill(log, 2, 0.01);
  log.session({"P3", "declined"});
  for (const auto& [code, state] : {std::pair{"P1", "done"},
                                    {"P2", "done"},
                                    {"P3", "booked"},
                                    {"P4", "no_show"},
                                    {"P5", "replaced"},
                                    {"P6", "booked"}}) {
    place(log, code, state);
  }
  const Flow flow = flow_in(read_log(log.database()));
  EXPECT_EQ(flow.booked, 6);
  EXPECT_EQ(flow.no_show, 1);
  EXPECT_EQ(flow.replaced, 1);
  EXPECT_EQ(flow.expected, 1) << "P3 came, and declined";
  EXPECT_EQ(flow.began, 3);
  EXPECT_EQ(flow.analysed, 2);
}

TEST(Flow, CountsWhoWithdrewAndOfWhomNothingIsLeft) {
  const TestFolder folder;
  ToyLog log(folder.file("a.db"));
  fill(log, 2, 0.01);
  log.session({"P3", "withdrawn"});
  grave(log, "gone", "everything");
  grave(log, "unlinked", "link");
  const Flow flow = flow_in(read_log(log.database()));
  EXPECT_EQ(flow.withdrawn, 2) << "one of them has a session, with its link gone";
  EXPECT_EQ(flow.removed, 1);
  EXPECT_EQ(flow.began, 4);
}

TEST(Flow, CountsATombstoneOfTwoFilesOnce) {
  const TestFolder folder;
  for (const char* file : {"a.db", "b.db"}) {
    ToyLog log(folder.file(file));
    fill(log, 1, 0.01, file);
    grave(log, "gone", "everything");
  }
  EXPECT_EQ(flow_in(read_log({folder.file("a.db"), folder.file("b.db")})).withdrawn, 1);
}

TEST(Flow, AddsUpToWhoBegan) {
  const TestFolder folder;
  ToyLog log(folder.file("a.db"));
  fill(log, 2, 0.01);
  log.session({"P8", "stopped"}).session({"P9", "declined"});
  grave(log, "gone", "everything");
  const Flow flow = flow_in(read_log(log.database()));
  EXPECT_EQ(flow.began,
            flow.declined + flow.withdrawn + flow.unfinished + flow.excluded + flow.analysed);
}

}  // namespace
}  // namespace promenade::analysis
