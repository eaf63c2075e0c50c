// What is in a folder, to be chosen from: its folders first, then the files with one of these
// endings. Enter or a second press opens a folder or takes a file; the arrow keys go from row to
// row, Backspace to the folder above.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/widgets.h"

namespace promenade::app {

struct ListedFile {
  std::string name;  // ".." first, if there is a folder above
  bool folder = false;
};

// Sorted by name without regard to case; what is hidden is left out. A folder that cannot be read
// has only "..".
std::vector<ListedFile> list_folder(const std::string& folder,
                                    const std::vector<std::string>& endings);

class FileList {
 public:
  // `endings`: ".bvh" and so on, in lower case.
  FileList(const std::string& folder, std::vector<std::string> endings);

  const std::string& folder() const { return folder_; }
  void open(const std::string& folder);
  const std::vector<ListedFile>& files() const { return files_; }
  // A row is "file", `target`/NAME. The path of a file that was taken.
  std::optional<std::string> draw(const Ui& ui, std::string_view target, const Box& box);

 private:
  std::optional<std::string> take(const ListedFile& file);
  void move(const Ui& ui, std::string_view target, int by);

  std::string folder_;
  std::vector<std::string> endings_;
  std::vector<ListedFile> files_;
  std::size_t marked_ = 0;
};

}  // namespace promenade::app
