#include "analysis/dataset.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "analysis/item.h"
#include "analysis/natural_order.h"
#include "study/outline.h"

namespace promenade::analysis {
namespace {

// The measures that every trial has: where they come from and how they read.
struct Column {
  Measure measure;
  std::optional<double> (*value)(const LoggedTrial& trial);
};

// Without pauses, restricted to the limit. A failure counts with the time at which it ended,
// which is the limit for a timeout (docs/methods.md, 6).
std::optional<double> time_of(const LoggedTrial& trial) {
  if (!trial.ended_us) return std::nullopt;
  const std::int64_t worked_us = *trial.ended_us - trial.started_us - trial.paused_us;
  const double seconds = static_cast<double>(worked_us) / 1e6;
  return trial.limit_s ? std::min(seconds, *trial.limit_s) : seconds;
}

const std::vector<Column>& columns() {
  using T = LoggedTrial;
  static const std::vector<Column> all = {
      {{"d_first", "D at the start", "m", "cm", 100, 1}, [](const T& t) { return t.d_first; }},
      {{"d_best", "best D shown", "m", "cm", 100, 1}, [](const T& t) { return t.d_best; }},
      {{"d_final", "final D", "m", "cm", 100, 1}, [](const T& t) { return t.d_final; }},
      {{"time_s", "time", "s", "s", 1, 1}, time_of},
      {{"clicks", "mouse clicks", "", "", 1, 1}, [](const T& t) { return t.clicks; }},
      {{"changes", "changes of controls", "", "", 1, 1}, [](const T& t) { return t.changes; }},
  };
  return all;
}

// How the columns of the process read, in the order of process_columns().
const std::vector<Measure>& process_measures() {
  constexpr auto kind = MeasureKind::process;
  static const std::vector<Measure> all = {
      {"seconds_difference", "difference in duration of the walk", "s", "s", 1, 2, kind},
      {"first_below_us", "time until D was first below the threshold", "us", "s", 1e-6, 1, kind},
      {"d_area_m_s", "area under D", "m s", "m s", 1, 2, kind},
      {"path_m", "way travelled in D", "m", "m", 1, 2, kind},
      {"reversals", "reversals", "", "", 1, 1, kind},
      {"drags", "drags", "", "", 1, 1, kind},
      {"controls_touched", "controls touched", "", "", 1, 1, kind},
      {"examples_visited", "examples visited", "", "", 1, 1, kind},
      {"map_coverage", "share of the map seen", "", "%", 100, 0, kind},
      {"idle_us", "idle time", "us", "s", 1e-6, 1, kind},
      {"camera_moves", "moves of the camera", "", "", 1, 1, kind},
  };
  return all;
}

// Is it a column of tables/trials.csv that is no rating?
bool is_trial_column(const std::string& name) {
  static constexpr std::array<std::string_view, 13> about = {
      "participant", "session",       "trial",
      "station",     "study_version", "block",
      "position",    "interface",     "previous_interface",
      "task",        "target",        "outcome",
      "failed"};
  const auto has_name = [&](const auto& column) { return column.measure.name == name; };
  const auto& process = process_columns();
  return std::find(about.begin(), about.end(), name) != about.end() ||
         std::any_of(columns().begin(), columns().end(), has_name) ||
         std::find(process.begin(), process.end(), name) != process.end();
}

constexpr std::int64_t coarse_time_us = 50'000;

TrialQuality quality_of(const LoggedTrial& trial) {
  TrialQuality quality;
  quality.late_frames = static_cast<int>(trial.late_frames.value_or(0));
  quality.uncertainty_ms = static_cast<double>(trial.uncertainty_us) / 1000;
  quality.interrupted = trial.interruptions > 0;
  quality.paused = trial.paused_us > 0;
  const double seconds =
      static_cast<double>(trial.ended_us.value_or(trial.started_us) - trial.started_us) / 1e6;
  quality.slow_frames = quality.late_frames > std::max(1.0, seconds);
  quality.coarse_time = trial.uncertainty_us >= coarse_time_us;
  return quality;
}

bool has_ended(const LoggedTrial& trial) {
  return trial.outcome == "success" || trial.outcome == "timeout" || trial.outcome == "done";
}

bool has_failed(const LoggedTrial& trial) {
  if (trial.outcome == "timeout") return true;
  return trial.outcome == "done" && trial.threshold_m && trial.d_final &&
         *trial.d_final > *trial.threshold_m;
}

// The names that occur, the known ones first and in their order.
std::vector<std::string> in_order(const std::set<std::string>& occurring,
                                  const std::vector<std::string>& known) {
  std::vector<std::string> names;
  for (const std::string& name : known) {
    if (occurring.count(name) > 0) names.push_back(name);
  }
  std::vector<std::string> rest;
  for (const std::string& name : occurring) {
    if (std::find(known.begin(), known.end(), name) == known.end()) rest.push_back(name);
  }
  std::sort(rest.begin(), rest.end(), natural_less);
  names.insert(names.end(), rest.begin(), rest.end());
  return names;
}

int index_in(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}

class Builder {
 public:
  Builder(const Log& log, const Selection& selection)
      : log_(log), outline_(study::outline_of(log.config_text)) {
    person_of_session_.assign(log.sessions.size(), -1);
    int simulated = 0;
    for (const Person& person : selection.people) {
      if (person.disposition != Disposition::analysed) continue;
      item(person_of_session_, person.session) = size_of(data_.people);
      data_.people.push_back(person.code);
      simulated += person.simulated ? 1 : 0;
    }
    data_.all_simulated = simulated > 0 && simulated == size_of(data_.people);
  }

