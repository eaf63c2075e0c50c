#include "study/pack.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "motion/bytes.h"
#include "motion/files.h"
#include "study/adjective_model.h"
#include "study/embedded.h"
#include "study/identity.h"
#include "study/ratings_csv.h"
#include "study/simulated_raters.h"
#include "toy.h"

namespace promenade::study {
namespace {

constexpr std::size_t head_size = 84;

std::string toy_pack() {
  static const std::string bytes = to_bytes(pack_of(toy::bundle()));
  return bytes;
}

// What it says of the bytes; empty: it takes them.
std::string refusal(std::string_view bytes) {
  try {
    unpack_study(bytes, "x.study", toy::registry());
    return "";
  } catch (const InputError& error) {
    return error.problems().front().file == "x.study" ? error.problems().front().message
                                                      : "at a wrong place";
  }
}

// The content with the head made good: what is behind the checksum must be safe too.
std::string sealed(const std::string& content, std::uint32_t version = 1) {
  ByteWriter head;
  head.u32(version);
  head.u64(content.size());
  return "PROMPACK" + head.take() + sha256_hex(content) + content;
}

std::string content_of(const std::string& pack) { return pack.substr(head_size); }

// A pack that holds this set and these parts.
std::string pack_with(const std::string& set, const std::vector<StudyPart>& parts) {
  Pack pack = pack_of(toy::bundle());
  pack.study.set_bytes = set;
  pack.study.parts = parts;
  return to_bytes(pack);
}

TEST(Pack, GivesTheSameStudyWithTheSameHash) {
  const StudyBundle study = toy::bundle();
  const StudyBundle unpacked = unpack_study(toy_pack(), "x.study", toy::registry());
  EXPECT_EQ(unpacked.sha256, study.sha256);
  EXPECT_EQ(unpacked.config_text, study.config_text);
  EXPECT_EQ(unpacked.set_bytes, study.set_bytes);
  EXPECT_EQ(unpacked.space.set.cycles[2].rotations, study.space.set.cycles[2].rotations);
  EXPECT_EQ(unpacked.study.tasks[0].threshold_m, study.study.tasks[0].threshold_m);
  ASSERT_EQ(unpacked.parts.size(), 1U);
  EXPECT_EQ(unpacked.parts[0].path, "builtin:languages/en.toml");
}

TEST(Pack, GivesTheSameBytesEachTimeAndWhenPackedAgain) {
  EXPECT_EQ(to_bytes(pack_of(toy::bundle())), toy_pack());
  const StudyBundle unpacked = unpack_study(toy_pack(), "x.study", toy::registry());
  EXPECT_EQ(to_bytes(pack_of(unpacked)), toy_pack());
}

TEST(Pack, IsKnownByItsFirstBytesWhateverItIsCalled) {
  const auto file = std::filesystem::temp_directory_path() /
                    ("promenade_pack_" + std::to_string(::getpid()) + ".toml");
  write_file(file, toy_pack());
  const StudyBundle study = load_study(file.string(), toy::registry());
  std::filesystem::remove(file);
  EXPECT_EQ(study.sha256, toy::bundle().sha256);
  EXPECT_EQ(study.file, file.string());
}

TEST(Pack, IsRefusedWhenCutAtAnyLength) {
  const std::string bytes = toy_pack();
  for (std::size_t size = 0; size < bytes.size(); size += size < 2 * head_size ? 1 : 997) {
    EXPECT_NE(refusal(std::string_view(bytes).substr(0, size)), "") << size;
  }
  EXPECT_NE(refusal(bytes + "x"), "");
}

TEST(Pack, IsRefusedWithAnyBitFlipped) {
  const std::string bytes = toy_pack();
  for (std::size_t at = 0; at < bytes.size(); at += at < 2 * head_size ? 1 : 499) {
    std::string flipped = bytes;
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << (at % 8)));
    EXPECT_NE(refusal(flipped), "") << at;
  }
}

TEST(Pack, WithAGoodChecksumIsReadOrRefusedWhereverItIsCut) {
  const std::string content = content_of(toy_pack());
  for (std::size_t size = 0; size < content.size(); size += size < 300 ? 1 : 1999) {
    EXPECT_NE(refusal(sealed(content.substr(0, size))), "") << size;
  }
}

struct BrokenPack {
  const char* what;
  std::string bytes;
  const char* message;
};

