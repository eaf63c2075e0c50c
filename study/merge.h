// Databases of the stations of one study, joined into one. Merging again changes nothing; who
// withdrew anywhere is in none any more; what contradicts itself is named and never guessed.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "motion/problem.h"
#include "study/withdraw.h"

namespace promenade::study {

struct MergedInput {
  std::string file;
  RowCounts taken;    // rows that were new
  int known = 0;      // sessions that were there already
  int withdrawn = 0;  // sessions left out: their person withdrew
  int gone_on = 0;    // sessions that were interrupted here before and have gone on since
};

struct Merged {
  std::vector<MergedInput> inputs;
  std::int64_t sessions = 0;  // in the end
  RowCounts removed;          // of people who withdrew elsewhere
  std::vector<Problem> warnings;
  std::vector<ReachedBackup> backups;  // where somebody had to be removed
  // Simulated people whose code was taken: it means nothing, and they get the next free one.
  std::map<std::string, std::string> renamed;
};

// Called after each session that was looked at; false: stop, change nothing.
using MergeProgress = std::function<bool(int done, int count)>;

// `out` may be there, with the same study, or not. Throws InputError with all conflicts at
// once, OutsideError when it cannot be written or was stopped; `out` is as before then.
Merged merge(const std::string& out, const std::vector<std::string>& inputs,
             const MergeProgress& progress = {});

}  // namespace promenade::study
