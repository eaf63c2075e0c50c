#include "analysis/rating_quality.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "analysis/item.h"
#include "study/migrate.h"
#include "study/sqlite.h"

namespace promenade::analysis {
namespace {

using study::Statement;

// Choices have their name beside their place: they are no scale.
constexpr const char* answer_query =
    "SELECT trial.uuid, trial.position, trial.task, trial.target, answer.instrument, answer.item, "
    "answer.value, answer.t_us FROM answer JOIN trial ON trial.uuid = answer.trial "
    "WHERE trial.session = ? AND trial.practice = 0 AND trial.superseded = 0 AND "
    "trial.interface = '' AND answer.touched = 1 AND answer.declined = 0 AND "
    "answer.value IS NOT NULL AND coalesce(answer.text, '') = '' "
    "ORDER BY trial.position, trial.uuid, answer.instrument, answer.place, answer.rowid";

// Two answers to one item about one motion.
struct Twice {
  double first = 0, second = 0;
};

std::vector<Twice> common_answers(const RatedMotion& first, const RatedMotion& second) {
  std::vector<Twice> common;
  for (int i = 0; i < size_of(first.items); ++i) {
    const auto found = std::find(second.items.begin(), second.items.end(), item(first.items, i));
    if (found == second.items.end()) continue;
    const auto j = static_cast<int>(found - second.items.begin());
    common.push_back({item(first.answers, i).value, item(second.answers, j).value});
  }
  return common;
}

std::optional<double> correlation_of(const std::vector<Twice>& all) {
  double mean_first = 0;
  double mean_second = 0;
  for (const Twice& one : all) {
    mean_first += one.first / static_cast<double>(all.size());
    mean_second += one.second / static_cast<double>(all.size());
  }
  double both = 0;
  double first = 0;
  double second = 0;
  for (const Twice& one : all) {
    both += (one.first - mean_first) * (one.second - mean_second);
    first += (one.first - mean_first) * (one.first - mean_first);
    second += (one.second - mean_second) * (one.second - mean_second);
  }
  if (!(first > 0) || !(second > 0)) return std::nullopt;
  return both / std::sqrt(first * second);
}

void compare(const std::vector<Twice>& all, RaterQuality& rater) {
  rater.compared = size_of(all);
  if (all.empty()) return;
  double difference = 0;
  double near = 0;
  for (const Twice& one : all) {
    difference += std::abs(one.first - one.second);
    near += std::abs(one.first - one.second) <= 1 ? 1 : 0;
  }
  rater.mean_difference = difference / static_cast<double>(all.size());
  rater.within_one = near / static_cast<double>(all.size());
  rater.correlation = correlation_of(all);
}

RaterQuality rater_of(const std::vector<RatedMotion>& motions, std::size_t from, std::size_t to) {
  RaterQuality rater;
  rater.person = motions[from].person;
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> first;
  std::vector<Twice> twice;
  for (std::size_t i = from; i < to; ++i) {
    const RatedMotion& one = motions[i];
    ++rater.motions;
    rater.straight += one.pattern.straight ? 1 : 0;
    rater.fast += one.pattern.fast ? 1 : 0;
    rater.flagged += one.pattern.flagged() ? 1 : 0;
    const auto [known, is_new] = first.emplace(std::tuple(one.task, one.target, one.instrument), i);
    if (is_new) continue;
    ++rater.repeated;
    for (const Twice& both : common_answers(motions[known->second], one)) twice.push_back(both);
  }
  compare(twice, rater);
  return rater;
}

void read_session(Statement& row, const std::string& session, int person,
                  std::vector<RatedMotion>& motions) {
  row.bind(1, session);
  while (row.step()) {
    const bool goes_on = !motions.empty() && motions.back().trial == row.text(0) &&
                         motions.back().instrument == row.text(4);
    if (!goes_on) {
      motions.push_back({person,
                         session,
                         row.text(0),
                         static_cast<int>(row.integer(1)),
                         row.text(2),
                         row.text(3),
                         row.text(4),
                         {},
                         {},
                         {}});
    }
    motions.back().items.push_back(row.text(5));
    motions.back().answers.push_back({row.real(6), row.integer(7)});
  }
  row.reset();
}

}  // namespace

RatingQuality rating_quality(std::vector<RatedMotion> motions) {
  for (RatedMotion& one : motions) one.pattern = study::answer_pattern(one.answers);
  RatingQuality quality;
  for (std::size_t from = 0; from < motions.size();) {
    std::size_t to = from;
    while (to < motions.size() && motions[to].person == motions[from].person) ++to;
    quality.raters.push_back(rater_of(motions, from, to));
    from = to;
  }
  quality.motions = std::move(motions);
  return quality;
}

std::vector<RatedMotion> read_rated_motions(const Log& log, const Selection& selection) {
  std::vector<RatedMotion> motions;
  for (int file = 0; file < size_of(log.files); ++file) {
    const std::string& name = item(log.files, file).file;
    try {
      study::Database database = study::open_log(name);
      Statement row(database, answer_query);
      int person = -1;
      for (const Person& one : selection.people) {
        if (one.disposition != Disposition::analysed) continue;
        ++person;
        const LoggedSession& session = item(log.sessions, one.session);
        if (session.file == file) read_session(row, session.uuid, person, motions);
      }
    } catch (const study::DatabaseError& error) {
      refuse_content(name, error);
    }
  }
  std::stable_sort(motions.begin(), motions.end(),
                   [](const auto& a, const auto& b) { return a.person < b.person; });
  return motions;
}

}  // namespace promenade::analysis
