// Which captures lie where somebody points, and what their names say.
#pragma once

#include <string>
#include <vector>

namespace promenade::study {

// A file is itself, whatever it is, so that somebody hears what is wrong with it. A folder is all
// captures (.bvh, .amc) in it and below, sorted by their paths. Absolute, each once.
std::vector<std::string> capture_files(const std::vector<std::string>& paths);

// What each shows, by its name: without the words that all files of its series (those with the same
// first word) begin and end with, and without the number at its end, so that "walk_happy_001.bvh"
// beside "walk_sad_001.bvh" is "happy". Where no word is left, the name of the file without its
// ending.
std::vector<std::string> styles_of(const std::vector<std::string>& files);

// What tells them apart: the names without their endings and without the words that all of a series
// begin with. The whole names where two would be the same.
std::vector<std::string> short_names(const std::vector<std::string>& files);

// A line of a file, or as much of it as is shown.
struct FileLine {
  int number = 0;  // from 1
  std::string text;
};

// The lines around one that something is wrong with, `reach` on either side, each at most `most`
// bytes around `column` (from 1; 0: from the beginning). Nothing if it cannot be read.
std::vector<FileLine> lines_around(const std::string& file, int line, int column, int reach,
                                   std::size_t most);

// The deepest folder that all lie below; empty: there are none.
std::string common_folder(const std::vector<std::string>& files);

}  // namespace promenade::study
