// FILE.study: everything that a study shows, frozen into one file: its text, its motions and
// its parts (study.h). The same study gives the same bytes. Little-endian:
//
//   "PROMPACK"  u32 version  u64 size of the content  SHA-256 of the content, 64 digits
//   content: program version, hash of the study, its text, its motion set (motion/set_file.h),
//            the number of parts, and path and content of each, by path
#pragma once

#include <string>
#include <string_view>

#include "study/load_study.h"

namespace promenade::study {

struct Pack {
  std::string program_version;  // that packed it
  std::string study_sha256;
  FrozenStudy study;
};

Pack pack_of(const StudyBundle& bundle);
std::string to_bytes(const Pack& pack);

// By the first bytes, whatever the file is called.
bool is_packed(std::string_view bytes);

// Throws InputError with `file` as its place when the bytes are not a whole pack.
Pack read_pack(std::string_view bytes, const std::string& file);

// The study in it, ready to run. Throws InputError also when this program declares its
// interfaces or draws its targets otherwise, so that its hash would be another one.
StudyBundle unpack_study(std::string_view bytes, const std::string& file,
                         const InterfaceRegistry& registry);

}  // namespace promenade::study
