// Ratings of motions on pairs of adjectives ([O] 3), from wherever they come: people
// in a database, a table on disk, or simulated raters.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "motion/models/adjectives.h"
#include "motion/motion_set.h"

namespace promenade::study {

struct NamedRating {
  std::string rater, motion, pair;
  double value = 0;  // -2 (left pole) to 2 (right pole)
};

struct RatingsTable {
  std::vector<std::string> motions;  // by name, unless an order was given
  std::vector<std::string> pairs;    // the 41 of the source first, in their order
  int raters = 0;
  std::vector<std::string> rater_names;  // as they came; a file that is made has numbers
  std::vector<motion::Rating> ratings;
  bool simulated = false;  // some rater was not a person: this is said wherever it shows
};

// `motions`: those that may occur, in the order wanted; empty: those that do, by name.
RatingsTable make_ratings_table(const std::vector<NamedRating>& ratings,
                                const std::vector<std::string>& motions);

struct RatingSelection {
  bool include_simulated = false, include_pilot = false;
  std::string instrument;  // only answers of this questionnaire; empty: of all
  // Only of these, by uuid; nothing: of all that the others let through.
  std::optional<std::set<std::string>> sessions = {};
};

struct DatabaseRatings {
  RatingsTable table;
  std::optional<motion::MotionSet> set;  // the motions that were rated, if they are in the file
  std::vector<std::string> stimuli;      // were rated, too, by name; their ratings are left out
};

// The answers about a trial whose item is one of the 41 pairs ("slow-fast"), or any item
// of the instrument that is named: the person is the rater, the trial's target the
// motion, the value -2 to 2. Of a motion that came twice both ratings count, of
// a motion that was rated in several sessions the last; superseded, declined and
// untouched ones, practice, and people who declined or withdrew do not. The motions are
// those of `set`, or else of the set in the file. Stimuli (study/stimulus.h) are no mixtures of
// them and stay apart. Throws InputError when there are no ratings, when a value is outside, or
// when a motion is not in `set`.
DatabaseRatings read_database_ratings(const std::string& file, const RatingSelection& = {},
                                      const motion::MotionSet* set = nullptr);

// The same answers about stimuli alone, by their names; there may be none.
std::vector<NamedRating> read_stimulus_ratings(const std::string& file,
                                               const RatingSelection& selection);

}  // namespace promenade::study
