#include "app/file_list.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "app/scroll_area.h"

namespace promenade::app {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool is_wanted(const fs::path& file, const std::vector<std::string>& endings) {
  const std::string ending = lower(file.extension().string());
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

std::string target_of(std::string_view target, const ListedFile& file) {
  return std::string(target) + "/" + file.name;
}

}  // namespace

std::vector<ListedFile> list_folder(const std::string& folder,
                                    const std::vector<std::string>& endings) {
  std::vector<ListedFile> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    const std::string name = entry->path().filename().string();
    const bool is_folder = entry->is_directory(ignored);
    if (name.starts_with('.') || (!is_folder && !is_wanted(entry->path(), endings))) continue;
    files.push_back({name, is_folder});
  }
  std::sort(files.begin(), files.end(), [](const ListedFile& a, const ListedFile& b) {
    if (a.folder != b.folder) return a.folder;
    return std::pair(lower(a.name), a.name) < std::pair(lower(b.name), b.name);
  });
  if (fs::path(folder).has_relative_path()) files.insert(files.begin(), {"..", true});
  return files;
}

FileList::FileList(const std::string& folder, std::vector<std::string> endings)
    : endings_(std::move(endings)) {
  open(folder);
}

void FileList::open(const std::string& folder) {
  std::error_code error;
  fs::path whole = fs::absolute(folder, error).lexically_normal();
  if (!whole.has_filename() && whole.has_relative_path()) whole = whole.parent_path();
  const std::string before = fs::path(folder_).filename().string();
  const bool up = fs::path(folder_).parent_path() == whole;
  folder_ = whole.string();
  files_ = list_folder(folder_, endings_);
  marked_ = 0;
  for (std::size_t i = 0; up && i < files_.size(); ++i) {
    if (files_[i].name == before) marked_ = i;  // where one comes from
  }
}

std::optional<std::string> FileList::take(const ListedFile& file) {
  const std::string path = (fs::path(folder_) / file.name).lexically_normal().string();
  if (!file.folder) return path;
  open(file.name == ".." ? fs::path(folder_).parent_path().string() : path);
  return std::nullopt;
}

void FileList::move(const Ui& ui, std::string_view target, int by) {
  if (files_.empty()) return;
  const int last = static_cast<int>(files_.size()) - 1;
  marked_ = static_cast<std::size_t>(std::clamp(static_cast<int>(marked_) + by, 0, last));
  ui.focus.go_on("file", target_of(target, files_[marked_]));
}

std::optional<std::string> FileList::draw(const Ui& ui, std::string_view target, const Box& box) {
  const float row = ui.layout.size(32);
  const bool here = ui.focus.on_first("file", std::string(target) + "/");
  const bool entered = here && key_pressed(ImGuiKey_Enter, false);
  if (here && key_pressed(ImGuiKey_DownArrow)) move(ui, target, 1);
  if (here && key_pressed(ImGuiKey_UpArrow)) move(ui, target, -1);
  std::optional<std::size_t> pressed;
  scrolled(std::string(target).c_str(), box, row * static_cast<float>(files_.size()),
           [&](const Box& all) {
             for (std::size_t i = 0; i < files_.size(); ++i) {
               const Box line{all.x, all.y + row * static_cast<float>(i), all.width, row};
               const std::string name = files_[i].name + (files_[i].folder ? "/" : "");
               if (list_row(ui, "file", target_of(target, files_[i]), line, name, i == marked_)) {
                 pressed = i;
               }
             }
           });
  std::optional<std::string> taken;
  if (pressed) {
    const bool again = *pressed == marked_ && (entered || ImGui::IsMouseDoubleClicked(0));
    marked_ = *pressed;
    if (again) taken = take(files_[marked_]);
  } else if (here && key_pressed(ImGuiKey_Backspace, false)) {
    open(fs::path(folder_).parent_path().string());
  }
  return taken;
}

}  // namespace promenade::app