  Dataset build() {
    collect_trials();
    name_conditions();
    name_measures();
    for (const int index : taken_) data_.trials.push_back(trial_of(index));
    put_answers();
    name_previous();
    return std::move(data_);
  }

 private:
  const LoggedTrial& logged(int index) const { return item(log_.trials, index); }
  int person_of(const LoggedTrial& trial) const { return item(person_of_session_, trial.session); }

  void collect_trials() {
    trial_of_logged_.assign(log_.trials.size(), -1);
    for (std::size_t i = 0; i < log_.trials.size(); ++i) {
      const LoggedTrial& trial = log_.trials[i];
      if (person_of(trial) < 0) continue;
      if (!has_ended(trial)) {
        ++data_.left_out_trials;
        continue;
      }
      trial_of_logged_[i] = size_of(taken_);
      taken_.push_back(static_cast<int>(i));
    }
  }

  void name_conditions() {
    std::set<std::string> interfaces;
    std::map<std::string, std::set<std::string>> targets;
    std::set<std::string> tasks;
    for (const int index : taken_) {
      interfaces.insert(logged(index).interface);
      tasks.insert(logged(index).task);
      targets[logged(index).task].insert(logged(index).target);
    }
    data_.order = outline_.order;
    data_.interfaces = in_order(interfaces, outline_.interfaces);
    task_names_ = in_order(tasks, outline_.tasks);
    for (const std::string& name : task_names_) {
      data_.tasks.push_back({name, in_order(targets[name], outline_.targets),
                             common(name, &LoggedTrial::limit_s),
                             common(name, &LoggedTrial::threshold_m), is_guess(name)});
    }
  }

  bool is_guess(const std::string& task) const {
    const auto& guesses = outline_.guesses;
    return std::find(guesses.begin(), guesses.end(), task) != guesses.end();
  }

  // The value that all trials of a task share.
  std::optional<double> common(const std::string& task,
                               std::optional<double> LoggedTrial::*member) const {
    std::optional<double> shared;
    bool first = true;
    for (const int index : taken_) {
      if (logged(index).task != task) continue;
      if (!first && logged(index).*member != shared) return std::nullopt;
      shared = logged(index).*member;
      first = false;
    }
    return shared;
  }

  void name_measures() {
    std::set<std::string> items;
    for (const LoggedAnswer& answer : log_.answers) {
      if (item(trial_of_logged_, answer.trial) >= 0) items.insert(answer.item);
    }
    items_ = in_order(items, outline_.ratings);
    data_.measures = measures_with(items_);
  }

