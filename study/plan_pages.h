// From the trials of a plan to its pages. Inside study/ only.
#pragma once

#include "study/plan.h"

namespace promenade::study {

void add_pages(const Study& study, Plan& plan);

}  // namespace promenade::study
