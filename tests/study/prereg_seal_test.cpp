#include "study/prereg_seal.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "motion/problem.h"
#include "study/identity.h"
#include "study/load_study.h"
#include "study/schema.h"
#include "study/sqlite.h"
#include "study/store_open.h"
#include "tests/test_folder.h"
#include "toy.h"

namespace promenade::study {
namespace {

constexpr const char* text = "[study]\nname = \"a\"\nprereg = \"p.md\"  # sealed\nseed = 1\n";
constexpr const char* unsealed = "[study]\nname = \"a\"\nseed = 1\n";

TEST(PreregSeal, IsALineOfTheStudy) {
  EXPECT_EQ(prereg_file_in(text), "p.md");
  EXPECT_EQ(without_seal(text), unsealed);
}

TEST(PreregSeal, MayBeTheLastLineWithoutAnEnd) {
  EXPECT_EQ(without_seal("[study]\nname = \"a\"\nprereg = \"p.md\""), "[study]\nname = \"a\"\n");
}

TEST(PreregSeal, IsNotThereWhereNothingIsNamed) {
  for (const std::string other : {unsealed, "", "[study", "[task]\nprereg = \"x\"\n",
                                  "# prereg = \"x\"\n[study]\nprereg = 3\n"}) {
    EXPECT_EQ(prereg_file_in(other), "") << other;
    EXPECT_EQ(without_seal(other), other);
  }
}

class SealedStudy : public testing::Test {
 protected:
  void write(const std::string& document) { std::ofstream(folder_.file("p.md")) << document; }
  StudyBundle load() const {
    std::string sealed = toy::study_text();
    const std::string line = "[study]\n";
    sealed.insert(sealed.find(line) + line.size(), "prereg = \"p.md\"\n");
    return read_study(folder_.file("study.toml"), sealed, toy::registry(),
                      [](const std::string&, const std::string&) { return toy::motion_set(); });
  }
  TestFolder folder_;
};

TEST_F(SealedStudy, HasTheDocumentAmongItsParts) {
  write("the plan for " + sha256_hex(toy::study_text()));
  const StudyBundle one = load();
  EXPECT_TRUE(one.warnings.empty());
  write("another for " + sha256_hex(toy::study_text()));
  EXPECT_NE(load().sha256, one.sha256);
}

TEST_F(SealedStudy, WarnsOfADocumentForAnotherOne) {
  write("the plan for something else");
  const StudyBundle bundle = load();
  ASSERT_EQ(bundle.warnings.size(), 1U);
  EXPECT_NE(to_text(bundle.warnings[0]).find("was not written for this study as it stands now"),
            std::string::npos);
}

TEST_F(SealedStudy, CannotBeReadWithoutTheDocument) {
  try {
    load();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("cannot read the preregistration \"p.md\""),
              std::string::npos);
  }
}

TEST_F(SealedStudy, PutsItsHashIntoTheDatabase) {
  write("the plan");
  const StudyBundle bundle = load();
  Database database(":memory:", Database::Mode::create);
  create_tables(database);
  const auto seal = seal_in(database, put_study(database, bundle), bundle.config_text);
  ASSERT_TRUE(seal);
  EXPECT_EQ(seal->sha256, sha256_hex("the plan"));
}

}  // namespace
}  // namespace promenade::study
