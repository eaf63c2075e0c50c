// Which captures lie where somebody points, and what their names say.
#pragma once

#include <string>
#include <vector>

namespace promenade::study {

// A file is itself, whatever it is, so that somebody hears what is wrong with it. A folder is all
// captures (.bvh, .amc) in it and below, sorted by their paths. Absolute, each once.
std::vector<std::string> capture_files(const std::vector<std::string>& paths);

// What each shows, by its name: without the words that all files begin with and without the number
// at its end, so that "walk_happy_001.bvh" beside "walk_sad_001.bvh" is "happy". Where no word is
// left, the name of the file without its ending.
std::vector<std::string> styles_of(const std::vector<std::string>& files);

// What tells them apart: the names without their endings and without the words that all begin
// with. The whole names where two would be the same.
std::vector<std::string> short_names(const std::vector<std::string>& files);

// The deepest folder that all lie below; empty: there are none.
std::string common_folder(const std::vector<std::string>& files);

}  // namespace promenade::study
