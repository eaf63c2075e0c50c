// What files of motions have in common: skeletons, bodies and numbers that must make sense,
// as bytes. Readers fail with an InputError at whatever cannot be.
#pragma once

#include "motion/body.h"
#include "motion/bytes.h"

namespace promenade::motion {

void write(ByteWriter& out, const Skeleton& skeleton);
void write(ByteWriter& out, const BodyMap& body);

Skeleton read_skeleton(ByteReader& in);
BodyMap read_body(ByteReader& in, std::size_t joints);

// An index from 0 below `size`; `what` names it in the message.
int read_index(ByteReader& in, std::size_t size, const char* what);
int read_frame_number(ByteReader& in);  // from 0
double read_finite(ByteReader& in);
void read_finite(ByteReader& in, double* values, std::size_t size);

// Fails unless every column (x y z w) has length 1.
void check_rotations(const ByteReader& in, const Eigen::Ref<const Eigen::Matrix4Xd>& rotations);

// A file as its magic text, version, size and checksum, then its content.
std::string sealed(std::string_view magic, std::uint32_t version, const std::string& content);

struct SealedContent {
  std::uint32_t version = 0;
  std::string_view bytes;
};

struct SealedKind {
  std::string_view magic;
  std::uint32_t oldest = 1, newest = 1;  // versions that can be read
  std::string what;                      // "a motion set"
  std::string made_by;                   // "promenade set build"
};

// Throws InputError with `file` as its place unless the bytes are whole.
SealedContent checked_content(const SealedKind& kind, std::string_view bytes,
                              const std::string& file);

}  // namespace promenade::motion
