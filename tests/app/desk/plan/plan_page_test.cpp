// Orders, balance and power at the desk.
#include "app/desk/plan/plan_power.h"
#include "tests/app/desk/desk_bench.h"

namespace promenade::app {
namespace {

class PlanDesk : public bench::DeskBench {
 protected:
  PlanDesk() : study_(make_study("Walks")) { plan(study_); }
  // Waits until nothing on the page changes any more.
  void plan(const study::StudyPlace& study) {
    open(study, DeskPlace::plan);
    ASSERT_TRUE(wait_until([this] { return !desk_.moves(); }));
    frames(2);
  }
  study::StudyPlace study_;
};

TEST_F(PlanDesk, AsksForPowerAroundTheNumberOfPeople) {
  press("power");
  EXPECT_EQ(asked(),
            "power Walks/study.toml --participants 6,12,18,24 --jobs 2 --studies 100 --json\n");
}

TEST_F(PlanDesk, TakesAnotherNumberByKeyboard) {
  tab_to("type", "people");
  key(GLFW_KEY_UP);
  ASSERT_TRUE(wait_until([this] { return !desk_.moves(); }));
  tab_to("press", "power");
  key(GLFW_KEY_ENTER);
  EXPECT_NE(asked().find("--participants 6,13,19,26"), std::string::npos);
}

TEST_F(PlanDesk, PlansAsManyPeopleAsTheStudySays) {
  const study::StudyPlace large = make_study("Large");
  std::string text = read_file(large.file());
  text.insert(text.find("[study]") + 8, "participants = 40\n");
  write_file(large.file(), text);
  plan(large);
  press("power");
  EXPECT_NE(asked().find("--participants 20,40,60,80"), std::string::npos);
}

TEST(PowerTable, KeepsThePowerOfEachSizeAndPair) {
  const PowerTable table = read_power(
      R"({"participants": [8, 16, 24], "tables": [{"task": "copy", "measure": "d_final", "rows": [
          {"a": "map", "b": "labels", "participants": 8, "power": 0.5},
          {"a": "map", "b": "labels", "participants": 16, "power": 0.85},
          {"a": "map", "b": "labels", "participants": 24, "power": 0.95}]}]})");
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows[0].power, (std::vector<double>{0.5, 0.85, 0.95}));
  EXPECT_EQ(needed_people(table, table.rows[0], 0.8), 16);
  EXPECT_EQ(needed_people(table, table.rows[0], 0.99), 0);
}

TEST(PowerTable, IsEmptyWhenTheAnswerIsNone) {
  for (const char* text : {"", "[]", "{\"participants\": 3}", "{\"participants\": [3]}"}) {
    EXPECT_TRUE(read_power(text).rows.empty()) << text;
  }
}

}  // namespace
}  // namespace promenade::app
