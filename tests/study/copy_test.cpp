#include "study/copy.h"

#include <sys/stat.h>

#include <future>

#include "folder.h"
#include "motion/files.h"
#include "station.h"

namespace promenade::study {
namespace {

namespace fs = std::filesystem;

// A study in a folder of its own that asks for copies in another.
class CopyTest : public FolderTest {
 protected:
  CopyTest() {
    bundle_.file = file("toy.toml");
    bundle_.study.safety.copy_to = "stick/copies";
    fs::create_directories(folder_ / "stick/copies");
  }
  std::string copy() const { return file("stick/copies/toy-1.db"); }
  std::optional<std::string> renew(const std::string& station = "1") const {
    return second_copy_problem(bundle_, file(), station);
  }
  std::string problem() const { return renew().value_or(""); }

  StudyBundle bundle_ = toy::bundle();
};

TEST_F(CopyTest, IsTheSameDatabaseForItsOwnerOnly) {
  toy::make_station(file(), {"P01", "P02"});
  EXPECT_EQ(renew(), std::nullopt);
  EXPECT_EQ(content_of(copy(), {"backup"}), content_of(file(), {"backup"}));
  struct stat status {};
  ASSERT_EQ(::stat(copy().c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600U);
  EXPECT_EQ(std::distance(fs::directory_iterator(fs::path(copy()).parent_path()), {}), 1);
}

TEST_F(CopyTest, IsKnownToTheDatabase) {
  toy::make_station(file(), {"P01"});
  renew();
  renew();
  Database database(file(), Database::Mode::read_only);
  EXPECT_EQ(texts_in(database, "SELECT path FROM backup WHERE made_utc > '2026'"),
            std::vector<std::string>{copy()});
}

TEST_F(CopyTest, HasWhatARunningSessionWroteBeside) {
  const StudyBundle bundle = toy::bundle();
  Store store(file(), bundle);
  toy::log_session(store, bundle, toy::header("P01"), 0);
  EXPECT_EQ(renew(), std::nullopt);
  toy::log_session(store, bundle, toy::header("P02"), 1);
  EXPECT_EQ(number_in(copy(), "SELECT count(*) FROM session"), 1);
  EXPECT_EQ(renew(), std::nullopt);
  EXPECT_EQ(number_in(copy(), "SELECT count(*) FROM session"), 2);
}

TEST_F(CopyTest, MayRunWhileTheNextSessionIsLogged) {
  const StudyBundle bundle = toy::bundle();
  Store store(file(), bundle);
  toy::log_session(store, bundle, toy::header("P01"), 0);
  auto copying = std::async(std::launch::async, [this] { return renew(); });
  for (int i = 1; i < 20; ++i) {
    toy::log_session(store, bundle, toy::header("Q" + std::to_string(i)), i);
  }
  EXPECT_EQ(copying.get(), std::nullopt);
  Database made(copy(), Database::Mode::read_only);
  EXPECT_EQ(texts_in(made, "PRAGMA integrity_check"), std::vector<std::string>{"ok"});
}

TEST_F(CopyTest, HasANameForEachStation) {
  toy::make_station(file(), {"P01"});
  EXPECT_EQ(renew("room 2/b"), std::nullopt);
  EXPECT_TRUE(fs::exists(file("stick/copies/toy-room 2_b.db")));
}

TEST_F(CopyTest, IsNotMadeWhereTheStudyAsksForNone) {
  toy::make_station(file(), {"P01"});
  bundle_.study.safety.copy_to = "";
  EXPECT_EQ(renew(), std::nullopt);
  EXPECT_EQ(second_copy_path(bundle_, file(), "1"), "");
  EXPECT_EQ(number_in(file(), "SELECT count(*) FROM backup"), 0);
}

TEST_F(CopyTest, NeverReplacesTheCopyOfAnotherDatabase) {
  toy::make_station(file(), {"P01", "P02"});
  renew();
  const std::string before = read_file(copy());
  fs::remove(file());
  toy::make_station(file(), {"P09"});  // somebody lost the file and began anew
  EXPECT_NE(problem().find("is the copy of another database"), std::string::npos) << problem();
  EXPECT_TRUE(read_file(copy()) == before);
}

TEST_F(CopyTest, ReplacesACopyThatIsBroken) {
  toy::make_station(file(), {"P01"});
  write_file(copy(), "SQLite format 3 and then the stick was pulled out");
  EXPECT_EQ(renew(), std::nullopt);
  EXPECT_EQ(number_in(copy(), "SELECT count(*) FROM session"), 1);
}

TEST_F(CopyTest, SaysThatTheFolderIsNotThere) {
  toy::make_station(file(), {"P01"});
  fs::remove_all(folder_ / "stick");
  EXPECT_NE(problem().find("there is no folder " + file("stick/copies")), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "stick"));
}

TEST_F(CopyTest, KeepsTheOldCopyWhenTheNewOneIsNotWhatWasWritten) {
  toy::make_station(file(), {"P01"});
  renew();
  const std::string before = read_file(copy());
  fs::create_directories(copy() + ".part/full");  // nothing can be written there
  EXPECT_FALSE(problem().empty());
  EXPECT_TRUE(read_file(copy()) == before);
}

TEST_F(CopyTest, SaysThatTheDatabaseIsGone) { EXPECT_FALSE(problem().empty()); }

}  // namespace
}  // namespace promenade::study
