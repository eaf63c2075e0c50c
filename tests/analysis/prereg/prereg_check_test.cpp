#include "analysis/prereg/prereg_check.h"

#include <gtest/gtest.h>

#include "analysis/prereg/sealed_plan.h"
#include "analysis/report/report_sections.h"
#include "analysis/results.h"
#include "analysis/statistics/p_adjust.h"
#include "motion/files.h"
#include "motion/problem.h"
#include "study/identity.h"
#include "tests/analysis/toy_log.h"

namespace promenade::analysis {
namespace {

constexpr const char* plan =
    "hypotheses = [\"weights are better\"]\nparticipants = 6\nstopping = \"at 6\"\n"
    "[[measure]]\nname = \"d_final\"\ntask = \"match\"\n"
    "[[measure]]\nname = \"time_s\"\ntask = \"match\"\n";

// What `promenade prereg` writes, as far as the check reads it.
std::string document_of(const std::string& text) {
  const std::string fence = fence_for(text);
  return "study file: " + study::sha256_hex(ToyLog::config) + "\nplan: " + study::sha256_hex(text) +
         "\n\n" + fence + "\n" + text + (text.back() == '\n' ? "" : "\n") + fence + "\n\n";
}

// The study of the toy log names this document.
void seal(ToyLog& log, const std::string& document) {
  const std::string config = "[study]\nprereg = \"p.md\"\n" + std::string(ToyLog::config);
  log.database().exec("UPDATE study SET config_text = '" + config + "'");
  study::Statement part(log.database(), "INSERT INTO study_part SELECT uuid, 'p.md', ? FROM study");
  part.bind_blob(1, document).run();
}

class PreregCheckTest : public testing::Test {
 protected:
  // A study of six people, sealed with `sealed` unless it is empty.
  void make(const std::string& sealed) {
    ToyLog log(folder_.file("a.db"));
    fill(log, 6, 0.001);
    if (!sealed.empty()) seal(log, sealed);
  }
  Results results(const SelectionOptions& options = {}) const {
    return compute_results({folder_.file("a.db")}, options);
  }
  PreregCheck check(const std::string& document, const SelectionOptions& options = {}) const {
    return check_prereg(results(options), "p.md", document);
  }
  static std::string all(const PreregCheck& check) {
    std::string text;
    for (const PlanDeviation& one : check.deviations) {
      text += one.about + ": " + one.planned + " / " + one.found + "\n";
    }
    return text;
  }
  TestFolder folder_;
};

// The line [study] is part of the text that the document is about.
std::string sealed_document(const std::string& text = plan) {
  std::string document = document_of(text);
  const std::string hash = study::sha256_hex(ToyLog::config);
  document.replace(document.find(hash), hash.size(),
                   study::sha256_hex("[study]\n" + std::string(ToyLog::config)));
  return document;
}

TEST_F(PreregCheckTest, FindsNothingWhereAllWasDoneAsPlanned) {
  make(sealed_document());
  const PreregCheck found = check(sealed_document());
  EXPECT_EQ(found.seal, SealState::sealed);
  EXPECT_EQ(all(found), "");
}

TEST_F(PreregCheckTest, SaysThatNothingWasSealed) {
  make("");
  const PreregCheck found = check(document_of(plan));
  EXPECT_EQ(found.seal, SealState::none);
  EXPECT_NE(all(found).find("nothing is sealed"), std::string::npos);
}

TEST_F(PreregCheckTest, SaysThatAnotherDocumentWasSealed) {
  make(sealed_document() + " ");
  const PreregCheck found = check(sealed_document());
  EXPECT_EQ(found.seal, SealState::other);
  EXPECT_NE(all(found).find("another document is sealed"), std::string::npos);
}

TEST_F(PreregCheckTest, SaysThatSessionsRanBeforeItWasSealed) {
  make("");
  {
    study::Database database(folder_.file("a.db"), study::Database::Mode::read_write);
    const std::string config = "[study]\nprereg = \"p.md\"\n" + std::string(ToyLog::config);
    database.exec(
        "INSERT INTO study SELECT 'later', name, '2', '" + config +
        "', 'def', program_version, '2026-11-23T10:00:00Z', motion_set FROM study;"
        "INSERT INTO amendment SELECT 'later', uuid, 'to seal it', '2026-11-23T10:00:00Z', 1 FROM "
        "study WHERE uuid <> 'later';"
        "UPDATE session SET study = 'later' WHERE uuid = '6'");
    study::Statement part(database, "INSERT INTO study_part VALUES ('later', 'p.md', ?)");
    part.bind_blob(1, sealed_document()).run();
  }
  const PreregCheck found = check(sealed_document());
  EXPECT_EQ(found.seal, SealState::late);
  EXPECT_NE(all(found).find("5 sessions ran before it was sealed"), std::string::npos);
  EXPECT_NE(all(found).find("changed to version \"2\" on 2026-11-23T10:00:00Z: to seal it"),
            std::string::npos);
}

TEST_F(PreregCheckTest, SaysThatTheStudyIsAnotherOne) {
  make(document_of(plan));
  EXPECT_NE(all(check(document_of(plan))).find("version \"1\" is another one"), std::string::npos);
}

TEST_F(PreregCheckTest, CountsPeople) {
  std::string more = plan;
  more.replace(more.find("participants = 6"), 16, "participants = 7");
  make(sealed_document(more));
  EXPECT_EQ(all(check(sealed_document(more))),
            "participants: 7 participants are analysed / 6, too few\n");
}

TEST_F(PreregCheckTest, TellsExclusionsByRuleFromThoseByHand) {
  std::string rules = plan;
  rules.insert(rules.find("[[measure]]"), "[exclusions]\nmin_trials = 2\n");
  make(sealed_document(rules));
  {
    study::Database database(folder_.file("a.db"), study::Database::Mode::read_write);
    database.exec(
        "UPDATE trial SET outcome = 'skipped' WHERE session IN ('1', '2') AND "
        "interface = 'labels'");
  }
  write_file(folder_.file("x.csv"), "P1,too few\nP3,sang\n");
  const std::string found =
      all(check(sealed_document(rules), {false, false, folder_.file("x.csv")}));
  EXPECT_EQ(found.find("P1 "), std::string::npos) << found;
  EXPECT_NE(found.find("P3 is excluded by hand: sang"), std::string::npos) << found;
  EXPECT_NE(found.find("P2 is excluded by rule: 1 trial counts / P2 is analysed"),
            std::string::npos)
      << found;
}

TEST_F(PreregCheckTest, NamesMeasuresThatHaveNoValues) {
  std::string other = plan;
  other.replace(other.find("d_final"), 7, "d_finel");
  make(sealed_document(other));
  EXPECT_EQ(all(check(sealed_document(other))),
            "measures: d_finel in match, weights - labels / there are no values of both\n");
}

TEST_F(PreregCheckTest, CorrectsOverTheFamilyOfThePlan) {
  make(sealed_document("family = \"all\"\n" + std::string(plan)));
  const Results found = results();
  const PreregCheck together =
      check_prereg(found, "p.md", sealed_document("family = \"all\"\n" + std::string(plan)));
  ASSERT_EQ(together.tests.size(), 2U);
  std::vector<double> p;
  for (const PlannedTest& test : together.tests) {
    p.push_back(*found.comparisons[static_cast<std::size_t>(test.comparison)].p);
  }
  EXPECT_EQ(*together.tests[0].p_holm, std::min(1.0, 2 * p[0]));
  EXPECT_EQ(*together.tests[1].p_holm, adjust_holm(p)[1]);
  EXPECT_EQ(together.exploratory, static_cast<int>(found.comparisons.size()) - 2);
  const PreregCheck apart = check_prereg(found, "p.md", sealed_document());
  EXPECT_EQ(*apart.tests[0].p_holm, p[0]);
}

TEST_F(PreregCheckTest, BecomesASectionWithItsTablesAndJson) {
  make("");
  Results found = results();
  EXPECT_EQ(prereg_section(found).title, "");
  found.prereg = check_prereg(found, "p.md", document_of(plan));
  const Section section = prereg_section(found);
  EXPECT_EQ(section.title, "Preregistration");
  EXPECT_NE(section.html.code.find("never sealed"), std::string::npos);
  ASSERT_EQ(section.tables.size(), 2U);
  EXPECT_EQ(section.tables[0].rows.size(), found.prereg->deviations.size());
  EXPECT_EQ(section.tables[1].rows.size(), found.comparisons.size());
  EXPECT_EQ(section.json["prereg"]["seal"], "none");
  EXPECT_EQ(section.json["prereg"]["tests"].size(), 2U);
}

TEST(SealedPlan, ComesOutToTheLetter) {
  for (const std::string& text :
       {std::string(plan), std::string("a = \"~~~~\"\n~~~~~\n"), std::string("without an end"),
        std::string("\n\n<pre>x</pre>\n")}) {
    EXPECT_EQ(plan_text_in("p.md", document_of(text)), text);
  }
}

TEST(SealedPlan, IsRefusedWhereItWasChangedOrIsMissing) {
  std::string changed = document_of(plan);
  changed.replace(changed.find("participants = 6"), 16, "participants = 5");
  for (const std::string& document : {changed, std::string("a letter"), std::string(),
                                      std::string("<!DOCTYPE html>"), std::string("\n~~~~\n")}) {
    EXPECT_THROW(plan_text_in("p.md", document), InputError) << document;
  }
}

}  // namespace
}  // namespace promenade::analysis
