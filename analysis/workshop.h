// A folder of results that appears complete or not at all: it is made beside the wanted one
// and put in its place at the end.
#pragma once

#include <filesystem>
#include <string>

namespace promenade::analysis {

// "out/" and "out" are the same folder, and what stands beside it is beside both. Throws
// InputError when it is a file.
std::filesystem::path wanted_folder(const std::filesystem::path& given);

class Workshop {
 public:
  // Makes the folder beside `wanted`. Throws OutsideError where nothing can be written.
  explicit Workshop(const std::filesystem::path& wanted);
  ~Workshop();  // what was not put in place goes away
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  const std::filesystem::path& path() const { return path_; }
  // At once where nothing stands yet; else file by file over what has the same name, `last`
  // as the last one, so that it never speaks of what is not there. Other files stay.
  void put_in_place(const std::string& last) const;
  // A message about the wanted folder: nobody asked for the one that things are made in.
  std::string as_wanted(std::string message) const;

 private:
  std::filesystem::path wanted_, path_;
};

}  // namespace promenade::analysis
