// Independent work on all cores, with the results where a single thread would have put them.
#pragma once

#include <functional>
#include <string>

#include "analysis/progress.h"

namespace promenade::analysis {

// Calls work(0) to work(count - 1), each once, in any order and in several threads at a time.
// The first exception is thrown again when all threads have ended. `progress` is called by the
// calling thread alone: "WHAT DONE of COUNT"; OutsideError when it wants to stop. `threads`: how
// many; 0: one for each core.
void for_each_index(int count, const std::function<void(int)>& work, const Progress& progress = {},
                    const std::string& what = "", int threads = 0);

}  // namespace promenade::analysis
