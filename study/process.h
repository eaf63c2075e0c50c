// Which process wrote a row, so that an interrupted session is told from a running one.
#pragma once

#include <cstdint>
#include <string>

namespace promenade::study {

// The boot and the tick of it at which a process of this machine was started; "" when there
// is none. Unlike its number this is never given again.
std::string process_start(std::int64_t process);

// Does the process live that had this number and this start? Without a start, from an old
// database, the number decides.
bool lives(std::int64_t process, const std::string& start);

}  // namespace promenade::study
