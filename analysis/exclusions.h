// The list of people whom an analyst leaves out, and why.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace promenade::analysis {

struct Exclusion {
  std::string code;    // of the participant
  std::string reason;  // may be empty, as what follows
  int line = 0;        // in the file, from 1
  std::string rule;    // by which rule of the plan
  std::string date;    // when it was decided: YYYY-MM-DD
};

// "CODE,REASON" on each line. A first line that begins with the word "code" or names it is a
// heading; only a heading makes further columns: "code", "reason", "rule" and "date", in any
// order. Text in double quotes may hold commas. Throws InputError with all wrong lines.
std::vector<Exclusion> parse_exclusions(const std::string& file, std::string_view text);

// The same as such a text, with its heading.
std::string exclusions_csv(const std::vector<Exclusion>& exclusions);

}  // namespace promenade::analysis