  Trial trial_of(int index) const {
    const LoggedTrial& from = logged(index);
    Trial trial;
    trial.person = person_of(from);
    trial.interface = index_in(data_.interfaces, from.interface);
    trial.task = index_in(task_names_, from.task);
    trial.target = index_in(item(data_.tasks, trial.task).targets, from.target);
    trial.logged = index;
    trial.position = from.position;
    trial.block = from.block;
    trial.quality = quality_of(from);
    trial.outcome = from.outcome;
    trial.failed = has_failed(from);
    for (const Column& column : columns()) trial.values.push_back(column.value(from));
    trial.values.resize(trial.values.size() + items_.size());
    for (int i = 0; i < size_of(process_columns()); ++i) {
      const bool since_session = item(process_columns(), i) == "first_below_us";
      std::optional<double> value = item(from.process, i);
      if (value && since_session) *value -= static_cast<double>(from.started_us);
      trial.values.push_back(value);
    }
    return trial;
  }

  // The last answer to an item counts: people may change their mind.
  void put_answers() {
    for (const LoggedAnswer& answer : log_.answers) {
      const int trial = item(trial_of_logged_, answer.trial);
      if (trial < 0) continue;
      const auto column =
          columns().size() + static_cast<std::size_t>(index_in(items_, answer.item));
      item(data_.trials, trial).values[column] = answer.value;
    }
  }

  // Also of trials that do not count: they were worked on all the same.
  void name_previous() {
    std::size_t next = 0;
    const LoggedTrial* before = nullptr;
    std::string now, previous;
    for (std::size_t i = 0; i < log_.trials.size() && next < data_.trials.size(); ++i) {
      const LoggedTrial& trial = log_.trials[i];
      if (!before || trial.session != before->session) {
        now = trial.interface;
        previous.clear();
      } else if (trial.interface != now) {
        previous = now;
        now = trial.interface;
      }
      before = &trial;
      if (trial_of_logged_[i] < 0) continue;
      const int index = index_in(data_.interfaces, previous);
      data_.trials[next++].previous_interface = index < size_of(data_.interfaces) ? index : -1;
    }
  }

  const Log& log_;
  study::Outline outline_;
  Dataset data_;
  std::vector<int> person_of_session_;
  std::vector<int> taken_;            // indices of logged trials
  std::vector<int> trial_of_logged_;  // back from there; -1: not taken
  std::vector<std::string> task_names_, items_;
};

}  // namespace

int Dataset::measure(std::string_view name) const {
  for (std::size_t i = 0; i < measures.size(); ++i) {
    if (measures[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

std::vector<Measure> measures_with(const std::vector<std::string>& rating_items) {
  std::vector<Measure> measures;
  for (const Column& column : columns()) measures.push_back(column.measure);
  for (const std::string& name : rating_items) {
    const bool taken = is_trial_column(name);
    measures.push_back({taken ? "answer." + name : name, name, "", "", 1, 1, MeasureKind::rating});
  }
  const auto& process = process_measures();
  measures.insert(measures.end(), process.begin(), process.end());
  return measures;
}

bool Dataset::occurs(int measure, int task) const {
  return std::any_of(trials.begin(), trials.end(), [&](const Trial& trial) {
    return trial.task == task && item(trial.values, measure).has_value();
  });
}

Dataset make_dataset(const Log& log, const Selection& selection) {
  return Builder(log, selection).build();
}

std::vector<double> present(const std::vector<std::optional<double>>& values) {
  std::vector<double> result;
  for (const auto& value : values) {
    if (value) result.push_back(*value);
  }
  return result;
}

std::vector<std::optional<double>> mean_per_person(const Dataset& data, int measure, int interface,
                                                   int task, int target) {
  std::vector<double> sum(data.people.size(), 0.0);
  std::vector<int> count(data.people.size(), 0);
  for (const Trial& trial : data.trials) {
    const std::optional<double>& value = item(trial.values, measure);
    if (trial.interface != interface || trial.task != task || !value) continue;
    if (target >= 0 && trial.target != target) continue;
    item(sum, trial.person) += *value;
    ++item(count, trial.person);
  }
  std::vector<std::optional<double>> means(data.people.size());
  for (std::size_t i = 0; i < means.size(); ++i) {
    if (count[i] > 0) means[i] = sum[i] / count[i];
  }
  return means;
}

}  // namespace promenade::analysis
