#include "analysis/prereg/plan.h"

#include <gtest/gtest.h>

#include "motion/problem.h"
#include "study/study.h"

namespace promenade::analysis {
namespace {

constexpr const char* good = R"(hypotheses = ["With the map people come closer than with labels."]
participants = 24
stopping = "When 24 people have finished."

[exclusions]
words = ["who does not understand the task"]
min_trials = 8
max_flagged_share = 0.25

[[measure]]
name = "d_final"
task = "match"

[[measure]]
name = "satisfaction"
task = "find"
pairs = [{ a = "map", b = "labels" }]
)";

// Two interfaces, two tasks with an interface, one without, a rating after each trial.
study::Study toy_study() {
  study::Study study;
  for (const char* name : {"map", "labels"}) study.interfaces.push_back({name, name, {}, nullptr});
  for (const char* name : {"match", "find", "rate"}) {
    study.tasks.emplace_back();
    study.tasks.back().name = name;
  }
  study.tasks[2].kind = study::TaskKind::rate;
  study.instruments.emplace_back();
  study.instruments[0].items.emplace_back();
  study.instruments[0].items[0].name = "satisfaction";
  study.questionnaires.push_back({0, study::Questionnaire::When::trial, {}});
  return study;
}

std::string problems(const std::string& text) {
  const study::Study study = toy_study();
  try {
    read_plan("plan.toml", text, &study);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string with(const std::string& old_words, const std::string& words) {
  std::string text = good;
  text.replace(text.find(old_words), old_words.size(), words);
  return text;
}

TEST(Plan, IsReadWhole) {
  const study::Study study = toy_study();
  const AnalysisPlan plan = read_plan("plan.toml", good, &study);
  EXPECT_EQ(plan.hypotheses.size(), 1U);
  EXPECT_EQ(plan.participants, 24);
  EXPECT_EQ(plan.stopping, "When 24 people have finished.");
  EXPECT_EQ(plan.alpha, 0.05);
  EXPECT_EQ(plan.family, HolmFamily::measure);
  EXPECT_EQ(plan.exclusions.min_trials, 8);
  EXPECT_EQ(plan.exclusions.max_flagged_share, 0.25);
  ASSERT_EQ(plan.measures.size(), 2U);
  EXPECT_TRUE(plan.measures[0].pairs.empty());
  ASSERT_EQ(plan.measures[1].pairs.size(), 1U);
  EXPECT_EQ(plan.measures[1].pairs[0].b, "labels");
}

TEST(Plan, IsRefusedAtThePlaceOfEachMistake) {
  const struct {
    const char *old_words, *words, *problem;
  } broken[] = {
      {"hypotheses = [\"With the map people come closer than with labels.\"]", "",
       "\"hypotheses\" is missing"},
      {"[\"With the map people come closer than with labels.\"]", "[]",
       "plan.toml:1:14: error: names no hypothesis"},
      {"\"With the map people come closer than with labels.\"", "\" \"",
       "plan.toml:1:15: error: is empty"},
      {"participants = 24", "participants = 0", "plan.toml:2:16: error: "},
      {"participants = 24", "particpants = 24", "did you mean \"participants\"?"},
      {"stopping = \"When 24 people have finished.\"", "", "\"stopping\" is missing"},
      {"participants = 24", "participants = 24\nalpha = 2", "plan.toml:3:9: error: "},
      {"participants = 24", "participants = 24\nfamily = \"every\"", "plan.toml:3:10: error: "},
      {"participants = 24", "participants = 24\npooling = \"trials\"", "plan.toml:3:11: error: "},
      {"min_trials = 8", "min_trials = -1", "plan.toml:7:14: error: "},
      {"max_flagged_share = 0.25", "max_flagged_share = 25", "plan.toml:8:21: error: "},
      {"\"d_final\"", "\"d_finel\"",
       "plan.toml:11:8: error: the study has no measure \"d_finel\"; did you mean \"d_final\"?"},
      {"\"match\"", "\"rate\"",
       "plan.toml:12:8: error: the study has no task \"rate\"; it has \"match\", \"find\""},
      {"a = \"map\"", "a = \"mop\"", "no interface \"mop\"; did you mean \"map\"?"},
      {"a = \"map\"", "a = \"labels\"", "a pair has two different interfaces"},
      {"[{ a = \"map\", b = \"labels\" }]", "[]", "plan.toml:17:9: error: names no pair"},
      {"[{ a = \"map\", b = \"labels\" }]", "\"some\"", "plan.toml:17:9: error: "},
      {"name = \"satisfaction\"\ntask = \"find\"", "name = \"d_final\"\ntask = \"match\"",
       "stands above already"},
  };
  for (const auto& one : broken) {
    const std::string said = problems(with(one.old_words, one.words));
    EXPECT_NE(said.find(one.problem), std::string::npos) << one.words << "\n" << said;
  }
}

TEST(Plan, IsToldEverythingThatIsWrongAtOnce) {
  const std::string said = problems("participants = -1\nalpha = 7\n[[measure]]\nname = \"x\"\n");
  for (const char* words : {"hypotheses", "participants", "alpha", "stopping", "\"x\"", "task"}) {
    EXPECT_NE(said.find(words), std::string::npos) << words << "\n" << said;
  }
}

TEST(Plan, WithoutAStudyMayNameAnything) {
  EXPECT_NO_THROW(read_plan("plan.toml", with("\"d_final\"", "\"other\""), nullptr));
}

}  // namespace
}  // namespace promenade::analysis
