// How carefully motions were rated, as a part of the section on data quality.
#pragma once

#include "analysis/report/section.h"

namespace promenade::analysis {

// Adds to a section what there is to say where motions were rated; else nothing.
void add_rating_quality(const Results& results, Section& section);

}  // namespace promenade::analysis
