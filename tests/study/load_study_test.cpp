#include "study/load_study.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "study/fairness.h"
#include "study/identity.h"
#include "toy.h"

namespace promenade::study {
namespace {

// The toy study with one piece of its text replaced.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = toy::study_text();
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string problems_of(const std::string& text) {
  try {
    toy::bundle(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(LoadStudy, ReadsAWholeStudy) {
  const StudyBundle bundle = toy::bundle();
  const Study& study = bundle.study;
  EXPECT_EQ(study.name, "toy");
  EXPECT_EQ(study.seed, 7U);
  ASSERT_EQ(study.interfaces.size(), 2U);
  EXPECT_EQ(study.interfaces[1].type, "mix");
  ASSERT_EQ(study.tasks.size(), 2U);
  EXPECT_EQ(study.tasks[0].limit_s, 45.0);
  EXPECT_EQ(study.tasks[0].dwell_us, 500'000);
  EXPECT_EQ(study.tasks[0].targets[0].weights, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(study.tasks[0].interfaces, (std::vector<int>{0, 1}));
  EXPECT_EQ(text_in(study.tasks[1].targets[0].quality, "en"), "jolly");
  EXPECT_EQ(study.instruments[0].items[0].most, 7);
  EXPECT_TRUE(bundle.warnings.empty());
}

TEST(LoadStudy, FillsInTheParametersOfInterfaces) {
  const Study study =
      toy::bundle(changed("name = \"mix\"", "name = \"mix\"\nrule = \"square\"")).study;
  EXPECT_EQ(std::get<std::string>(study.interfaces[1].parameters.at("rule")), "square");
  EXPECT_EQ(std::get<bool>(study.interfaces[1].parameters.at("quick")), false);
}

TEST(LoadStudy, TakesMixturesAsTargets) {
  const Study study = toy::bundle(changed("{ example = \"far\" }",
                                          "{ name = 'm', weights = { far = 0.75, side = 0.25 } }"))
                          .study;
  EXPECT_EQ(study.tasks[0].targets[0].weights, Eigen::Vector3d(0, 0.25, 0.75));
}

struct Broken {
  const char* from;
  const char* to;
  const char* problems;
};

void PrintTo(const Broken& broken, std::ostream* out) { *out << broken.to; }

class BrokenStudy : public testing::TestWithParam<Broken> {};

TEST_P(BrokenStudy, IsRefusedWithItsPlaceAndReason) {
  EXPECT_EQ(problems_of(changed(GetParam().from, GetParam().to)), GetParam().problems);
}

INSTANTIATE_TEST_SUITE_P(
    Keys, BrokenStudy,
    testing::Values(
        Broken{"limit_s = 45", "limt_s = 45",
               "toy.toml:11:1: error: unknown key \"limt_s\"; did you mean \"limit_s\"?"},
        Broken{"seed = 7", "seed = 7\nsecret = 1", "toy.toml:4:1: error: unknown key \"secret\""},
        Broken{"[[rating]]", "[[ratings]]",
               "toy.toml:19:3: error: unknown key \"ratings\"; did you mean \"rating\"?"},
        Broken{"example = \"far\"", "exmaple = \"far\"",
               "toy.toml:13:12: error: a target needs one of \"example\", \"weights\", "
               "\"random\", \"file\", \"all\", \"stimulus\"\n"
               "toy.toml:13:14: error: unknown key \"exmaple\"; did you mean \"example\"?"},
        Broken{"name = \"toy\"", "", "toy.toml:1:1: error: \"name\" is missing here"},
        Broken{"kind = \"find\"", "", "toy.toml:15:1: error: \"kind\" is missing here"},
        Broken{"seed = 7", "seed = = 7",
               "toy.toml:3:8: error: not valid TOML: Error while parsing value: "
               "could not determine value type"}));

INSTANTIATE_TEST_SUITE_P(
    Types, BrokenStudy,
    testing::Values(
        Broken{"limit_s = 45", "limit_s = \"45\"",
               "toy.toml:11:11: error: \"limit_s\" must be a number, but is a text"},
        Broken{"seed = 7", "seed = 7.5",
               "toy.toml:3:8: error: \"seed\" must be a whole number, but is a number"},
        Broken{"seed = 7", "seed = -7",
               "toy.toml:3:8: error: \"seed\" is -7, but must be from 0 to 9223372036854775807"},
        Broken{"limit_s = 45", "limit_s = 0",
               "toy.toml:11:11: error: \"limit_s\" is 0, but must be from 1 to 86400"},
        Broken{"seed = 7", "languages = \"en\"",
               "toy.toml:3:13: error: \"languages\" must be a list of texts, but is a text"},
        Broken{"[[rating]]", "[rating]",
               "toy.toml:19:1: error: \"rating\" must be a list of tables, but is a table"},
        Broken{"name = \"mix\"", "name = \"mix\"\nsteps = true",
               "toy.toml:8:9: error: \"steps\" must be a number, but is true or false"}));

INSTANTIATE_TEST_SUITE_P(
    Names, BrokenStudy,
    testing::Values(
        Broken{"kind = \"match\"", "kind = \"macth\"",
               "toy.toml:10:8: error: \"kind\" is \"macth\", but must be one of \"match\", "
               "\"find\", \"guess\", \"rate\"; did you mean \"match\"?"},
        Broken{"name = \"pick\"", "name = \"pcik\"",
               "toy.toml:5:8: error: there is no interface \"pcik\", only \"mix\", \"pick\"; did "
               "you mean \"pick\"?"},
        Broken{"name = \"mix\"", "name = \"mix\"\nrule = \"sqare\"",
               "toy.toml:8:8: error: \"rule\" is \"sqare\", but must be one of \"share\", "
               "\"square\"; did you mean \"square\"?"},
        Broken{"name = \"mix\"", "name = \"pick\"",
               "toy.toml:6:1: error: there is another interface with the name \"pick\" before"},
        Broken{"example = \"far\"", "example = \"fart\"",
               "toy.toml:13:24: error: the motion set \"toy\" has no walk \"fart\"; did you mean "
               "\"far\"?"},
        Broken{"{ example = \"far\" }", "{ name = 'm', weights = { far = 0.5, side = 0.6 } }",
               "toy.toml:13:36: error: the weights sum to 1.1, but must sum to 1"},
        Broken{"{ example = \"far\" }", "{ name = 'm', weights = { fra = 0.5, side = 0.6 } }",
               "toy.toml:13:36: error: the weights sum to 1.1, but must sum to 1\n"
               "toy.toml:13:44: error: the motion set \"toy\" has no walk \"fra\"; did you mean "
               "\"far\"?"},
        Broken{"seed = 7", "languages = [\"en\", \"fr\"]",
               "toy.toml:3:20: error: there are no texts in language \"fr\", only in \"en\", "
               "\"ja\""},
        Broken{"limit_s = 45", "interfaces = [\"picks\"]",
               "toy.toml:11:15: error: there is no [[interface]] with the name \"picks\"; did you "
               "mean \"pick\"?"}));

TEST(LoadStudy, NamesAllProblemsInOneRun) {
  std::string text = changed("limit_s = 45", "limit_s = true");
  text.replace(text.find("seed = 7"), 8, "sead = 7");
  text += "points = 1\n";
  EXPECT_EQ(problems_of(text),
            "toy.toml:3:1: error: unknown key \"sead\"; did you mean \"seed\"?\n"
            "toy.toml:11:11: error: \"limit_s\" must be a number, but is true or false\n"
            "toy.toml:22:10: error: \"points\" is 1, but must be from 2 to 11");
}

TEST(LoadStudy, SaysWhatIsWrongBesideALineThatIsNoToml) {
  std::string text = changed("seed = 7", "set = \"toy\"\nseed = 7seven");
  text.replace(text.find("\"far\""), 5, "\"fra\"");
  const std::string said = problems_of(text);
  EXPECT_EQ(said.rfind("toy.toml:4:", 0), 0U) << said;
  EXPECT_NE(said.find("no walk \"fra\"; did you mean \"far\"?"), said.npos) << said;
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
}

// The line may have been the one that is missing now.
TEST(LoadStudy, BlamesNothingOnALineThatIsNoToml) {
  for (const char* line : {"name = \"mix\"", "name = \"pick\"", "kind = \"match\"", "seed = 7",
                           "limit_s = 45", "name = \"toy\""}) {
    const std::string said = problems_of(changed(line, std::string(line) + "\""));
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 0) << line << '\n' << said;
    EXPECT_NE(said.find("not valid TOML"), said.npos) << said;
  }
}

TEST(LoadStudy, SaysWhatIsWrongWithTargetsOfAKindThatIsMisspelt) {
  std::string text = changed("kind = \"match\"", "kind = \"macth\"");
  text.replace(text.find("\"far\""), 5, "\"fra\"");
  EXPECT_NE(problems_of(text).find("no walk \"fra\""), std::string::npos);
}

TEST(LoadStudy, NamesThePlaceOfAMotionSetThatIsNotThere) {
  const std::string text = changed("seed = 7", "set = \"none.set\"\nlimit = 1");
  try {
    read_study("folder/a.toml", text, toy::registry(), load_motion_set);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what())
                  .rfind("folder/a.toml:3:7: error: cannot use the motion set \"none.set\": ", 0),
              0U)
        << error.what();
    EXPECT_NE(std::string(error.what()).find("4:1: error: unknown key \"limit\""),
              std::string::npos);
  }
}

TEST(LoadStudy, RefusesMissingFilesAndFolders) {
  EXPECT_THROW(load_study("no/such/study.toml", toy::registry()), InputError);
  EXPECT_THROW(load_study("/tmp", toy::registry()), InputError);
}

TEST(LoadStudy, SaysThatNothingIsInAnEmptyFile) {
  EXPECT_EQ(problems_of(""),
            "toy.toml:1:1: error: \"study\" is missing here\n"
            "toy.toml:1:1: error: a study needs at least one [[interface]]\n"
            "toy.toml:1:1: error: a study needs at least one [[task]]");
}

TEST(LoadStudy, RefusesATargetThatIsWonAtTheStart) {
  const double start = start_distance(toy::bundle().space, Eigen::Vector3d(0, 0, 1));
  const std::string said = problems_of(changed("\"auto\"", "0.5"));
  EXPECT_NE(said.find("toy.toml:13:12: error: target \"far\" is won before anything is touched: "
                      "at the start D is " +
                      fmt::format("{:.4f}", start) + " m, below the threshold of 0.5000 m"),
            std::string::npos)
      << said;
  EXPECT_NE(said.find("toy.toml:14:13: error: target \"side\" is won"), std::string::npos);
}

TEST(LoadStudy, ReadsWhenDComparesTheWalks) {
  using motion::DistanceTimes;
  EXPECT_EQ(toy::bundle().study.tasks[0].distance, DistanceTimes::time);
  const std::string text = changed("kind = \"match\"", "kind = \"match\"\ndistance = \"phase\"");
  const StudyBundle bundle = toy::bundle(text);
  EXPECT_EQ(bundle.study.tasks[0].distance, DistanceTimes::phase);
  EXPECT_DOUBLE_EQ(*bundle.study.tasks[0].threshold_m,
                   automatic_threshold(bundle.space, bundle.study.tasks[0]));
  EXPECT_NE(problems_of(changed("kind = \"match\"", "kind = \"match\"\ndistance = \"mean\"")), "");
}

TEST(LoadStudy, RefusesTheAverageAsATargetOfAnAutomaticThreshold) {
  const std::string average =
      "{ name = 'all', weights = { near = 0.3333333, side = 0.3333333, far = 0.3333334 } }";
  EXPECT_NE(problems_of(changed("{ example = \"far\" }", average)).find("\"all\" is won before"),
            std::string::npos);
}

TEST(LoadStudy, RefusesNamesThatAreNoNamesOfFiles) {
  for (const char* kept : {"\"toy\"", "\"mix\"", "\"copy\"", "\"jolly\""}) {
    for (const std::string& name : {std::string("../x"), std::string(".x"), std::string("x\\ny"),
                                    std::string("x\\u0085"), std::string(81, 'x')}) {
      const std::string said = problems_of(changed(kept, "\"" + name + "\""));
      EXPECT_NE(said.find("error: \"name\" must have up to 80"), std::string::npos) << kept << name;
    }
  }
  const std::string target = "{ name = \"a/b\", example = \"far\" }";
  EXPECT_NE(problems_of(changed("{ example = \"far\" }", target)).find("toy.toml:13:"),
            std::string::npos);
}

TEST(LoadStudy, TakesANameOfEightyCharactersOfAnyScript) {
  std::string name;
  for (int i = 0; i < 80; ++i) name += "\u6b69";
  EXPECT_EQ(toy::bundle(changed("\"toy\"", "\"" + name + "\"")).study.name, name);
}

TEST(LoadStudy, SaysOnceThatPracticeIsNoList) {
  const std::string said =
      problems_of(changed("practice = [{ example = \"side\" }]", "practice = 3"));
  const std::size_t first = said.find("\"practice\" must be");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(said.find("\"practice\" must be", first + 1), std::string::npos) << said;
}

TEST(LoadStudy, WarnsOfAQualityThatIsALabel) {
  const StudyBundle bundle = toy::bundle(changed("\"jolly\"", "\"far\""));
  ASSERT_EQ(bundle.warnings.size(), 1U);
  EXPECT_EQ(to_text(bundle.warnings[0]),
            "toy.toml:18:14: warning: the asked quality \"far\" is also the name of the walk "
            "\"far\"; an interface that shows names gives the answer away");
}

TEST(LoadStudy, TakesNoWordInsideAnotherForALabel) {
  EXPECT_TRUE(toy::bundle(changed("\"jolly\"", "\"nefarious\"")).warnings.empty());
}

TEST(LoadStudy, WarnsOfOwnTextsThatAreNotTranslated) {
  const StudyBundle bundle = toy::bundle(changed("seed = 7", "languages = [\"en\", \"ja\"]"));
  ASSERT_EQ(bundle.warnings.size(), 2U);
  EXPECT_EQ(to_text(bundle.warnings[0]),
            "toy.toml:18:14: warning: \"jolly\" has no text in \"ja\"; \"jolly\" is shown");
  EXPECT_EQ(bundle.warnings[1].line, 21);
}

TEST(LoadStudy, HashesEverythingThatIsShown) {
  const StudyBundle one = toy::bundle();
  EXPECT_EQ(one.sha256, toy::bundle().sha256);
  EXPECT_NE(one.sha256, toy::bundle(toy::study_text() + "# a remark\n").sha256);
  const StudyBundle other = read_study("toy.toml", toy::study_text(), toy::registry(),
                                       [](const std::string&, const std::string&) {
                                         motion::MotionSet set = toy::motion_set();
                                         set.cycles[0].rotations(0, 0) += 1e-9;
                                         return set;
                                       });
  EXPECT_NE(one.sha256, other.sha256);
}

TEST(LoadStudy, SurvivesEveryTruncationOfAStudy) {
  const std::string whole = toy::study_text();
  for (std::size_t n = 0; n < whole.size(); n += 3) problems_of(whole.substr(0, n));
}

TEST(Sha256, AgreesWithThePublishedExample) {  // FIPS 180-2, B.1
  EXPECT_EQ(sha256_hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(LoadStudy, ReadsBreaks) {
  const Study study =
      toy::bundle(toy::study_text() + "[breaks]\nafter = 'block'\nleast_s = 2.5\n").study;
  EXPECT_TRUE(study.breaks.after_block);
  EXPECT_EQ(study.breaks.least_us, 2'500'000);
  EXPECT_FALSE(toy::bundle().study.breaks.after_block);
}

TEST(LoadStudy, RefusesBreaksOfMoreThanAnHour) {
  EXPECT_THROW(toy::bundle(toy::study_text() + "[breaks]\nleast_s = 3601\n"), InputError);
}

}  // namespace
}  // namespace promenade::study
