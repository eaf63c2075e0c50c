#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <set>
#include <tuple>

#include "motion/did_you_mean.h"
#include "motion/models/adjective_pairs.h"
#include "motion/problem.h"
#include "motion/set_file.h"
#include "study/migrate.h"
#include "study/outline.h"
#include "study/ratings.h"
#include "study/sqlite.h"

namespace promenade::study {
namespace {

constexpr double most = 2;  // of a five-point scale from -2 to 2

constexpr const char* answer_query =
    "SELECT participant.code, trial.target, answer.item, answer.value, answer.instrument, "
    "session.simulated, session.pilot, trial.uuid, session.uuid "
    "FROM answer JOIN trial ON trial.uuid = answer.trial "
    "JOIN session ON session.uuid = answer.session "
    "JOIN participant ON participant.uuid = session.participant "
    "WHERE answer.value IS NOT NULL AND answer.declined = 0 AND answer.touched = 1 "
    "AND trial.practice = 0 AND trial.superseded = 0 AND session.outcome NOT IN ('declined', "
    "'withdrawn') "
    "ORDER BY session.started_utc, session.uuid, answer.t_us";

// Of one person, motion and pair. Who rates a motion again, in another session, has another word
// in it; within a session the motion came twice, and both count.
struct Ratings {
  std::string session;
  std::map<std::string, double> by_trial;  // uuid
};

struct Found {
  std::map<std::tuple<std::string, std::string, std::string>, Ratings> last;  // rater, motion, pair
  bool simulated = false;
  int left_out = 0;  // of simulated or pilot sessions
  std::vector<Problem> problems;
};

Found read_answers(Database& database, const RatingSelection& selection) {
  Found found;
  Statement row(database, answer_query);
  while (row.step()) {
    const std::string pair = row.text(2);
    const bool wanted = selection.instrument.empty() ? motion::find_adjective_pair(pair) >= 0
                                                     : row.text(4) == selection.instrument;
    if (!wanted || (selection.sessions && !selection.sessions->contains(row.text(8)))) continue;
    const bool simulated = row.integer(5) != 0;
    if ((simulated && !selection.include_simulated) ||
        (row.integer(6) != 0 && !selection.include_pilot)) {
      ++found.left_out;
      continue;
    }
    const double value = row.real(3);
    if (!(value >= -most && value <= most)) {
      found.problems.push_back(
          {database.file(), 0, 0,
           fmt::format(R"(the answer {} to "{}" about "{}" is not from -2 to 2)", value, pair,
                       row.text(1)),
           Severity::error});
    }
    found.simulated = found.simulated || simulated;
    Ratings& ratings = found.last[{row.text(0), row.text(1), pair}];
    if (ratings.session != row.text(8)) ratings = {row.text(8), {}};
    ratings.by_trial[row.text(7)] = value;
  }
  return found;
}

std::optional<motion::MotionSet> set_in(Database& database) {
  Statement row(database, "SELECT content FROM motion_set ORDER BY rowid DESC LIMIT 1");
  if (!row.step()) return std::nullopt;
  return motion::from_bytes(row.blob(0), database.file());
}

// Motions that were rated but are not in the set.
std::vector<std::string> strangers(const motion::MotionSet& set,
                                   const std::vector<NamedRating>& ratings) {
  std::set<std::string> names;
  for (const NamedRating& rating : ratings) {
    if (motion::find_cycle(set, rating.motion) < 0) names.insert(rating.motion);
  }
  return {names.begin(), names.end()};
}

// Of all versions of the study.
std::set<std::string> stimuli_in(Database& database) {
  std::set<std::string> names;
  Statement row(database, "SELECT config_text FROM study");
  while (row.step()) {
    for (std::string& name : outline_of(row.text(0)).stimuli) names.insert(std::move(name));
  }
  return names;
}

// Those that were rated.
std::vector<std::string> leave_out(const std::set<std::string>& stimuli, Found& found) {
  std::set<std::string> rated;
  std::erase_if(found.last, [&](const auto& one) {
    const std::string& motion = std::get<1>(one.first);
    if (stimuli.contains(motion)) rated.insert(motion);
    return stimuli.contains(motion);
  });
  return {rated.begin(), rated.end()};
}

std::vector<NamedRating> named_ratings(const Found& found) {
  std::vector<NamedRating> ratings;
  for (const auto& [key, given] : found.last) {
    for (const auto& [trial, value] : given.by_trial) {
      ratings.push_back({std::get<0>(key), std::get<1>(key), std::get<2>(key), value});
    }
  }
  return ratings;
}

[[noreturn]] void report_none(const std::string& file, const Found& found,
                              const std::vector<std::string>& stimuli) {
  if (!stimuli.empty()) {
    throw InputError(file, "holds ratings of stimuli alone (" + quoted_list(stimuli) +
                               "), and of no motion of a set");
  }
  if (found.left_out > 0) {
    throw InputError(file, fmt::format("its {} ratings are of simulated or pilot sessions; they "
                                       "count with --include-simulated or --include-pilot",
                                       found.left_out));
  }
  throw InputError(file,
                   "holds no ratings: no trial has answers whose items are pairs of adjectives, "
                   "\"slow-fast\" and so on");
}

}  // namespace

DatabaseRatings read_database_ratings(const std::string& file, const RatingSelection& selection,
                                      const motion::MotionSet* set) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) throw InputError(file, "is no file");
  Database database = open_log(file);
  Found found = read_answers(database, selection);
  DatabaseRatings result;
  result.stimuli = leave_out(stimuli_in(database), found);
  if (found.problems.empty() && found.last.empty()) report_none(file, found, result.stimuli);
  const std::vector<NamedRating> ratings = named_ratings(found);
  result.set = set ? std::optional(*set) : set_in(database);
  const auto unknown = result.set ? strangers(*result.set, ratings) : std::vector<std::string>();
  for (const std::string& name : unknown) {
    if (!set) result.set.reset();
    if (!set) break;
    found.problems.push_back(
        {file, 0, 0,
         fmt::format("rates the motion \"{}\", which is not in the set {}", name, set->name),
         Severity::error});
  }
  if (!found.problems.empty()) throw InputError(found.problems);
  result.table =
      make_ratings_table(ratings, result.set ? names_of(*result.set) : std::vector<std::string>());
  result.table.simulated = found.simulated;
  return result;
}

std::vector<NamedRating> read_stimulus_ratings(const std::string& file,
                                               const RatingSelection& selection) {
  Database database = open_log(file);
  Found found = read_answers(database, selection);
  if (!found.problems.empty()) throw InputError(found.problems);
  const std::set<std::string> stimuli = stimuli_in(database);
  std::erase_if(found.last,
                [&](const auto& one) { return !stimuli.contains(std::get<1>(one.first)); });
  return named_ratings(found);
}

}  // namespace promenade::study
