#include "analysis/map_time.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "analysis/item.h"
#include "analysis/samples.h"
#include "study/study.h"

namespace promenade::analysis {
namespace {

using Groups = std::map<std::pair<int, int>, MapTime>;  // by task and interface

std::vector<Shown> shown_in(SampleReader& reader, const LoggedTrial& trial,
                            const study::CoverageMap& map) {
  std::vector<Shown> shown;
  reader.each(trial.uuid, [&](std::int64_t t_us, const Eigen::VectorXd& weights) {
    const int cell = weights.allFinite() ? map.cell_of(weights) : -1;
    shown.push_back({std::max(t_us, trial.started_us), cell});
  });
  return shown;
}

void add_trial(SampleReader& reader, const Log& log, const Trial& trial, Groups& groups,
               MapTimes& result) {
  const LoggedTrial& logged = item(log.trials, trial.logged);
  if (trial.quality.paused || trial.quality.interrupted) {
    ++result.paused;
  } else if (!reader.has_same_set(item(log.sessions, logged.session).uuid)) {
    ++result.other_set;
  } else {
    const std::vector<Shown> shown = shown_in(reader, logged, result.map);
    add_time(shown, logged.ended_us.value_or(logged.started_us),
             groups[{trial.task, trial.interface}]);
  }
}

void read_trials(const Log& log, const Dataset& data, const study::StudyBundle& bundle,
                 MapTimes& result) {
  Groups groups;
  for_each_trial(log, data, bundle, [&](SampleReader& reader, int trial) {
    add_trial(reader, log, item(data.trials, trial), groups, result);
  });
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
