// From files to the cycles that a set wants of them. Used by set_builder only.
#pragma once

#include "motion/set_builder.h"

namespace promenade::motion {

// A cycle that was chosen, with the frames of its take that it needs: the rest of a long
// take is not kept.
struct Cut {
  std::string name;  // empty: the style and a number
  Take part;
  CycleCandidate cycle;  // in frames of the part
  CycleCandidate in_take;
};

struct LoadedTake {
  TakeSource source;
  std::vector<Cut> cuts;
  int found = 0, period = 0;
  std::string refusal;
};

// Reads takes and chooses their cycles. One take at a time is in memory as a whole.
class TakeLoader {
 public:
  // Warnings and, if the options ask for them, records of takes go to `built`.
  TakeLoader(const SetOptions& options, BuiltSet& built) : options_(options), built_(built) {}

  void load(const TakeSource& source);

  const std::vector<Problem>& problems() const { return problems_; }
  const std::vector<LoadedTake>& takes() const { return takes_; }
  const std::vector<Take>& skeletons() const { return skeletons_; }  // takes without poses

 private:
  Take read(const TakeSource& source);
  void find(const Take& take, LoadedTake& loaded);
  void follow(const Take& take, LoadedTake& loaded);
  void record(const Take& take, FootContacts contacts, std::vector<CycleCandidate> cycles);

  const SetOptions& options_;
  BuiltSet& built_;
  std::vector<LoadedTake> takes_;
  std::vector<Take> skeletons_;
  std::vector<Problem> problems_;
};

}  // namespace promenade::motion
