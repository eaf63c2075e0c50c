// How often malloc was called by this program, for tests of code that must not.
#pragma once

#if defined(__SANITIZE_ADDRESS__)
#define PROMENADE_COUNTS_ALLOCATIONS 0  // the sanitizer brings its own malloc
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define PROMENADE_COUNTS_ALLOCATIONS 0
#endif
#endif
#ifndef PROMENADE_COUNTS_ALLOCATIONS
#define PROMENADE_COUNTS_ALLOCATIONS 1
#endif

namespace promenade::motion {

long allocations();

}  // namespace promenade::motion
