#include "analysis/ratings/rated_pairs.h"

#include <algorithm>
#include <map>
#include <set>

#include "analysis/item.h"
#include "motion/models/adjective_pairs.h"
#include "motion/problem.h"

namespace promenade::analysis {
namespace {

using Uuids = std::set<std::string>;

bool asks_pairs(const RatedMotion& one) {
  return std::any_of(one.items.begin(), one.items.end(), [](const std::string& name) {
    return motion::find_adjective_pair(name) >= 0;
  });
}

// Two people of different files may have one code.
std::string rater_name(int file, const std::string& code) {
  return std::to_string(file) + " " + code;
}

// Who rated pairs, and in which session of which file.
struct Raters {
  std::map<std::string, int> people;  // by rater_name: index into Dataset::people
  std::map<std::string, bool> is_simulated;
  std::map<int, Uuids> sessions;  // by file
};

Raters raters_of(const Log& log, const Selection& selection, const RatingQuality& rated) {
  Uuids with_pairs;
  for (const RatedMotion& one : rated.motions) {
    if (asks_pairs(one)) with_pairs.insert(one.session);
  }
  Raters raters;
  int person = -1;
  for (const Person& one : selection.people) {
    if (one.disposition != Disposition::analysed) continue;
    ++person;
    const LoggedSession& session = item(log.sessions, one.session);
    if (!with_pairs.contains(session.uuid)) continue;
    const std::string name = rater_name(session.file, session.code);
    raters.people[name] = person;
    raters.is_simulated[name] = session.simulated;
    raters.sessions[session.file].insert(session.uuid);
  }
  return raters;
}

// The motions of the files, in the order of the first; each once.
void add_motions(const std::vector<std::string>& more, std::vector<std::string>& motions) {
  for (const std::string& name : more) {
    if (std::find(motions.begin(), motions.end(), name) == motions.end()) motions.push_back(name);
  }
}

// The selection has decided about simulated and pilot sessions.
study::RatingSelection all_of(const Uuids& sessions) { return {true, true, "", sessions}; }

std::vector<StimulusRating> stimuli_of(const Log& log, const Raters& raters) {
  std::vector<study::NamedRating> all;
  for (const auto& [file, sessions] : raters.sessions) {
    const std::string& name = item(log.files, file).file;
    for (study::NamedRating& one : study::read_stimulus_ratings(name, all_of(sessions))) {
      one.rater = rater_name(file, one.rater);
      all.push_back(std::move(one));
    }
  }
  return stimulus_ratings(all);
}

study::RatingsTable table_of(const Log& log, const Raters& raters) {
  std::vector<study::NamedRating> all;
  std::vector<std::string> motions;
  bool simulated = false;
  for (const auto& [file, sessions] : raters.sessions) {
    const study::RatingsTable found =
        study::read_database_ratings(item(log.files, file).file, all_of(sessions)).table;
    for (const motion::Rating& one : found.ratings) {
      all.push_back({rater_name(file, item(found.rater_names, one.rater)),
                     item(found.motions, one.motion), item(found.pairs, one.pair), one.value});
    }
    add_motions(found.motions, motions);
    simulated = simulated || found.simulated;
  }
  study::RatingsTable table = study::make_ratings_table(all, motions);
  table.simulated = simulated;
  return table;
}

}  // namespace

std::optional<RatedPairs> rated_pairs(const Log& log, const Selection& selection,
                                      const RatingQuality& rated) {
  const Raters raters = raters_of(log, selection, rated);
  if (raters.people.empty()) return std::nullopt;
  RatedPairs result;
  try {
    result.stimuli = stimuli_of(log, raters);
    result.model = study::make_adjective_model(table_of(log, raters), log.study);
  } catch (const InputError& error) {
    result.problem = error.problems().front().message;
    return result;
  }
  result.statistics = rating_statistics(result.model.table);
  for (const std::string& name : result.model.table.rater_names) {
    result.people.push_back(raters.people.at(name));
    result.simulated += raters.is_simulated.at(name) ? 1 : 0;
  }
  return result;
}

}  // namespace promenade::analysis