std::vector<BrokenPack> broken_packs() {
  const std::string good = toy_pack();
  const std::string set = toy::bundle().set_bytes;
  const std::string huge(4, '\xff');
  const StudyPart part{"a.csv", "x"};
  return {
      {"nothing", "", "\"study\""},
      {"another magic", "PROMSET\n" + good.substr(8), ""},
      {"a newer version", sealed(content_of(good), 2), "newer Promenade"},
      {"version 0", sealed(content_of(good), 0), "damaged"},
      {"no content", sealed(""), "ends too early"},
      {"a huge text", sealed(huge + "abc"), "ends too early"},
      {"a huge number of parts", sealed(std::string(16, '\0') + huge), "ends too early"},
      {"more at its end", sealed(content_of(good) + "x"), "more at its end"},
      {"no set", pack_with("", {}), "is not a motion set"},
      {"a cut set", pack_with(set.substr(0, 100), {}), "is cut"},
      {"one part twice", pack_with(set, {part, part}), "twice"},
      {"parts out of order", pack_with(set, {{"b.csv", ""}, part}), "out of order"},
      {"other parts than were packed", pack_with(set, {part}), "otherwise than this one"},
  };
}

TEST(Pack, ThatIsBrokenSaysHow) {
  for (const BrokenPack& broken : broken_packs()) {
    if (!is_packed(broken.bytes)) {
      EXPECT_THROW(read_pack(broken.bytes, "x.study"), InputError) << broken.what;
      continue;
    }
    EXPECT_NE(refusal(broken.bytes).find(broken.message), std::string::npos)
        << broken.what << ": " << refusal(broken.bytes);
  }
}

TEST(Pack, WithoutAFileThatItsStudyNamesSaysWhich) {
  Pack pack = pack_of(toy::bundle());
  pack.study.config_text.insert(pack.study.config_text.find("seed"), "ratings = \"mine.csv\"\n");
  EXPECT_NE(refusal(to_bytes(pack)).find("mine.csv"), std::string::npos) << refusal(to_bytes(pack));
}

TEST(Pack, OfAProgramWithOtherInterfacesSaysWhatToDo) {
  InterfaceRegistry other;
  for (InterfaceType type : toy::registry().all()) {
    type.sentence += " now";
    other.add(std::move(type));
  }
  try {
    unpack_study(toy_pack(), "x.study", other);
    FAIL();
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find(program_version()), std::string::npos) << message;
    EXPECT_NE(message.find("pack the study file again"), std::string::npos) << message;
  }
}

// A pack of a program that had other texts, and not all of today's.
StudyBundle study_with_texts(const std::string& texts) {
  Pack pack = pack_of(toy::bundle());
  pack.study.parts = {{"builtin:languages/en.toml", texts}};
  return read_frozen_study("x.study", pack.study, toy::registry());
}

TEST(FrozenStudy, ShowsTheTextsThatWereFrozenWithIt) {
  const StudyBundle study = study_with_texts("[trial]\nnumber = \"No. {number} (then)\"\n");
  EXPECT_EQ(texts_of(study, "en")("trial.number"), "No. {number} (then)");
  EXPECT_NE(study.sha256, toy::bundle().sha256);
}

TEST(FrozenStudy, ShowsTheTextsOfTheProgramWhereItHasNone) {
  const StudyBundle study = study_with_texts("[trial]\nnumber = \"x\"\n");
  EXPECT_EQ(texts_of(study, "en")("welcome.language"), load_texts("en")("welcome.language"));
  EXPECT_EQ(texts_of(study, "ja")("language"), load_texts("ja")("language"));
  EXPECT_THROW(texts_of(study, "xx"), InputError);
}

TEST(FrozenStudy, WithTextsThatAreNoTomlIsRefused) {
  EXPECT_THROW(study_with_texts("[trial"), InputError);
}

TEST(StudyParts, HoldTheTextsOfEveryLanguageOfTheStudy) {
  std::string text = toy::study_text();
  text.insert(text.find("seed"), "languages = [\"ja\", \"en\"]\n");
  const StudyBundle study = toy::bundle(text);
  ASSERT_EQ(study.parts.size(), 2U);
  EXPECT_EQ(study.parts[0].content, embedded_file("languages/en.toml"));
  EXPECT_EQ(study.parts[1].path, "builtin:languages/ja.toml");
}

TEST(StudyParts, OfSimulatedRatersAreTheirVeryRatings) {
  for (const char* set : {"A", "B", "N"}) {
    const RatingsTable table = *simulated_ratings(set);
    const std::string text = load_file(builtin_path(simulated_ratings_path(set)), "");
    EXPECT_EQ(text, ratings_csv(table));
    const RatingsTable back = read_ratings_csv("x.csv", text, table.motions);
    EXPECT_EQ(ratings_csv(back), text);
    EXPECT_EQ(back.pairs, table.pairs);
    EXPECT_TRUE(back.simulated);
  }
}

}  // namespace
}  // namespace promenade::study
