// How long a session takes, before anybody came: told from a few simulated people.
#pragma once

#include <functional>
#include <vector>

#include "study/interface.h"
#include "study/plan.h"
#include "study/study.h"

namespace promenade::study {

// Minutes, of people with the first orders of the study. They are as patient, and read as fast,
// as study/simulated.h says.
struct SessionLength {
  double median = 0, least = 0, most = 0;
};

// Through the very code of a session. `go_on` is called before each person; when it says no,
// the people so far count. At least one person.
SessionLength session_length(const StudyBundle& bundle, const InterfaceRegistry& registry,
                             int people, const std::function<bool()>& go_on);

// Minutes from the moment at which each page of this plan opens to the end: the median of the
// people. A page that nobody came to has those of the next one.
std::vector<double> minutes_left(const StudyBundle& bundle, const InterfaceRegistry& registry,
                                 const Plan& plan, int people);

}  // namespace promenade::study
