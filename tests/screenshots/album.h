// The folder that photographs are put into.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/photograph.h"

namespace promenade::app::screenshots {

class Album {
 public:
  // Makes the folder. Throws OutsideError.
  explicit Album(std::filesystem::path folder);

  // Writes PREFIX-WHAT.png; throws OutsideError.
  void add(const std::string& prefix, const std::string& what, const Photograph& photograph);
  // All that were added, on one page: index.html.
  void write_contact_sheet() const;
  int size() const { return static_cast<int>(pictures_.size()); }

 private:
  struct Picture {
    std::string what, file;
  };
  std::filesystem::path folder_;
  std::vector<Picture> pictures_;
};

}  // namespace promenade::app::screenshots
