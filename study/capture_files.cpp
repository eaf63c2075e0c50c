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

// How many words these begin with together.
std::size_t shared_words(const std::vector<const Words*>& all) {
  if (all.size() < 2) return 0;
  std::size_t shared = all.front()->size();
  for (const Words* words : all) {
    const auto end =
        std::mismatch(all.front()->begin(), all.front()->end(), words->begin(), words->end());
    shared = std::min(shared, static_cast<std::size_t>(end.first - all.front()->begin()));
  }
  return shared;
}

// The words of each file, and how many of them say nothing: those with which all files begin that
// have the same first word. Captures of several series may lie in one heap.
struct NamedFiles {
  std::vector<Words> words;
  std::vector<std::size_t> shared;
};

NamedFiles words_of_all(const std::vector<std::string>& files) {
  NamedFiles named;
  for (const std::string& file : files) named.words.push_back(words_of(file));
  std::map<std::string, std::vector<const Words*>> series;
  for (const Words& words : named.words) {
    if (!words.empty()) series[words.front()].push_back(&words);
  }
  for (const Words& words : named.words) {
    named.shared.push_back(words.empty() ? 0 : shared_words(series[words.front()]));
  }
  return named;
}

std::string style_of_words(Words words, std::size_t shared) {
  words.erase(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(shared));
  while (!words.empty() && is_number(words.back())) words.pop_back();
  std::string style;
  for (const std::string& word : words) style += (style.empty() ? "" : "-") + word;
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
  const NamedFiles named = words_of_all(files);
  std::vector<std::string> styles;
  for (std::size_t i = 0; i < files.size(); ++i) {
    styles.push_back(style_of_words(named.words[i], named.shared[i]));
    if (styles.back().empty()) styles.back() = style_of_words(named.words[i], 0);
    if (styles.back().empty()) styles.back() = fs::path(files[i]).stem().string();
  }
  return styles;
}

std::vector<std::string> short_names(const std::vector<std::string>& files) {
  const NamedFiles named = words_of_all(files);
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const fs::path file(files[i]);
    const std::string stem = file.stem().string();
    const std::size_t shared = named.shared[i];
    names.push_back(stem.substr(shared < named.words[i].size() ? start_of_word(stem, shared) : 0));
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
