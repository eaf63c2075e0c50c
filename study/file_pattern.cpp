#include "study/file_pattern.h"

#include <algorithm>
#include <string_view>

namespace promenade::study {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view style_mark = "{style}";

// Fits a name to a pattern from the left; "*" and {style} take as little as they can.
// Ends that did not fit are noted, so that the time is bounded by the product of the
// lengths.
class Match {
 public:
  Match(std::string_view name, std::string_view pattern)
      : name_(name), pattern_(pattern), failed_((name.size() + 1) * (pattern.size() + 1), false) {}

  bool fits() { return fits(0, 0); }
  std::string_view style() const { return style_; }  // empty: the pattern has no {style}

 private:
  // The rest of the name from n, the rest of the pattern from p.
  bool fits(std::size_t n, std::size_t p) {
    const std::size_t place = n * (pattern_.size() + 1) + p;
    if (failed_[place]) return false;
    const bool found = try_fit(n, p);
    failed_[place] = !found;
    return found;
  }

  bool try_fit(std::size_t n, std::size_t p) {
    if (p == pattern_.size()) return n == name_.size();
    if (pattern_[p] == '*') return fits(n, p + 1) || (n < name_.size() && fits(n + 1, p));
    if (pattern_.substr(p, style_mark.size()) == style_mark) return fits_style(n, p);
    return n < name_.size() && (pattern_[p] == '?' || pattern_[p] == name_[n]) &&
           fits(n + 1, p + 1);
  }

  bool fits_style(std::size_t n, std::size_t p) {
    for (std::size_t end = n + 1; end <= name_.size(); ++end) {
      if (!fits(end, p + style_mark.size())) continue;
      style_ = name_.substr(n, end - n);
      return true;
    }
    return false;
  }

  std::string_view name_, pattern_, style_;
  std::vector<bool> failed_;
};

std::vector<std::string> parts_of(const std::string& path) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= path.size();) {
    const std::size_t end = std::min(path.find('/', at), path.size());
    parts.push_back(path.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

// Walks down the folders that fit, one part of the pattern at a time.
void gather(const fs::path& folder, const std::string& prefix,
            const std::vector<std::string>& pattern, std::size_t depth, const std::string& style,
            std::vector<FoundFile>& found) {
  const std::string& part = pattern[depth];
  const bool last = depth + 1 == pattern.size();
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    Match match(name, part);
    if (!match.fits()) continue;
    std::string named = match.style().empty() ? style : std::string(match.style());
    std::error_code ignored;
    if (last && !entry->is_directory(ignored)) {
      if (named.empty()) named = fs::path(name).stem().string();
      found.push_back({prefix + name, std::move(named)});
    } else if (!last && entry->is_directory(ignored)) {
      gather(entry->path(), prefix + name + "/", pattern, depth + 1, named, found);
    }
  }
}

}  // namespace

std::optional<std::string> style_of(const std::string& path, const std::string& pattern) {
  const std::vector<std::string> names = parts_of(path), parts = parts_of(pattern);
  if (names.size() != parts.size()) return std::nullopt;
  std::string style;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Match match(names[i], parts[i]);
    if (!match.fits()) return std::nullopt;
    if (!match.style().empty()) style = match.style();
  }
  return style.empty() ? fs::path(names.back()).stem().string() : style;
}

std::string trouble_with_pattern(const std::string& pattern) {
  if (std::count(pattern.begin(), pattern.end(), '*') > 4) {
    return "at most four * can stand in a pattern";
  }
  const std::size_t mark = pattern.find(style_mark);
  if (mark != pattern.npos && pattern.find(style_mark, mark + 1) != pattern.npos) {
    return "{style} can stand only once in a pattern";
  }
  const std::vector<std::string> parts = parts_of(pattern);
  if (std::any_of(parts.begin(), parts.end(),
                  [](const auto& part) { return part.empty() || part == "." || part == ".."; })) {
    return "a pattern is a path below `folder`, such as \"*/{style}_1.bvh\"";
  }
  return {};
}

std::vector<FoundFile> find_files(const fs::path& folder, const std::string& pattern) {
  std::vector<FoundFile> found;
  gather(folder, "", parts_of(pattern), 0, "", found);
  // The order of a folder differs between machines.
  std::sort(found.begin(), found.end(),
            [](const FoundFile& a, const FoundFile& b) { return a.path < b.path; });
  return found;
}

}  // namespace promenade::study
