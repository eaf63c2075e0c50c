#include "app/commands/rating_source.h"

#include "app/commands/ratings.h"
#include "motion/files.h"
#include "motion/problem.h"
#include "study/study.h"

namespace promenade::app {
namespace {

constexpr std::string_view builtin = "builtin:";

std::vector<std::string> names_of(const std::optional<motion::MotionSet>& set) {
  std::vector<std::string> names;
  if (!set) return names;
  for (const motion::Cycle& cycle : set->cycles) names.push_back(cycle.name);
  return names;
}

RatedSet rated_builtin(const RatingSource& source, const motion::QuantificationOptions& options) {
  if (!source.set.empty())
    throw InputError("--set", "the ratings of a built-in set are of its own motions");
  motion::MotionSet set = study::load_motion_set(source.name, "");
  auto model = study::builtin_adjective_model(source.name.substr(builtin.size()), options);
  if (!model) throw InputError(source.name, "nobody knows how its walks were meant");
  return {std::move(*model), std::move(set)};
}

}  // namespace

RatedSet load_rated_set(const RatingSource& source, const motion::QuantificationOptions& options) {
  if (source.name.rfind(builtin, 0) == 0) return rated_builtin(source, options);
  std::optional<motion::MotionSet> set;
  if (!source.set.empty()) set = study::load_motion_set(source.set, "");
  const std::string text = read_file(source.name);
  study::RatingsTable table;
  if (text.rfind("SQLite format 3", 0) == 0) {
    study::DatabaseRatings found =
        study::read_database_ratings(source.name, source.selection, set ? &*set : nullptr);
    table = std::move(found.table);
    set = std::move(found.set);
  } else {
    table = read_ratings(source.name, text, names_of(set));
  }
  return {study::make_adjective_model(std::move(table), source.name, options), std::move(set)};
}

}  // namespace promenade::app
