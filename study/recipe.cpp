#include "study/recipe.h"

#include <algorithm>
#include <filesystem>

#include "motion/files.h"
#include "study/toml_reader.h"

namespace promenade::study {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view style_mark = "{style}";

// Fits `name` to `pattern` from the left; "*" and {style} take as little as they can.
// `style` gets what {style} took.
bool fits(std::string_view name, std::string_view pattern, std::string* style) {
  if (pattern.empty()) return name.empty();
  if (pattern.substr(0, style_mark.size()) == style_mark) {
    for (std::size_t size = 1; size <= name.size(); ++size) {
      if (!fits(name.substr(size), pattern.substr(style_mark.size()), style)) continue;
      *style = name.substr(0, size);
      return true;
    }
    return false;
  }
  if (pattern[0] == '*') {
    for (std::size_t size = 0; size <= name.size(); ++size) {
      if (fits(name.substr(size), pattern.substr(1), style)) return true;
    }
    return false;
  }
  return !name.empty() && (pattern[0] == '?' || pattern[0] == name[0]) &&
         fits(name.substr(1), pattern.substr(1), style);
}

// Files of the folder that fit, with their styles.
std::vector<motion::TakeSource> find_takes(const fs::path& folder, const std::string& pattern) {
  std::vector<motion::TakeSource> takes;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    const std::optional<std::string> style = style_of(name, pattern);
    if (style) takes.push_back({entry->path().string(), name, *style});
  }
  // The order of a folder differs between machines.
  std::sort(takes.begin(), takes.end(),
            [](const auto& a, const auto& b) { return a.label < b.label; });
  return takes;
}

void check_pattern(const TomlTable& root, const std::string& pattern) {
  const auto stars = std::count(pattern.begin(), pattern.end(), '*');
  if (stars > 4) root.error("files", "at most four * can stand in a pattern");
  if (pattern.find('/') != pattern.npos) {
    root.error("files", "is about names of files only; name the folder in `folder`");
  }
  const std::size_t mark = pattern.find(style_mark);
  if (mark != pattern.npos && pattern.find(style_mark, mark + 1) != pattern.npos) {
    root.error("files", "{style} can stand only once in a pattern");
  }
}

void read_takes(const TomlTable& root, const fs::path& folder, const std::string& pattern,
                Recipe& recipe) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    root.error("folder",
               "there is no folder " + folder.string() + "; give another one with --folder DIR");
    return;
  }
  recipe.takes = find_takes(folder, pattern);
  if (recipe.takes.empty()) {
    root.error("files", "no file in " + folder.string() + " fits \"" + pattern + "\"");
  }
}

}  // namespace

std::optional<std::string> style_of(const std::string& file_name, const std::string& pattern) {
  std::string style;
  if (!fits(file_name, pattern, &style)) return std::nullopt;
  return style.empty() ? fs::path(file_name).stem().string() : style;
}

Recipe load_recipe(const std::string& file, const std::string& folder) {
  const std::string text = read_file(file);
  TomlReader reader(file, text);
  const TomlTable root = reader.root();
  Recipe recipe;
  recipe.options.name = root.required_text("name");
  recipe.options.credit = root.required_text("credit");
  const std::string own_folder = root.required_text("folder");
  const std::string pattern = root.text("files").value_or("*.bvh");
  recipe.options.cycles_per_take =
      static_cast<int>(root.integer("cycles_per_take", 1, 20).value_or(1));
  recipe.options.most_loop_error_m = root.number("most_loop_error_m", 0, 1).value_or(0.15);
  recipe.options.figure.unit_m = root.number("unit_m", 1e-6, 1e3);
  if (const auto up = root.choice("up", {"y", "z"})) recipe.options.figure.z_up = *up == "z";
  check_pattern(root, pattern);
  const fs::path place =
      (folder.empty() ? fs::path(file).parent_path() / own_folder : fs::path(folder))
          .lexically_normal();
  if (reader.ok()) read_takes(root, place, pattern, recipe);
  reader.finish();
  return recipe;
}

}  // namespace promenade::study
