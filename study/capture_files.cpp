#include "study/capture_files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "motion/scanner.h"

namespace promenade::study {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_files = 5000;  // a home folder by mistake

bool is_capture(const fs::path& path) {
  const std::string ending = path.extension().string();
  return motion::same_word(ending, ".bvh") || motion::same_word(ending, ".amc");
}

void add_folder(const fs::path& folder, std::vector<std::string>& files) {
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                         error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    if (files.size() >= most_files) return;
    std::error_code ignored;
    if (is_capture(entry->path()) && entry->is_regular_file(ignored)) {
      files.push_back(entry->path().generic_string());
    }
  }
}

using Words = std::vector<std::string>;

Words words_of(const std::string& file) {
  Words words(1);
  for (const char c : fs::path(file).stem().string()) {
    if (c == '_' || c == '-' || c == ' ' || c == '.') {
      if (!words.back().empty()) words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

// Where the word with that number begins.
std::size_t start_of_word(const std::string& stem, std::size_t word) {
  constexpr const char* between = "_- .";
  std::size_t at = stem.find_first_not_of(between);
  for (std::size_t k = 0; k < word && at != std::string::npos; ++k) {
    at = stem.find_first_not_of(between, stem.find_first_of(between, at));
  }
  return at == std::string::npos ? 0 : at;
}

bool is_number(const std::string& word) {
  return std::all_of(word.begin(), word.end(),
                     [](unsigned char c) { return std::isdigit(c) != 0; });
}

// Without the number at the end.
Words without_number(Words words) {
  while (!words.empty() && is_number(words.back())) words.pop_back();
  return words;
}

// How many words these begin with together, or end with.
std::size_t shared_words(const std::vector<Words>& all, bool at_end) {
  if (all.size() < 2) return 0;
  const auto word = [at_end](const Words& words, std::size_t k) {
    return words[at_end ? words.size() - 1 - k : k];
  };
  for (std::size_t shared = 0;; ++shared) {
    for (const Words& words : all) {
      if (shared >= words.size() || word(words, shared) != word(all.front(), shared)) return shared;
    }
  }
}

// The words of each file, and how many of them say nothing: those with which all files begin, and
// end, that have the same first word. Captures of several series may lie in one heap.
struct NamedFile {
  Words words;
  std::size_t front = 0, back = 0;
};

std::vector<NamedFile> named(const std::vector<std::string>& files) {
  std::vector<NamedFile> all;
  std::map<std::string, std::vector<Words>> whole, stems;  // by first word
  for (const std::string& file : files) {
    all.push_back({words_of(file)});
    if (all.back().words.empty()) continue;
    whole[all.back().words.front()].push_back(all.back().words);
    stems[all.back().words.front()].push_back(without_number(all.back().words));
  }
  for (NamedFile& file : all) {
    if (file.words.empty()) continue;
    file.front = shared_words(whole[file.words.front()], false);
    file.back = shared_words(stems[file.words.front()], true);
  }
  return all;
}

// Without so many words in front and behind; "" if nothing with a letter is left.
std::string style_of_words(const Words& all, std::size_t front, std::size_t back) {
  const Words words = without_number(all);
  std::string style;
  for (std::size_t k = front; k + back < words.size(); ++k) {
    style += (style.empty() ? "" : "-") + words[k];
  }
  return is_number(style) ? "" : style;
}

}  // namespace

std::vector<std::string> capture_files(const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    std::error_code error;
    const fs::path whole = fs::absolute(path, error).lexically_normal();
    if (fs::is_directory(whole, error)) {
      add_folder(whole, files);
    } else {
      files.push_back(whole.generic_string());
    }
  }
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

std::vector<std::string> styles_of(const std::vector<std::string>& files) {
  std::vector<std::string> styles;
  for (const NamedFile& file : named(files)) {
    styles.push_back(style_of_words(file.words, file.front, file.back));
    if (styles.back().empty()) styles.back() = style_of_words(file.words, file.front, 0);
    if (styles.back().empty()) styles.back() = style_of_words(file.words, 0, 0);
    if (styles.back().empty()) styles.back() = fs::path(files[styles.size() - 1]).stem().string();
  }
  return styles;
}

std::vector<std::string> short_names(const std::vector<std::string>& files) {
  const std::vector<NamedFile> all = named(files);
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const fs::path file(files[i]);
    const std::string stem = file.stem().string();
    const std::size_t shared = all[i].front;
    names.push_back(stem.substr(shared < all[i].words.size() ? start_of_word(stem, shared) : 0));
    // A number alone says too little.
    if (is_number(names.back())) names.back() = stem;
    if (!seen.insert(names.back()).second) names.back() = file.filename().string();
  }
  return names;
}

std::vector<FileLine> lines_around(const std::string& file, int line, int column, int reach,
                                   std::size_t most) {
  std::ifstream stream(file, std::ios::binary);
  std::vector<FileLine> lines;
  std::string text;
  for (int number = 1; number <= line + reach && std::getline(stream, text); ++number) {
    if (number < line - reach) continue;
    const std::size_t at = column > 0 ? static_cast<std::size_t>(column) - 1 : 0;
    const bool whole = text.size() <= most;
    const std::size_t from = whole || at < most / 2 ? 0 : at - most / 2;
    std::string part = from < text.size() ? text.substr(from, most) : "";
    std::replace_if(
        part.begin(), part.end(), [](char c) { return c < ' ' || c > '~'; }, ' ');
    lines.push_back(
        {number, (from > 0 ? "… " : "") + part + (from + most < text.size() ? " …" : "")});
  }
  return lines;
}

std::string common_folder(const std::vector<std::string>& files) {
  if (files.empty()) return {};
  fs::path common = fs::path(files.front()).parent_path();
  for (const std::string& file : files) {
    const auto below = [&file](const fs::path& folder) {
      const std::string start = folder.generic_string();
      return file.starts_with(start.ends_with('/') ? start : start + "/");
    };
    while (!below(common) && common.has_relative_path()) common = common.parent_path();
  }
  return common.generic_string();
}

}  // namespace promenade::study
