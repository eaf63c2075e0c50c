// Studies in folders: made, copied and renamed whole, and told apart by what has happened in them.
#include "study/study_shelf.h"

#include <gtest/gtest.h>

#include "motion/files.h"
#include "study/embedded.h"
#include "study/store.h"
#include "tests/test_folder.h"
#include "toy.h"

namespace promenade::study {
namespace {

namespace fs = std::filesystem;

class Shelf : public testing::Test {
 protected:
  // As the desk would, through the sessions of the study.
  void take_part(const StudyPlace& place, const std::string& code, bool pilot, bool finished) {
    const StudyBundle bundle = toy::bundle();
    Store store(place.sessions(), bundle);
    const Plan plan = make_plan(bundle.study, store.next_sequence(false, pilot));
    store.begin_session(
        {.participant = code, .pilot = pilot, .started_utc = "2026-11-29T12:00:00Z"}, plan);
    if (!finished) return;
    store.write({SessionEnded{.t_us = 1, .outcome = Outcome::finished}});
    store.end_session("2026-11-29T12:10:00Z");
  }
  const ShelvedStudy& only() { return shelf_.look().at(0); }

  TestFolder folder_;
  StudyShelf shelf_{folder_.path() / "studies"};
};

TEST_F(Shelf, IsEmptyBeforeTheFirstStudy) { EXPECT_TRUE(shelf_.look().empty()); }

TEST_F(Shelf, MakesAStudyOfEachTemplateWithTheFilesThatItNames) {
  for (const std::string& name : study_templates()) {
    const StudyPlace place = shelf_.add_template(name, shelf_.free_name("Walks"));
    EXPECT_NE(read_file(place.file()).find("\"" + place.name() + "\""), std::string::npos) << name;
  }
  EXPECT_EQ(shelf_.look().size(), study_templates().size());
  EXPECT_EQ(only().state, StudyState::draft);
  EXPECT_EQ(only().problem, "");
}

TEST_F(Shelf, TakesTargetsAlongWithThePublishedStudy) {
  const StudyPlace place = shelf_.add_template("studies/oshita-2018.toml", "Again");
  EXPECT_TRUE(fs::exists(place.folder / "oshita-2018-targets.csv"));
}

TEST_F(Shelf, ChangesNothingButTheNameInTheFile) {
  const std::string text = "# mine\r\n[study]\r\nname   =  'old' # why\r\nset = \"s\"\r\n";
  EXPECT_EQ(with_study_name(text, "a \"new\" one"),
            "# mine\r\n[study]\r\nname   =  \"a \\\"new\\\" one\" # why\r\nset = \"s\"\r\n");
  EXPECT_EQ(with_study_name("[study]\nset = \"s\"\n", "x"), "[study]\nset = \"s\"\n");
}

TEST_F(Shelf, TellsDraftPilotedRunningAndFinished) {
  const StudyPlace place = shelf_.add_template("demo.toml", "Walks");
  write_file(place.file(), "[study]\nparticipants = 1\n" + toy::study_text().substr(8));
  EXPECT_EQ(only().state, StudyState::draft);
  take_part(place, "T1", true, true);
  EXPECT_EQ(only().state, StudyState::piloted);
  EXPECT_EQ(only().pilots, 1);
  take_part(place, "P1", false, false);
  EXPECT_EQ(only().state, StudyState::running);
  EXPECT_EQ(only().open, 1);
  take_part(place, "P2", false, true);
  EXPECT_EQ(only().state, StudyState::finished);
  EXPECT_EQ(only().finished, 1);
  EXPECT_EQ(only().planned, 1);
  EXPECT_EQ(only().last_run_utc, "2026-11-29T12:00:00Z");
}

TEST_F(Shelf, LeavesSessionsBehindWhenAStudyIsDuplicated) {
  const StudyPlace place = shelf_.add_template("studies/oshita-2018.toml", "Walks");
  take_part(place, "P1", false, true);
  const StudyPlace copy = shelf_.duplicate(place, "Walks 2");
  EXPECT_TRUE(fs::exists(copy.folder / "oshita-2018-targets.csv"));
  EXPECT_FALSE(fs::exists(copy.sessions()));
  EXPECT_EQ(shelf_.look().at(1).state, StudyState::draft);
}

TEST_F(Shelf, KeepsTheNameInTheFileOnceSomebodyTookPart) {
  const StudyPlace draft = shelf_.add_template("demo.toml", "Walks");
  const StudyPlace named = shelf_.rename(draft, "Steps");
  EXPECT_FALSE(fs::exists(draft.folder));
  EXPECT_NE(read_file(named.file()).find("name = \"Steps\""), std::string::npos);
  take_part(named, "P1", false, true);
  const StudyPlace later = shelf_.rename(named, "Paces");
  EXPECT_NE(read_file(later.file()).find("name = \"Steps\""), std::string::npos);
  EXPECT_EQ(only().finished, 1);
}

TEST_F(Shelf, RefusesNamesThatAreTakenOrNoFolders) {
  shelf_.add_template("demo.toml", "Walks");
  const std::string long_name(61, 'x');
  for (const std::string& name : {std::string(), std::string("Walks"), std::string("a/b"),
                                  std::string(".."), std::string(" x"), long_name}) {
    EXPECT_THROW(shelf_.add_template("demo.toml", name), InputError) << name;
  }
  EXPECT_EQ(shelf_.look().size(), 1U);
  EXPECT_EQ(shelf_.free_name("Walks"), "Walks 2");
}

TEST_F(Shelf, ListsWhatItCannotReadWithTheReason) {
  const StudyPlace place = shelf_.add_template("demo.toml", "Walks");
  write_file(place.file(), "[study\n");
  EXPECT_NE(only().problem.find("study.toml:1"), std::string::npos) << only().problem;
  write_file(place.file(), "[study]\n");
  write_file(place.sessions(), "no database");
  EXPECT_NE(only().problem.find("sessions.db"), std::string::npos) << only().problem;
}

TEST_F(Shelf, RenamesNoStudyWhileASessionOfItRuns) {
  const StudyPlace place = shelf_.add_template("demo.toml", "Walks");
  take_part(place, "P1", false, false);  // by this very process, which lives
  EXPECT_EQ(only().live, 1);
  EXPECT_THROW(shelf_.rename(place, "Steps"), InputError);
  EXPECT_TRUE(is_there(place.sessions()));
}

TEST_F(Shelf, LivesWithFilesThatCannotBeLookedAt) {
  const StudyPlace place = shelf_.add_template("demo.toml", "Walks");
  fs::create_symlink(place.sessions(), place.sessions());
  fs::create_symlink("nowhere", folder_.path() / "studies" / "Lost");
  EXPECT_EQ(shelf_.look().size(), 1U);
}

TEST_F(Shelf, CopiesNothingFromOutsideOfTheFolder) {
  write_file(folder_.path() / "secret.csv", "x");
  write_file(folder_.path() / "in/study.toml", "[study]\nname = \"s\"\nset = \"../secret.csv\"\n");
  const StudyPlace place = shelf_.add_file(folder_.path() / "in/study.toml", "In");
  EXPECT_EQ(std::distance(fs::directory_iterator(place.folder), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace promenade::study
