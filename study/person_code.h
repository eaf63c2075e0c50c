// Codes that stand for people: four characters by lot and one that checks them, as "K7Q4S".
// Digits and consonants without 0, 1, I and O, so that none is taken for another and no code is
// a word: 29 of them, a prime.
//
// With values v from 0 to 28, a code fulfils 1 v1 + 2 v2 + 3 v3 + 4 v4 + 5 v5 = 0 modulo 29, as
// ISBN-10 does modulo 11: a single wrong character changes the sum by k (v - v'), a swap of
// neighbours by v - v', and neither is a multiple of a prime above 28. So all of both are seen.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "study/rng.h"

namespace promenade::study {

inline constexpr std::string_view code_characters = "23456789BCDFGHJKLMNPQRSTVWXYZ";
inline constexpr int code_length = 5;

// In capitals, without spaces and hyphens: what somebody meant who typed "k7q-x3".
std::string tidy_code(std::string_view typed);

// Five of the characters, and the check holds.
bool is_person_code(std::string_view code);

std::string draw_person_code(Rng& rng);

// The one of the codes that was probably meant: one wrong or missing character, or two swapped.
// Empty: none, or more than one.
std::string meant_code(std::string_view typed, const std::vector<std::string>& codes);

}  // namespace promenade::study
