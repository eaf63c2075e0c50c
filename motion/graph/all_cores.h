// Independent pieces of work on all cores.
#pragma once

#include <functional>

namespace promenade::motion {

// Calls work(0) to work(count - 1), each once, in order of their start, in several threads at a
// time. `progress` is called by the calling thread alone, with the share that is done (0 to 1);
// when it returns false no more work is begun and false comes back. The first exception is thrown
// again when all threads have ended. `threads`: how many; 0: one for each core.
bool for_each_piece(int count, const std::function<void(int)>& work,
                    const std::function<bool(double)>& progress = {}, int threads = 0);

}  // namespace promenade::motion
