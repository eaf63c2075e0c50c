#include "study/pack.h"

#include "motion/bytes.h"
#include "study/identity.h"

namespace promenade::study {
namespace {

constexpr std::string_view magic = "PROMPACK";
constexpr std::uint32_t pack_version = 1;
constexpr std::size_t hash_digits = 64;
constexpr std::size_t head_size = magic.size() + 4 + 8 + hash_digits;

// The bytes behind the head, after all that the head says of them was found true.
std::string_view checked_content(std::string_view bytes, const std::string& file) {
  if (!is_packed(bytes)) {
    throw InputError(file, "is no packed study; make one with `promenade pack`");
  }
  ByteReader head(bytes.substr(magic.size()), file);
  const std::uint32_t found = head.u32();
  if (found > pack_version) {
    head.fail("was packed by a newer Promenade (version " + std::to_string(found) +
              " of packed studies, this program reads " + std::to_string(pack_version) +
              "); use that one");
  }
  if (found == 0) head.fail("is damaged; copy or pack it again");
  const std::uint64_t size = head.u64();
  if (bytes.size() < head_size || bytes.size() - head_size != size) {
    head.fail("is cut or has more at its end; copy or pack it again");
  }
  const std::string_view content = bytes.substr(head_size);
  if (sha256_hex(content) != bytes.substr(head_size - hash_digits, hash_digits)) {
    head.fail("is damaged; copy or pack it again");
  }
  return content;
}

StudyPart read_part(ByteReader& in) {
  StudyPart part;
  part.path = in.text();
  part.content = in.text();
  return part;
}

void read_parts(ByteReader& in, std::vector<StudyPart>& parts) {
  constexpr std::size_t least_bytes = 8;  // two counts
  for (std::size_t left = in.count(least_bytes); left > 0; --left) {
    StudyPart part = read_part(in);
    if (!parts.empty() && part.path <= parts.back().path) {
      in.fail("names its parts twice or out of order; pack it again");
    }
    parts.push_back(std::move(part));
  }
}

}  // namespace

Pack pack_of(const StudyBundle& bundle) {
  return {std::string(program_version()),
          bundle.sha256,
          {bundle.config_text, bundle.set_bytes, bundle.parts}};
}

std::string to_bytes(const Pack& pack) {
  ByteWriter out;
  out.text(pack.program_version);
  out.text(pack.study_sha256);
  out.text(pack.study.config_text);
  out.text(pack.study.set_bytes);
  out.count(pack.study.parts.size());
  for (const StudyPart& part : pack.study.parts) {
    out.text(part.path);
    out.text(part.content);
  }
  const std::string content = out.take();
  ByteWriter head;
  head.u32(pack_version);
  head.u64(content.size());
  return std::string(magic) + head.take() + sha256_hex(content) + content;
}

bool is_packed(std::string_view bytes) { return bytes.substr(0, magic.size()) == magic; }

Pack read_pack(std::string_view bytes, const std::string& file) {
  ByteReader in(checked_content(bytes, file), file);
  Pack pack;
  pack.program_version = in.text();
  pack.study_sha256 = in.text();
  pack.study.config_text = in.text();
  pack.study.set_bytes = in.text();
  read_parts(in, pack.study.parts);
  if (!in.at_end()) in.fail("has more at its end than a packed study; pack it again");
  return pack;
}

StudyBundle unpack_study(std::string_view bytes, const std::string& file,
                         const InterfaceRegistry& registry) {
  const Pack pack = read_pack(bytes, file);
  StudyBundle bundle = read_frozen_study(file, pack.study, registry);
  if (bundle.sha256 == pack.study_sha256) return bundle;
  throw InputError(
      file, "was packed by Promenade " + pack.program_version +
                ", which declares its interfaces or draws its targets otherwise than this one (" +
                std::string(program_version()) +
                "); use that version, or pack the study file again as a changed study");
}

}  // namespace promenade::study
