#include "motion/take_loader.h"

#include <algorithm>
#include <cmath>

namespace promenade::motion {
namespace {

Cut cut_out(const Take& take, const CycleCandidate& cycle, const std::string& name) {
  constexpr int margin = 3;  // frames that poses and velocities beside the ends follow from
  const int from = std::max(static_cast<int>(std::floor(cycle.first())) - margin, 0);
  const int to =
      std::min(static_cast<int>(std::ceil(cycle.keys.back())) + margin, take.frames() - 1);
  Cut cut{name, part(take, from, to), cycle, cycle};
  for (double& key : cut.cycle.keys) key -= from;
  return cut;
}

}  // namespace

void TakeLoader::load(const TakeSource& source) {
  try {
    const Take take = read(source);
    LoadedTake loaded{source, {}, 0, take.period, {}};
    if (source.cycles.empty()) {
      find(take, loaded);
    } else {
      follow(take, loaded);
    }
    takes_.push_back(std::move(loaded));
    skeletons_.push_back({take.source, take.skeleton, take.body, take.frame_time, {}, 0, 0});
  } catch (const InputError& error) {
    problems_.insert(problems_.end(), error.problems().begin(), error.problems().end());
  }
}

Take TakeLoader::read(const TakeSource& source) {
  ReadTake read = read_take(source, {options_.recipe, options_.figure});
  built_.warnings.insert(built_.warnings.end(), read.warnings.begin(), read.warnings.end());
  const double last = read.take.first_frame + read.take.frames() - 1.0;
  const bool within = std::all_of(
      source.cycles.begin(), source.cycles.end(),
      [&](const GivenCycle& one) { return one.frames.empty() || one.frames.back() <= last; });
  // A cycle that is given beyond the end runs over the seam of a take that is one loop.
  if (!source.cycles.empty() && within) return std::move(read.take);
  return unrolled(std::move(read.take));
}

void TakeLoader::find(const Take& take, LoadedTake& loaded) {
  FootContacts contacts = find_contacts(take);
  const CycleSearch search = options_.walk ? find_cycles(take, contacts, options_.search)
                                           : find_any_loops(take, options_.search);
  loaded.found = static_cast<int>(search.candidates.size());
  if (search.candidates.empty()) loaded.refusal = "gives no cycle: " + search.refusal;
  for (const CycleCandidate& cycle : best_apart(search.candidates, options_.cycles_per_take)) {
    loaded.cuts.push_back(cut_out(take, cycle, ""));
  }
  record(take, std::move(contacts), search.candidates);
}

void TakeLoader::follow(const Take& take, LoadedTake& loaded) {
  for (const GivenCycle& given : loaded.source.cycles) {
    std::vector<double> keys = given.frames;
    for (double& key : keys) key -= take.first_frame;
    const std::string trouble = trouble_with_keys(take, keys);
    if (trouble.empty()) {
      loaded.cuts.push_back(cut_out(take, given_cycle(take, std::move(keys)), given.name));
    } else {
      problems_.push_back(asked_at(options_.recipe, given.place, loaded.source, trouble));
    }
  }
  if (options_.keep_takes) record(take, find_contacts(take), {});
}

void TakeLoader::record(const Take& take, FootContacts contacts,
                        std::vector<CycleCandidate> cycles) {
  if (!options_.keep_takes) return;
  built_.takes.push_back({take.source, take.frame_time, take.first_frame, take.period,
                          std::move(contacts), std::move(cycles)});
}

}  // namespace promenade::motion
