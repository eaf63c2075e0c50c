#include "motion/load_clip.h"

#include <algorithm>
#include <fstream>

#include "motion/amc.h"
#include "motion/bvh.h"
#include "motion/files.h"
#include "motion/scanner.h"

namespace promenade::motion {
namespace {

namespace fs = std::filesystem;

bool has_ending(const fs::path& path, std::string_view ending) {
  return same_word(path.extension().string(), ending);
}

// As a shell takes it.
std::string shell_word(const std::string& text) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("_-./,+:@%").find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), plain)) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

[[noreturn]] void refuse_other_kind(const fs::path& path) {
  const std::string file = path.string();
  if (has_ending(path, ".fbx") || has_ending(path, ".c3d")) {
    const fs::path bvh = fs::path(path).replace_extension(".bvh");
    throw InputError(file,
                     "is of a kind that this program does not read; convert it: "
                     "tools/convert-capture " +
                         shell_word(file) + " " + shell_word(bvh.string()));
  }
  if (has_ending(path, ".asf")) {
    throw InputError(file, "is a skeleton without a motion; name the .amc file");
  }
  throw InputError(file, "is not a kind of capture that this program reads (.bvh, .amc)");
}

// Before a large file of something else is read to its end.
void check_is_text(const fs::path& path) {
  check_is_file(path);
  char head[512];
  std::ifstream file(path, std::ios::binary);
  file.read(head, sizeof head);
  const std::string_view start(head, static_cast<std::size_t>(file.gcount()));
  if (start.substr(0, 2) == "\xff\xfe" || start.substr(0, 2) == "\xfe\xff") {
    throw InputError(path.string(), "is text in UTF-16; save it as UTF-8 or ASCII");
  }
  const std::size_t zero = start.find('\0');
  if (zero == start.npos) return;
  const std::string_view before = start.substr(0, zero);
  const auto line = static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1;
  const std::size_t line_at = before.rfind('\n') + 1;  // 0 when there is none
  throw InputError({{path.string(), line, static_cast<int>(zero - line_at) + 1,
                     "is not a text file: here is a byte 0", Severity::error}});
}

std::string read_text(const fs::path& path) {
  check_is_text(path);
  return read_file(path);
}

// The .asf files of a folder, sorted: the order of a folder differs between machines.
std::vector<fs::path> skeletons_in(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (has_ending(entry->path(), ".asf")) found.push_back(entry->path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

Clip load_amc(const fs::path& path, const LoadOptions& options) {
  const std::string text = read_text(path);
  const fs::path skeleton = options.skeleton.empty() ? find_asf(path) : options.skeleton;
  return read_amc(text, path.string(), read_asf(read_text(skeleton), skeleton.string()),
                  options.rate);
}

}  // namespace

fs::path find_asf(const fs::path& amc) {
  const fs::path folder = amc.has_parent_path() ? amc.parent_path() : fs::path(".");
  const std::vector<fs::path> all = skeletons_in(folder);
  std::string stem = amc.stem().string();
  // "a_b_1.amc" may be of "a_b.asf" or "a.asf".
  for (std::size_t end = stem.rfind('_');; end = stem.rfind('_', end - 1)) {
    const std::string_view wanted = std::string_view(stem).substr(0, end);
    for (const fs::path& one : all) {
      if (same_word(one.stem().string(), wanted)) return amc.parent_path() / one.filename();
    }
    if (end == stem.npos || end == 0) break;
  }
  if (all.size() == 1) return amc.parent_path() / all.front().filename();
  const std::string first = stem.substr(0, stem.find('_'));
  throw InputError(amc.string(), "comes without its skeleton: beside it is no " + first + ".asf" +
                                     (all.empty() ? "" : " and more than one other") +
                                     "; name it with --skeleton FILE");
}

Clip load_clip(const fs::path& path, const LoadOptions& options) {
  if (has_ending(path, ".bvh")) return read_bvh(read_text(path), path.string());
  if (has_ending(path, ".amc")) return load_amc(path, options);
  if (fs::exists(path) && !fs::is_directory(path)) refuse_other_kind(path);
  read_file(path);  // says what is wrong with a missing file or a folder
  refuse_other_kind(path);
}

}  // namespace promenade::motion
