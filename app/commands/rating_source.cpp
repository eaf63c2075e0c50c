#include "app/commands/rating_source.h"

#include "motion/builtin.h"
#include "motion/files.h"
#include "motion/problem.h"
#include "study/ratings_csv.h"
#include "study/study.h"

namespace promenade::app {
namespace {

RatedSet rated_builtin(const RatingSource& source, const std::string& builtin,
                       const motion::QuantificationOptions& options) {
  if (!source.set.empty())
    throw InputError("--set", "the ratings of a built-in set are of its own motions");
  motion::MotionSet set = study::load_motion_set(source.name, "");
  auto model = study::builtin_adjective_model(builtin, options);
  if (!model) throw InputError(source.name, "nobody knows how its walks were meant");
  return {std::move(*model), std::move(set)};
}

}  // namespace

RatedSet load_rated_set(const RatingSource& source, const motion::QuantificationOptions& options) {
  if (const auto builtin = motion::builtin_name(source.name)) {
    return rated_builtin(source, *builtin, options);
  }
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
    table = study::read_ratings_csv(source.name, text,
                                    set ? names_of(*set) : std::vector<std::string>());
  }
  return {study::make_adjective_model(std::move(table), source.name, options), std::move(set)};
}

}  // namespace promenade::app
