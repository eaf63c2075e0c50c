// Runs every case of a vectors file through the tests of this program, so that
// anyone can compare them with other programs (`promenade stats`).
//
// In:  {"families": {FAMILY: [{"id", "kind", "input", ...}]}}
// Out: {"results": {ID: {keys of the family}}}; a family or a case that cannot
// be done is {"error": "..."}, what is not defined is null. A case without an id of its
// own stands under "case 0 of family NAME", counted from 0.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace promenade::analysis {

// One JSON document with a line end. `file` names the file in messages. Throws
// InputError when the text is not JSON or has no families.
std::string run_vectors(const std::string& file, std::string_view text);

std::vector<std::string> known_families();

}  // namespace promenade::analysis
