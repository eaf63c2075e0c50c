#include "tests/source_dir.h"

namespace promenade {

// The only file that is compiled with the path: all others are the same in every checkout.
std::filesystem::path source_dir() { return PROMENADE_SOURCE_DIR; }

}  // namespace promenade
