// The list of people whom an analyst leaves out, and why.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace promenade::analysis {

struct Exclusion {
  std::string code;    // of the participant
  std::string reason;  // may be empty
  int line = 0;        // in the file, from 1
};

// "CODE,REASON" on each line; a first line "code,reason" is a heading. Text in
// double quotes may hold commas. Throws InputError with all wrong lines.
std::vector<Exclusion> parse_exclusions(const std::string& file, std::string_view text);

}  // namespace promenade::analysis
