// What the study and the program have to choose from, for the fields that pick one of it.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "study/study.h"
#include "study/toml_reader.h"

namespace promenade::app {

class EditOptions {
 public:
  // `file`: the study's; files beside it can be chosen by name.
  EditOptions(std::string file, const study::InterfaceRegistry& registry);

  // What the text of the file names itself, and the walks of its motion set; null leaves those
  // that are there.
  void follow(const study::TomlValue& root, const study::StudyBundle* motions);

  // By the name of a source, "@walks".
  const std::vector<std::string>& of(std::string_view source) const;

 private:
  void find_files();
  std::string file_;
  std::map<std::string, std::vector<std::string>, std::less<>> lists_;
};

}  // namespace promenade::app
