#include "motion/set_file.h"

#include <gtest/gtest.h>

#include "motion/bytes.h"
#include "motion/problem.h"
#include "tests/motion/toy_set.h"

namespace promenade::motion {
namespace {

// The bytes of `set` with `change` applied to the content and the checksum made good:
// what is behind the checksum must be safe too.
std::string resealed(std::string bytes, std::size_t at, char value) {
  constexpr std::size_t head = 28;
  bytes[head + at] = value;
  ByteWriter seal;
  seal.u64(checksum(std::string_view(bytes).substr(head)));
  return bytes.replace(head - 8, 8, seal.take());
}

bool is_refused(std::string_view bytes) {
  try {
    from_bytes(bytes, "x.set");
    return false;
  } catch (const InputError& error) {
    return error.problems().front().file == "x.set";
  }
}

TEST(SetFile, ComesBackByteForByte) {
  const MotionSet set = toy_set(3);
  const std::string bytes = to_bytes(set);
  const MotionSet back = from_bytes(bytes, "x.set");
  EXPECT_EQ(to_bytes(back), bytes);
  EXPECT_EQ(back.cycles[2].name, set.cycles[2].name);
  EXPECT_EQ(back.cycles[1].rotations, set.cycles[1].rotations);
  EXPECT_EQ(back.skeleton.joints[5].parent, set.skeleton.joints[5].parent);
  EXPECT_EQ(back.body.joint, set.body.joint);
}

TEST(SetFile, IsLittleEndianWithItsMagicInFront) {
  const std::string bytes = to_bytes(toy_set(1));
  EXPECT_EQ(bytes.substr(0, 8), "PROMSET\n");
  EXPECT_EQ(bytes.substr(8, 4), std::string("\2\0\0\0", 4));
  EXPECT_EQ(bytes.substr(28, 8), std::string("\4\0\0\0toys", 8));
}

TEST(SetFile, IsRefusedWhenCutAtAnyLength) {
  const std::string bytes = to_bytes(toy_set(1, 2));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_TRUE(is_refused(std::string_view(bytes).substr(0, size))) << size;
  }
  EXPECT_TRUE(is_refused(bytes + "x"));
}

TEST(SetFile, IsRefusedWithAnyBitFlipped) {
  const std::string bytes = to_bytes(toy_set(1, 2));
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::string flipped = bytes;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
    EXPECT_TRUE(is_refused(flipped)) << bit;
  }
}

TEST(SetFile, WithAGoodChecksumOverBadContentIsReadOrRefusedAndNothingElse) {
  const std::string bytes = to_bytes(toy_set(1, 2));
  int refused = 0;
  for (std::size_t at = 0; at + 28 < bytes.size(); ++at) {
    for (const char value : {'\0', '\x7f', '\xff'}) {
      refused += is_refused(resealed(bytes, at, value)) ? 1 : 0;
    }
  }
  EXPECT_GT(refused, 100);
}

// What the first version wrote: no origins, no kind of motion.
std::string first_version(const MotionSet& set) {
  ByteWriter out;
  out.text(set.name);
  out.text(set.credit);
  out.count(set.skeleton.joints.size());
  for (const Joint& joint : set.skeleton.joints) {
    out.text(joint.name);
    out.u32(static_cast<std::uint32_t>(joint.parent + 1));
    out.numbers(joint.offset.data(), 3);
  }
  out.count(0);  // end sites
  for (std::size_t b = 0; b < body_joint_count; ++b) {
    out.u32(static_cast<std::uint32_t>(set.body.joint[b]));
    out.u32(set.body.borrowed[b] ? 1 : 0);
  }
  out.u32(static_cast<std::uint32_t>(set.phases));
  out.count(set.key_phases.size());
  out.numbers(set.key_phases.data(), set.key_phases.size());
  out.count(set.cycles.size());
  for (const Cycle& cycle : set.cycles) {
    for (const std::string* text : {&cycle.name, &cycle.style, &cycle.source}) out.text(*text);
    out.u32(static_cast<std::uint32_t>(cycle.first_frame));
    out.u32(static_cast<std::uint32_t>(cycle.frames));
    out.f64(cycle.seconds);
    out.numbers(cycle.keytimes.data(), cycle.keytimes.size());
    out.numbers(cycle.rotations.data(), static_cast<std::size_t>(cycle.rotations.size()));
    out.numbers(cycle.root.data(), static_cast<std::size_t>(cycle.root.size()));
    out.numbers(cycle.velocity.data(), 2);
    out.f64(cycle.loop_error_m);
  }
  const std::string content = out.take();
  ByteWriter head;
  head.u32(1);
  head.u64(content.size());
  head.u64(checksum(content));
  return "PROMSET\n" + head.take() + content;
}

TEST(SetFile, OfTheFirstVersionIsStillRead) {
  MotionSet set = toy_set(3);
  set.skeleton.end_sites.clear();
  const MotionSet back = from_bytes(first_version(set), "x.set");
  EXPECT_EQ(to_bytes(back), to_bytes(set));
}

TEST(SetFile, OfAnotherKindOrVersionSaysSo) {
  std::string bytes = to_bytes(toy_set(1));
  bytes[8] = 9;
  try {
    from_bytes(bytes, "x.set");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("version 9"), std::string::npos);
  }
  EXPECT_TRUE(is_refused("HIERARCHY\nROOT Hips"));
  EXPECT_TRUE(is_refused(""));
}

}  // namespace
}  // namespace promenade::motion
