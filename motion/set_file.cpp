#include "motion/set_file.h"

#include <cmath>
#include <set>

#include "motion/bytes.h"
#include "motion/problem.h"

namespace promenade::motion {
namespace {

constexpr std::string_view magic = "PROMSET\n";
constexpr std::uint32_t version = 2;
constexpr std::uint32_t oldest_version = 1;  // had no origins, and walks only

void write(ByteWriter& out, const Skeleton& skeleton) {
  out.count(skeleton.joints.size());
  for (const Joint& joint : skeleton.joints) {
    out.text(joint.name);
    out.u32(static_cast<std::uint32_t>(joint.parent + 1));
    out.numbers(joint.offset.data(), 3);
  }
  out.count(skeleton.end_sites.size());
  for (const EndSite& site : skeleton.end_sites) {
    out.u32(static_cast<std::uint32_t>(site.joint));
    out.numbers(site.offset.data(), 3);
  }
}

void write(ByteWriter& out, const BodyMap& body) {
  for (std::size_t b = 0; b < body_joint_count; ++b) {
    out.u32(static_cast<std::uint32_t>(body.joint[b]));
    out.u32(body.borrowed[b] ? 1 : 0);
  }
}

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

// An index from 0 below `size`.
int read_index(ByteReader& in, std::size_t size, const char* what) {
  const std::uint32_t value = in.u32();
  if (value >= size) in.fail(std::string("names a ") + what + " that is not in it");
  return static_cast<int>(value);
}

int read_frame_number(ByteReader& in) {
  const std::uint32_t value = in.u32();
  if (value > INT32_MAX) in.fail("has a frame number out of range");
  return static_cast<int>(value);
}

double read_finite(ByteReader& in) {
  const double value = in.f64();
  if (!std::isfinite(value)) in.fail("holds a number that is not finite");
  return value;
}

template <typename Matrix>
void read_finite(ByteReader& in, Matrix& values) {
  in.numbers(values.data(), static_cast<std::size_t>(values.size()));
  if (!values.allFinite()) in.fail("holds a number that is not finite");
}

Skeleton read_skeleton(ByteReader& in) {
  Skeleton skeleton;
  skeleton.joints.resize(in.count(32));
  if (skeleton.joints.empty()) in.fail("has no joints");
  for (std::size_t j = 0; j < skeleton.joints.size(); ++j) {
    Joint& joint = skeleton.joints[j];
    joint.name = in.text();
    joint.parent = read_index(in, j + 1, "parent") - 1;
    if ((joint.parent < 0) != (j == 0)) in.fail("does not have joint 0 as its only root");
    read_finite(in, joint.offset);
  }
  skeleton.end_sites.resize(in.count(28));
  for (EndSite& site : skeleton.end_sites) {
    site.joint = read_index(in, skeleton.joints.size(), "joint");
    read_finite(in, site.offset);
  }
  return skeleton;
}

BodyMap read_body(ByteReader& in, std::size_t joints) {
  BodyMap body;
  for (std::size_t b = 0; b < body_joint_count; ++b) {
    body.joint[b] = read_index(in, joints, "joint");
    body.borrowed[b] = read_index(in, 2, "choice") == 1;
  }
  return body;
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

void check_rotations(const ByteReader& in, const Eigen::Matrix4Xd& rotations) {
  const double worst = (rotations.colwise().squaredNorm().array() - 1).abs().maxCoeff();
  if (!(worst < 1e-6)) in.fail("holds a rotation that is not a unit quaternion");
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
  read_finite(in, cycle.rotations);
  check_rotations(in, cycle.rotations);
  cycle.root.resize(3, set.phases);
  read_finite(in, cycle.root);
  read_finite(in, cycle.velocity);
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

struct Content {
  std::uint32_t version = 0;
  std::string_view bytes;
};

Content checked_content(std::string_view bytes, const std::string& file) {
  if (bytes.substr(0, magic.size()) != magic) {
    throw InputError(file, "is not a motion set; make one with `promenade set build`");
  }
  ByteReader head(bytes.substr(magic.size()), file);
  const std::uint32_t found = head.u32();
  if (found < oldest_version || found > version) {
    head.fail("is a motion set of version " + std::to_string(found) + ", this program reads " +
              std::to_string(oldest_version) + " to " + std::to_string(version) +
              "; build it again");
  }
  const std::uint64_t size = head.u64();
  const std::uint64_t sum = head.u64();
  const std::string_view content = bytes.substr(magic.size() + 20);
  if (content.size() != size) head.fail("is cut or has more at its end; copy or build it again");
  if (checksum(content) != sum) head.fail("is damaged; copy or build it again");
  return {found, content};
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
  const std::string content = out.take();

  ByteWriter head;
  head.u32(version);
  head.u64(content.size());
  head.u64(checksum(content));
  return std::string(magic) + head.take() + content;
}

MotionSet from_bytes(std::string_view bytes, const std::string& file) {
  const Content content = checked_content(bytes, file);
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
