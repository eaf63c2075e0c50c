// The studies whose printed results the program knows: what [study] published can be. Their
// numbers are in analysis/published/.
#pragma once

#include <string>
#include <vector>

namespace promenade::study {

// "oshita-2018" and so on, sorted; configs/studies has a file of each name.
const std::vector<std::string>& published_studies();

}  // namespace promenade::study
