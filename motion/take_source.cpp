#include "motion/take_source.h"

#include <algorithm>

namespace promenade::motion {
namespace {

// The frames of a take that the recipe wants.
Take wanted_part(Take take, const TakeSource& source, const std::string& recipe) {
  const int last = take.frames() - 1;
  const int from = source.from.value_or(0), to = std::min(source.to.value_or(last), last);
  if (from > to) {
    throw InputError({asked_at(recipe, source.place, source,
                               "has only " + std::to_string(take.frames()) +
                                   " frames, so none from frame " + std::to_string(from))});
  }
  if (from == 0 && to == last) return take;
  return part(take, from, to);
}

}  // namespace

Problem asked_at(const std::string& recipe, const Place& place, const TakeSource& source,
                 const std::string& message) {
  if (place.line == 0) return {source.file, 0, 0, message, Severity::error};
  return {recipe, place.line, place.column, source.label + " " + message, Severity::error};
}

ReadTake read_take(const TakeSource& source, const ReadOptions& options) {
  FigureOptions figure_options = source.figure;
  if (!figure_options.unit_m) figure_options.unit_m = options.figure.unit_m;
  if (!figure_options.z_up) figure_options.z_up = options.figure.z_up;
  const Clip clip = load_clip(source.file, source.load);
  ReadTake read;
  read.figure = find_figure(clip, figure_options);
  for (const auto& list : {clip.warnings, read.figure.notes}) {
    read.warnings.insert(read.warnings.end(), list.begin(), list.end());
  }
  read.take = wanted_part(make_take(clip, read.figure), source, options.recipe);
  return read;
}

}  // namespace promenade::motion
