#include "analysis/map_time.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <numeric>

#include "analysis/item.h"
#include "study/migrate.h"
#include "study/sqlite.h"
#include "study/study.h"

namespace promenade::analysis {
namespace {

using Groups = std::map<std::pair<int, int>, MapTime>;  // by task and interface

constexpr const char* set_query =
    "SELECT motion_set.sha256 FROM session JOIN study ON study.uuid = session.study "
    "JOIN motion_set ON motion_set.uuid = coalesce(study.motion_set, motion_set.uuid) "
    "WHERE session.uuid = ? LIMIT 1";

// The motions that one file of the log showed, and the samples of its trials.
class Reader {
 public:
  Reader(const std::string& file, const study::StudyBundle& bundle)
      : bundle_(bundle),
        database_(study::open_log(file)),
        set_(database_, set_query),
        samples_(database_,
                 "SELECT t_us, weights FROM sample WHERE trial = ? ORDER BY t_us, rowid"),
        weights_(bundle.space.set.size()) {}

  bool has_same_set(const std::string& session) {
    if (session != session_) {
      session_ = session;
      set_.reset();
      same_ = set_.bind(1, session).step() && set_.text(0) == bundle_.set_sha256;
    }
    return same_;
  }

  std::vector<Shown> shown_in(const LoggedTrial& trial) {
    std::vector<Shown> shown;
    const auto bytes = static_cast<std::size_t>(weights_.size()) * sizeof(double);
    samples_.reset();
    samples_.bind(1, trial.uuid);
    while (samples_.step()) {
      const std::string_view blob = samples_.blob(1);
      if (blob.size() != bytes) continue;
      std::memcpy(weights_.data(), blob.data(), bytes);
      const int cell = weights_.allFinite() ? bundle_.coverage.cell_of(weights_) : -1;
      shown.push_back({std::max(samples_.integer(0), trial.started_us), cell});
    }
    return shown;
  }

 private:
  const study::StudyBundle& bundle_;
  study::Database database_;
  study::Statement set_, samples_;
  Eigen::VectorXd weights_;
  std::string session_;
  bool same_ = false;
};

void add_trial(Reader& reader, const Log& log, const Trial& trial, Groups& groups,
               MapTimes& result) {
  const LoggedTrial& logged = item(log.trials, trial.logged);
  if (trial.quality.paused || trial.quality.interrupted) {
    ++result.paused;
  } else if (!reader.has_same_set(item(log.sessions, logged.session).uuid)) {
    ++result.other_set;
  } else {
    const std::vector<Shown> shown = reader.shown_in(logged);
    add_time(shown, logged.ended_us.value_or(logged.started_us),
             groups[{trial.task, trial.interface}]);
  }
}

void read_trials(const Log& log, const Dataset& data, const study::StudyBundle& bundle,
                 MapTimes& result) {
  Groups groups;
  for (int file = 0; file < size_of(log.files); ++file) {
    Reader reader(item(log.files, file).file, bundle);
    for (const Trial& trial : data.trials) {
      const LoggedTrial& logged = item(log.trials, trial.logged);
      if (item(log.sessions, logged.session).file != file) continue;
      add_trial(reader, log, trial, groups, result);
    }
  }
  for (auto& [place, time] : groups) {
    time.task = place.first;
    time.interface = place.second;
    if (time.total_s() > 0) result.times.push_back(time);
  }
}

}  // namespace

double MapTime::total_s() const {
  return std::accumulate(seconds.begin(), seconds.end(), outside_s);
}

void add_time(const std::vector<Shown>& shown, std::int64_t ended_us, MapTime& time) {
  if (shown.empty()) return;
  ++time.trials;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const std::int64_t until = i + 1 < shown.size() ? shown[i + 1].t_us : ended_us;
    const double lasted =
        1e-6 * static_cast<double>(std::max<std::int64_t>(until - shown[i].t_us, 0));
    (shown[i].cell < 0 ? time.outside_s : item(time.seconds, shown[i].cell)) += lasted;
  }
}

MapTimes map_times(const Log& log, const Dataset& data, const study::StudyBundle* stored) {
  MapTimes result;
  if (!stored) {
    result.missing =
        "Where on the map people spent their time, and how alike the motions are, is not drawn: "
        "this program cannot read the stored study.";
    return result;
  }
  result.map = stored->coverage;
  result.names = motion::names_of(stored->space.set);
  result.tree = motion::ward(stored->space.offsets.topRows(stored->space.shape_rows()));
  read_trials(log, data, *stored, result);
  return result;
}

}  // namespace promenade::analysis
