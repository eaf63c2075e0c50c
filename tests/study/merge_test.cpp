#include "study/merge.h"

#include "folder.h"
#include "motion/files.h"
#include "old_database.h"
#include "station.h"
#include "study/migrate.h"
#include "study/schema.h"

namespace promenade::study {
namespace {

namespace fs = std::filesystem;

class MergeTest : public FolderTest {
 protected:
  std::string out() const { return file("all.db"); }

  // What is said when the files are merged; the folder must be as before.
  std::string refusal(const std::vector<std::string>& inputs) const {
    const bool there = fs::exists(out());
    const Content before = there ? content_of(out()) : Content();
    const std::string said = message_of([&] { merge(out(), inputs); });
    EXPECT_THROW(merge(out(), inputs), InputError);
    EXPECT_EQ(fs::exists(out()), there);
    EXPECT_FALSE(fs::exists(out() + ".part"));
    if (there) {
      EXPECT_EQ(content_of(out()), before);
    }
    return said;
  }

  void change(const std::string& name, const std::string& sql) const {
    Database(file(name), Database::Mode::read_write).exec("PRAGMA foreign_keys = OFF;" + sql);
  }
};

bool says(const std::string& message, const std::string& part) {
  return message.find(part) != std::string::npos;
}

TEST_F(MergeTest, JoinsEveryRowOfTheStations) {
  toy::make_station(file("a.db"), {"P01", "P02"});
  toy::make_station(file("b.db"), {"P03"}, 2);
  const Merged merged = merge(out(), {file("a.db"), file("b.db")});
  EXPECT_EQ(merged.sessions, 3);
  EXPECT_EQ(merged.inputs[1].taken.at("trial"), 6);
  for (const char* table : {"participant", "session", "trial", "event", "sample", "answer"}) {
    const std::string count = std::string("SELECT count(*) FROM ") + table;
    EXPECT_EQ(number_in(out(), count),
              number_in(file("a.db"), count) + number_in(file("b.db"), count))
        << table;
  }
  EXPECT_EQ(number_in(out(), "SELECT count(*) FROM study"), 1);
  EXPECT_EQ(number_in(out(), "SELECT count(*) FROM motion_set"), 1);
  EXPECT_EQ(number_in(out(), "SELECT count(*) FROM pragma_foreign_key_check"), 0);
}

TEST_F(MergeTest, ChangesNothingButReceiptsWhenItIsDoneAgain) {
  toy::make_station(file("a.db"), {"P01", "P02"});
  toy::make_station(file("b.db"), {"P03"}, 2);
  merge(out(), {file("a.db"), file("b.db")});
  const Content once = content_of(out(), {"receipt"});
  const Merged again = merge(out(), {file("b.db"), file("a.db"), file("b.db")});
  EXPECT_EQ(content_of(out(), {"receipt"}), once);
  EXPECT_EQ(again.inputs[1].known, 2);
  EXPECT_EQ(number_in(out(), "SELECT count(*) FROM receipt"), 5);
}

TEST_F(MergeTest, KeepsAReceiptOfEachInput) {
  toy::make_station(file("a.db"), {"P01"});
  merge(out(), {file("a.db")});
  Database database(out(), Database::Mode::read_only);
  EXPECT_EQ(texts_in(database, "SELECT source || ' ' || sha256 FROM receipt"),
            std::vector<std::string>{file("a.db") + " " + sha256_hex(read_file(file("a.db")))});
  EXPECT_EQ(number_in(database, "SELECT rows_taken ->> 'trial' FROM receipt"), 6);
}

TEST_F(MergeTest, AddsToADatabaseThatIsThere) {
  toy::make_station(out(), {"P01"});
  toy::make_station(file("b.db"), {"P02"}, 1);
  EXPECT_EQ(merge(out(), {file("b.db")}).sessions, 2);
}

TEST_F(MergeTest, TakesOldFilesAsTheyAreAndMigratesOnlyWhatItWrites) {
  make_old_database(file("old.db"), 1);
  const std::string before = read_file(file("old.db"));
  EXPECT_EQ(merge(out(), {file("old.db")}).sessions, 2);
  EXPECT_EQ(merge(out(), {file("old.db")}).inputs[0].known, 2);
  EXPECT_TRUE(read_file(file("old.db")) == before);
  fs::copy(file("old.db"), file("into.db"));
  EXPECT_EQ(merge(file("into.db"), {out()}).inputs[0].known, 2);
  EXPECT_TRUE(fs::exists(file("into.db.v1.backup")));
}

TEST_F(MergeTest, LeavesAnOldOutputAloneWhenThereIsAConflict) {
  make_old_database(out(), 1);
  toy::make_station(file("a.db"), {"P01"});
  EXPECT_TRUE(says(refusal({file("a.db")}), "another study"));
  EXPECT_EQ(number_in(out(), "PRAGMA user_version"), 1);
}

TEST_F(MergeTest, RefusesAnotherStudy) {
  toy::make_station(file("a.db"), {"P01"});
  toy::make_station(file("b.db"), {"P02"}, 1, toy::study_text() + "# changed\n");
  EXPECT_TRUE(says(refusal({file("a.db"), file("b.db")}), "b.db: error: holds another study"));
}

TEST_F(MergeTest, CarriesEveryVersionOfAnAmendedStudy) {
  toy::make_station(file("a.db"), {"P01"});
  fs::copy(file("a.db"), file("b.db"));
  change("b.db",
         "INSERT INTO study SELECT 'new', name, '2', config_text, 'new hash', program_version, "
         "created_utc, motion_set FROM study; INSERT INTO study_part VALUES('new', 'x.csv', x'78');"
         "INSERT INTO amendment SELECT 'new', uuid, 'a typo', 'today', 1 FROM study WHERE uuid <> "
         "'new'; INSERT INTO participant VALUES('p9', 'P09');"
         "INSERT INTO session SELECT 's9', 'new', 'p9', station, seed, 9, language, started_utc, "
         "ended_utc, outcome, simulated, pilot, process, machine, process_start, resumed, alive_us "
         "FROM "
         "session");
  EXPECT_EQ(merge(out(), {file("a.db"), file("b.db")}).sessions, 2);
  EXPECT_EQ(number_in(out(),
                      "SELECT count(*) FROM amendment JOIN study ON study.uuid = "
                      "amendment.previous WHERE reason = 'a typo'"),
            1);
  EXPECT_EQ(number_in(out(), "SELECT count(*) FROM study_part WHERE path = 'x.csv'"), 1);
  EXPECT_EQ(number_in(out(), "SELECT same_orders FROM amendment"), 1);
  EXPECT_EQ(number_in(out(), "SELECT count(*) FROM session WHERE study = 'new'"), 1);
}

TEST_F(MergeTest, RefusesTwoPeopleWithOneCode) {
  toy::make_station(file("a.db"), {"P01", "P02"});
  toy::make_station(file("b.db"), {"P01", "P02", "P03"}, 2);
  const std::string said = refusal({file("a.db"), file("b.db")});
  EXPECT_TRUE(says(said, "b.db: error: the code \"P01\" is somebody else's in " + file("a.db")));
  EXPECT_TRUE(says(said, "the code \"P02\"")) << "all at once: " << said;
}

TEST_F(MergeTest, RefusesOnePersonWithTwoCodes) {
  toy::make_station(file("a.db"), {"P01"});
  fs::copy(file("a.db"), file("b.db"));
  change("b.db", "UPDATE participant SET code = 'P77'");
  EXPECT_TRUE(says(refusal({file("a.db"), file("b.db")}), "has the code \"P77\" here and \"P01\""));
}

TEST_F(MergeTest, RefusesASessionThatIsNotTheSame) {
  toy::make_station(file("a.db"), {"P01"});
  const char* changes[] = {
      "UPDATE trial SET d_final = d_final + 1e-15 WHERE d_final > 0",
      "DELETE FROM sample WHERE rowid = 2",
      "UPDATE event SET value = 9 WHERE seq = 7",
      "UPDATE answer SET value = 1 WHERE rowid = 1",
      "INSERT INTO frame_histogram SELECT uuid, NULL, 'work', 0, 5 FROM session",
      "UPDATE session SET station = '2'"};
  for (const char* sql : changes) {
    fs::copy_file(file("a.db"), file("b.db"), fs::copy_options::overwrite_existing);
    change("b.db", sql);
    EXPECT_TRUE(says(refusal({file("a.db"), file("b.db")}), "is not the same as in")) << sql;
  }
}

TEST_F(MergeTest, RefusesAStudyWhoseMotionsWereChanged) {
  toy::make_station(file("a.db"), {"P01"});
  toy::make_station(file("b.db"), {"P02"}, 1);
  change("b.db", "UPDATE motion_set SET sha256 = 'other'");
  EXPECT_TRUE(says(refusal({file("a.db"), file("b.db")}), "but other motions"));
}

TEST_F(MergeTest, RefusesASessionThatRuns) {
  toy::make_station(file("a.db"), {"P01"});
  const StudyBundle bundle = toy::bundle();
  Store store(file("b.db"), bundle);
  store.begin_session(toy::header("P02"), make_plan(bundle.study, 1));
  EXPECT_TRUE(says(refusal({file("a.db"), file("b.db")}), "b.db: error: a session runs in it"));
}

// Copies the database of a session that has got so far, as if its process was killed there.
void copy_cut_off(const std::string& from, const std::string& to) {
  Database source(from, Database::Mode::read_only);
  Database copy(to, Database::Mode::create);
  backup(source, copy);
  copy.exec("UPDATE session SET process_start = 'another boot:1' WHERE process IS NOT NULL");
}

TEST_F(MergeTest, TakesASessionWhoseLastPageWasOpenAndLaterItsEnd) {
  const StudyBundle bundle = toy::bundle();
  toy::Player player(bundle, 0);
  {
    Store store(file("a.db"), bundle);
    store.begin_session(toy::header("P01"), player.session.plan());
    player.at(0, Continue{});
    player.at(1, Decline{});
    store.write(player.records);
    copy_cut_off(file("a.db"), file("cut.db"));
    store.write(player.at(2, Continue{}));
    store.end_session("2026-11-22T17:00:00Z");
  }
  EXPECT_EQ(merge(out(), {file("cut.db")}).sessions, 1);
  merge(out(), {file("a.db")});
  EXPECT_EQ(number_in(out(), "SELECT count(*) FROM event WHERE kind = 'continue'"), 2);
}

TEST_F(MergeTest, TakesAnInterruptedSessionAndLaterWhatBecameOfIt) {
  const StudyBundle bundle = toy::bundle();
  toy::Player player(bundle, 0);
  {
    Store store(file("a.db"), bundle);
    store.begin_session(toy::header("P01"), player.session.plan());
    player.to_trial(1'000'000);
    store.write(player.records);
    store.flush();
    copy_cut_off(file("a.db"), file("cut.db"));
    player.records.clear();
    player.whole_session();
    store.write(player.records);
    store.end_session("2026-11-22T17:00:00Z");
  }
  EXPECT_EQ(merge(out(), {file("cut.db")}).sessions, 1);
  EXPECT_EQ(merge(out(), {file("a.db")}).inputs[0].gone_on, 1);
  EXPECT_EQ(number_in(out(), "SELECT count(*) FROM session WHERE outcome = 'finished'"), 1);
  EXPECT_EQ(merge(out(), {file("cut.db")}).inputs[0].known, 1);
  EXPECT_EQ(number_in(out(), "SELECT count(*) FROM event"),
            number_in(file("a.db"), "SELECT count(*) FROM event"));
}

TEST_F(MergeTest, RemovesWhoWithdrewAnywhereForGood) {
  toy::make_station(file("a.db"), {"P01", "P02"});
  fs::copy(file("a.db"), file("a-before.db"));
  merge(out(), {file("a.db")});
  withdraw(file("a.db"), "P01");
  const Merged merged = merge(out(), {file("a.db")});
  EXPECT_EQ(merged.removed.at("session"), 1);
  EXPECT_EQ(read_file(out()).find("P01"), std::string::npos);
  const Merged again = merge(out(), {file("a-before.db")});
  EXPECT_EQ(again.inputs[0].withdrawn, 1);
  EXPECT_EQ(again.sessions, 1);
  EXPECT_EQ(number_in(out(), "SELECT count(*) FROM participant WHERE code = 'P01'"), 0);
}

TEST_F(MergeTest, TakesTheUnlinkedSessionInsteadOfTheOneWithTheCode) {
  toy::make_station(file("a.db"), {"P01"}, 0,
                    toy::study_text() + "[safety]\nwithdraw = \"link\"\n");
  merge(out(), {file("a.db")});
  withdraw(file("a.db"), "P01");
  EXPECT_EQ(merge(out(), {file("a.db")}).sessions, 1);
  EXPECT_EQ(number_in(out(), "SELECT count(*) FROM session WHERE outcome = 'withdrawn'"), 1);
  EXPECT_EQ(number_in(out(), "SELECT count(*) FROM trial"), 6);
}

TEST_F(MergeTest, GivesSimulatedPeopleFreeCodes) {
  toy::make_station(file("a.db"), {"S001", "S002"}, 0, toy::study_text(), true);
  toy::make_station(file("b.db"), {"S001"}, 0, toy::study_text(), true);
  const Merged merged = merge(out(), {file("a.db"), file("b.db")});
  EXPECT_EQ(merged.sessions, 3);
  EXPECT_EQ(merged.renamed.at(file("b.db") + ": S001"), "S003");
  const Content once = content_of(out(), {"receipt"});
  merge(out(), {file("b.db"), file("a.db")});
  EXPECT_EQ(content_of(out(), {"receipt"}), once);
}

TEST_F(MergeTest, WarnsOfOrdersThatWereGivenTwice) {
  toy::make_station(file("a.db"), {"P01", "P02"});
  toy::make_station(file("b.db"), {"P03"}, 1);
  const Merged merged = merge(out(), {file("a.db"), file("b.db")});
  ASSERT_EQ(merged.warnings.size(), 1U);
  EXPECT_TRUE(says(merged.warnings[0].message, "each of the orders 1;"));
}

TEST_F(MergeTest, TakesTheLaterStateOfTheRoster) {
  toy::make_station(file("a.db"), {"P01"});
  fs::copy(file("a.db"), file("b.db"));
  change("a.db", "INSERT INTO roster VALUES('P01','1',0,'booked',NULL,'2026-11-01')");
  change("b.db", "INSERT INTO roster VALUES('P01','1',0,'done',NULL,'2026-11-02')");
  merge(out(), {file("b.db"), file("a.db")});
  EXPECT_EQ(number_in(out(), "SELECT count(*) FROM roster WHERE state = 'done'"), 1);
  change("a.db", "UPDATE roster SET sequence = 5");
  EXPECT_TRUE(says(refusal({file("a.db")}), "its roster says something else about \"P01\""));
}

TEST_F(MergeTest, StopsWhenItIsToldAndLeavesNothing) {
  toy::make_station(file("a.db"), {"P01", "P02"});
  EXPECT_THROW(merge(out(), {file("a.db")}, [](int done, int) { return done < 2; }), OutsideError);
  EXPECT_FALSE(fs::exists(out()));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(MergeTest, NamesEveryFileThatIsNoDatabaseAtOnce) {
  toy::make_station(file("a.db"), {"P01"});
  const std::string bytes = read_file(file("a.db"));
  write_file(file("half.db"), bytes.substr(0, bytes.size() / 2));
  write_file(file("text.db"), std::string(200, 'x'));
  fs::copy(file("a.db"), file("new.db"));
  change("new.db", "PRAGMA user_version = 99");
  fs::copy(file("a.db"), file("lost.db"));
  change("lost.db", "DELETE FROM participant");
  const std::string said = refusal({file("a.db"), file("half.db"), file("text.db"), file("new.db"),
                                    file("lost.db"), file("none.db"), folder_.string()});
  for (const char* part :
       {"half.db: error: is damaged", "text.db: error: is not a database", "newer Promenade",
        "lost.db: error: is damaged", "none.db: error: does not exist", "is a folder"}) {
    EXPECT_TRUE(says(said, part)) << part << " in " << said;
  }
}

TEST_F(MergeTest, RefusesTheOutputAmongTheInputs) {
  toy::make_station(out(), {"P01"});
  EXPECT_TRUE(says(refusal({out()}), "is the database that is merged into"));
}

TEST_F(MergeTest, SaysWhereItCannotWrite) {
  toy::make_station(file("a.db"), {"P01"});
  EXPECT_THROW(merge("/proc/none/all.db", {file("a.db")}), OutsideError);
  write_file(out(), std::string(200, 'x'));
  EXPECT_TRUE(says(message_of([&] { merge(out(), {file("a.db")}); }), "all.db: error: is not a "));
}

}  // namespace
}  // namespace promenade::study
