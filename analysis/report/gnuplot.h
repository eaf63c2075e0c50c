// Runs gnuplot, which draws the figures.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace promenade::analysis {

// Runs `script` with `folder` as the working directory; what it writes lands there.
// Throws OutsideError when gnuplot is not installed or refuses the script.
void run_gnuplot(const std::string& script, const std::filesystem::path& folder);

// The same for a script that lies in the folder. Several threads may draw in one folder.
void run_gnuplot_file(const std::string& script_name, const std::filesystem::path& folder);

// A text as a gnuplot string that nothing in it can end, expand or execute.
std::string gnuplot_text(std::string_view text);

// cairo puts the time of making into a PDF; this puts a fixed date of the same
// length there, so that the same figure is the same file.
std::string without_creation_date(std::string pdf);

}  // namespace promenade::analysis
