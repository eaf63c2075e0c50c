#include "motion/set_file.h"

#include <cmath>
#include <set>

#include "motion/problem.h"
#include "motion/skeleton_bytes.h"

namespace promenade::motion {
namespace {

// Version 1 had no origins, and walks only.
const SealedKind kind{"PROMSET\n", 1, 2, "a motion set", "promenade set build"};

void write(ByteWriter& out, const CycleOrigin& origin) {
  out.text(origin.sha256);
  out.f64(origin.frame_time);
  out.u32(static_cast<std::uint32_t>(origin.cycles_found));
  for (const double value : {origin.turn, origin.straightness, origin.scale, origin.moved_m}) {
    out.f64(value);
  }
}

void write(ByteWriter& out, const Cycle& cycle) {
  out.text(cycle.name);
  out.text(cycle.style);
  out.text(cycle.source);
  out.u32(static_cast<std::uint32_t>(cycle.first_frame));
  out.u32(static_cast<std::uint32_t>(cycle.frames));
  out.f64(cycle.seconds);
  out.numbers(cycle.keytimes.data(), cycle.keytimes.size());
  out.numbers(cycle.rotations.data(), static_cast<std::size_t>(cycle.rotations.size()));
  out.numbers(cycle.root.data(), static_cast<std::size_t>(cycle.root.size()));
  out.numbers(cycle.velocity.data(), 2);
  out.f64(cycle.loop_error_m);
  write(out, cycle.origin);
}

// Ascending from 0.
std::vector<double> read_times(ByteReader& in, std::size_t size) {
  std::vector<double> times(size);
  in.numbers(times.data(), size);
  bool ascend = times.front() == 0 && std::isfinite(times.back());
  for (std::size_t k = 1; k < size; ++k) ascend = ascend && times[k] > times[k - 1];
  if (!ascend) in.fail("has keytimes that do not ascend from 0");
  return times;
}

CycleOrigin read_origin(ByteReader& in) {
  CycleOrigin origin;
  origin.sha256 = in.text();
  origin.frame_time = read_finite(in);
  origin.cycles_found = read_frame_number(in);
  for (double* value : {&origin.turn, &origin.straightness, &origin.scale, &origin.moved_m}) {
    *value = read_finite(in);
  }
  return origin;
}

Cycle read_cycle(ByteReader& in, const MotionSet& set, std::uint32_t found) {
  Cycle cycle;
  cycle.name = in.text();
  cycle.style = in.text();
  cycle.source = in.text();
  cycle.first_frame = read_frame_number(in);
  cycle.frames = read_frame_number(in);
  cycle.seconds = read_finite(in);
  cycle.keytimes = read_times(in, set.key_phases.size());
  if (cycle.keytimes.back() != cycle.seconds) in.fail("has a cycle that outlasts its keytimes");
  cycle.rotations.resize(4, Eigen::Index{set.phases} * set.skeleton.size());
  read_finite(in, cycle.rotations.data(), static_cast<std::size_t>(cycle.rotations.size()));
  check_rotations(in, cycle.rotations);
  cycle.root.resize(3, set.phases);
  read_finite(in, cycle.root.data(), static_cast<std::size_t>(cycle.root.size()));
  read_finite(in, cycle.velocity.data(), 2);
  cycle.loop_error_m = read_finite(in);
  if (found > 1) cycle.origin = read_origin(in);
  return cycle;
}

void read_cycles(ByteReader& in, MotionSet& set, std::uint32_t found) {
  const std::size_t joints = set.skeleton.joints.size();
  // Bounds F J by the bytes that are there before anything of that size is made.
  const std::size_t cycles = in.count(32 * joints * static_cast<std::size_t>(set.phases));
  if (cycles == 0) in.fail("has no cycles");
  std::set<std::string> names;
  for (std::size_t i = 0; i < cycles; ++i) {
    set.cycles.push_back(read_cycle(in, set, found));
    if (!names.insert(set.cycles.back().name).second) {
      in.fail("has two cycles named " + set.cycles.back().name);
    }
  }
}

}  // namespace

std::string to_bytes(const MotionSet& set) {
  ByteWriter out;
  out.text(set.name);
  out.text(set.credit);
  write(out, set.skeleton);
  write(out, set.body);
  out.u32(static_cast<std::uint32_t>(set.phases));
  out.count(set.key_phases.size());
  out.numbers(set.key_phases.data(), set.key_phases.size());
  out.u32(set.walk ? 1 : 0);
  out.count(set.cycles.size());
  for (const Cycle& cycle : set.cycles) write(out, cycle);
  return sealed(kind.magic, kind.newest, out.take());
}

MotionSet from_bytes(std::string_view bytes, const std::string& file) {
  const SealedContent content = checked_content(kind, bytes, file);
  ByteReader in(content.bytes, file);
  MotionSet set;
  set.name = in.text();
  set.credit = in.text();
  set.skeleton = read_skeleton(in);
  set.body = read_body(in, set.skeleton.joints.size());
  const std::uint32_t phases = in.u32();
  if (phases < 2 || phases > 100'000) in.fail("has a number of phases out of range");
  set.phases = static_cast<int>(phases);
  const std::size_t keys = in.count(8);
  if (keys < 2) in.fail("has fewer than two key phases");
  set.key_phases = read_times(in, keys);
  if (set.key_phases.back() != 1) in.fail("has key phases that do not end at 1");
  if (content.version > 1) set.walk = read_index(in, 2, "choice") == 1;
  if (set.key_phases.size() != 5) set.walk = false;
  read_cycles(in, set, content.version);
  if (!in.at_end()) in.fail("has more at its end than a motion set; build it again");
  return set;
}

}  // namespace promenade::motion
