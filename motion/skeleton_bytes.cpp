#include "motion/skeleton_bytes.h"

#include <algorithm>
#include <cmath>

#include "motion/problem.h"

namespace promenade::motion {

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

void read_finite(ByteReader& in, double* values, std::size_t size) {
  in.numbers(values, size);
  const auto finite = [](double value) { return std::isfinite(value); };
  if (!std::all_of(values, values + size, finite)) in.fail("holds a number that is not finite");
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
    read_finite(in, joint.offset.data(), 3);
  }
  skeleton.end_sites.resize(in.count(28));
  for (EndSite& site : skeleton.end_sites) {
    site.joint = read_index(in, skeleton.joints.size(), "joint");
    read_finite(in, site.offset.data(), 3);
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

void check_rotations(const ByteReader& in, const Eigen::Ref<const Eigen::Matrix4Xd>& rotations) {
  const double worst = (rotations.colwise().squaredNorm().array() - 1).abs().maxCoeff();
  if (!(worst < 1e-6)) in.fail("holds a rotation that is not a unit quaternion");
}

std::string sealed(std::string_view magic, std::uint32_t version, const std::string& content) {
  ByteWriter head;
  head.u32(version);
  head.u64(content.size());
  head.u64(checksum(content));
  return std::string(magic) + head.take() + content;
}

SealedContent checked_content(const SealedKind& kind, std::string_view bytes,
                              const std::string& file) {
  if (bytes.substr(0, kind.magic.size()) != kind.magic) {
    throw InputError(file, "is not " + kind.what + "; make one with `" + kind.made_by + "`");
  }
  ByteReader head(bytes.substr(kind.magic.size()), file);
  const std::uint32_t found = head.u32();
  if (found < kind.oldest || found > kind.newest) {
    std::string readable = std::to_string(kind.newest);
    if (kind.oldest < kind.newest) readable.insert(0, std::to_string(kind.oldest) + " to ");
    head.fail("is " + kind.what + " of version " + std::to_string(found) + ", this program reads " +
              readable + "; build it again");
  }
  const std::uint64_t size = head.u64();
  const std::uint64_t sum = head.u64();
  const std::string_view content = bytes.substr(kind.magic.size() + 20);
  if (content.size() != size) head.fail("is cut or has more at its end; copy or build it again");
  if (checksum(content) != sum) head.fail("is damaged; copy or build it again");
  return {found, content};
}

}  // namespace promenade::motion
