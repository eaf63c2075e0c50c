// The random numbers of motion/, for studies: one stream for each (seed, participant, purpose).
#pragma once

#include "motion/rng.h"

namespace promenade::study {

using motion::Rng;

}  // namespace promenade::study
