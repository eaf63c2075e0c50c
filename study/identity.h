// Where the outside world comes in: the wall clock, random identities, hashes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace promenade::study {

// "2026-11-22T16:02:29Z": the only place that reads the wall clock.
std::string utc_now();

// Seconds from one such text to another; nothing when one is no such text.
std::optional<std::int64_t> seconds_between(const std::string& from, const std::string& to);

// "0f8fad5b-d9cb-469f-a165-70867728950e". Throws OutsideError without a source of chance.
std::string random_uuid();

std::string_view program_version();

// 64 hexadecimal digits.
std::string sha256_hex(std::string_view bytes);

}  // namespace promenade::study
