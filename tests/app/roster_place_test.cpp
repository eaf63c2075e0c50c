#include "app/roster_place.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "motion/files.h"
#include "study/person_code.h"
#include "study/schema.h"
#include "study/sqlite.h"
#include "tests/study/old_database.h"

namespace promenade::app {
namespace {

namespace fs = std::filesystem;
using Kind = RosterAnswer::Kind;
using study::Attendance;

// Two places at station 1, dealt as order 0 and 7; none is in the database yet.
class RosterPlace : public testing::Test {
 protected:
  RosterPlace() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    study::Rng rng(1, 0, "codes");
    for (const int sequence : {0, 7}) {
      rows_.push_back({study::draw_person_code(rng), "1", sequence, Attendance::booked, ""});
    }
    write_file(check_.roster = (folder_ / "roster.csv").string(), study::roster_csv(rows_));
    check_.database = (folder_ / "toy.db").string();
    check_.station = "1";
  }
  ~RosterPlace() override { fs::remove_all(folder_); }

  Kind kind_of(const std::string& typed) {
    check_.participant = typed;
    return ask_roster(check_).kind;
  }

  fs::path folder_ = fs::temp_directory_path() / ("promenade_place_" + std::to_string(::getpid()));
  std::vector<study::RosterRow> rows_;
  RosterCheck check_;
};

TEST_F(RosterPlace, IsFoundByACodeAsItWasTyped) {
  check_.participant = rows_[1].code.substr(0, 3) + "-" + rows_[1].code.substr(3);
  const RosterAnswer answer = ask_roster(check_);
  EXPECT_EQ(answer.kind, Kind::welcome);
  EXPECT_EQ(answer.row.code, rows_[1].code);
  EXPECT_EQ(answer.row.sequence, 7);
  EXPECT_EQ(kind_of("somebody"), Kind::unknown);
  EXPECT_EQ(kind_of(""), Kind::unknown);
}

TEST_F(RosterPlace, IsTakenByWhoWasDoneWithItInADatabaseOfAnyVersion) {
  study::make_old_database(check_.database, 1);  // two simulated people, orders 0 and 1
  EXPECT_EQ(kind_of(rows_[0].code), Kind::welcome) << "nobody real";
  check_.simulated = true;
  EXPECT_EQ(kind_of(rows_[0].code), Kind::taken);
  EXPECT_EQ(next_place(check_).code, rows_[1].code);
}

TEST_F(RosterPlace, IsStoredAsDoneWhenTheSessionFinished) {
  {
    study::Database database(check_.database, study::Database::Mode::create);
    study::create_tables(database);
  }
  check_.participant = rows_[0].code;
  store_place(check_, study::Outcome::stopped);
  EXPECT_EQ(kind_of(rows_[0].code), Kind::welcome);
  store_place(check_, study::Outcome::finished);
  EXPECT_EQ(kind_of(rows_[0].code), Kind::taken);
  check_.participant = "another";
  store_place(check_, study::Outcome::finished);
  EXPECT_EQ(next_place(check_).code, rows_[1].code);
}

TEST_F(RosterPlace, IsMissingWhereAllHaveCome) {
  check_.station = "2";
  EXPECT_THROW(next_place(check_), InputError);
}

}  // namespace
}  // namespace promenade::app
