// Is what is stored what the events lead to?
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/replay.h"

namespace promenade::study {
namespace {

constexpr double tolerance = 1e-9;
constexpr double smallest = 1e-12;
constexpr std::size_t most_differences = 100;  // of one session

// What the replay gave, by trial as they began.
struct Played {
  struct Trial {
    int index = 0;  // into Plan::trials
    int attempt = 1;
    bool superseded = false;
    std::optional<double> d_first;
    std::vector<Sample> samples;
    std::optional<TrialEnded> ended;
  };
  std::vector<Trial> trials;
  std::vector<Event> events;
  std::vector<Answer> answers;

  void take(const std::vector<Record>& records) {
    for (const Record& record : records) {
      if (const auto* started = std::get_if<TrialStarted>(&record)) {
        trials.push_back({started->trial, started->attempt, false, started->d_first, {}, {}});
      } else if (const auto* answer = std::get_if<Answer>(&record)) {
        answers.push_back(*answer);
      } else if (const auto* old = std::get_if<TrialSuperseded>(&record)) {
        for (Trial& trial : trials) trial.superseded |= trial.index == old->trial;
      } else if (const auto* sample = std::get_if<Sample>(&record)) {
        trials.back().samples.push_back(*sample);
      } else if (const auto* ended = std::get_if<TrialEnded>(&record)) {
        trials.back().ended = *ended;
      } else if (const auto* event = std::get_if<Event>(&record)) {
        events.push_back(*event);
      }
    }
  }
};

class Comparison {
 public:
  Comparison(const LoggedSession& log, Audit& audit)
      : log_(log), audit_(audit), before_(audit.differences.size()) {}

  void at(int trial, std::int64_t t_us) {
    trial_ = trial;
    t_us_ = t_us;
  }

  void number(const std::string& what, double stored, double replayed) {
    ++audit_.numbers;
    const double size = std::max({std::abs(stored), std::abs(replayed), smallest / tolerance});
    const double difference = std::abs(stored - replayed) / size;
    if (difference <= tolerance) {
      audit_.largest = std::max(audit_.largest, difference);
      return;
    }
    // Also what is not finite.
    if (std::isfinite(difference)) audit_.largest = std::max(audit_.largest, difference);
    add(what, fmt::format("{}", stored), fmt::format("{}", replayed));
  }

  template <typename Value>
  void number(const std::string& what, const std::optional<Value>& stored,
              const std::optional<Value>& replayed) {
    if (stored && replayed) {
      return number(what, static_cast<double>(*stored), static_cast<double>(*replayed));
    }
    if (stored.has_value() == replayed.has_value()) return;
    add(what, stored ? fmt::format("{}", *stored) : "nothing",
        replayed ? fmt::format("{}", *replayed) : "nothing");
  }

  void text(const std::string& what, std::string_view stored, std::string_view replayed) {
    if (stored != replayed) add(what, std::string(stored), std::string(replayed));
  }

 private:
  void add(const std::string& what, std::string stored, std::string replayed) {
    if (audit_.differences.size() - before_ >= most_differences) return;
    audit_.differences.push_back(
        {log_.uuid, trial_, t_us_, what, std::move(stored), std::move(replayed)});
  }

  const LoggedSession& log_;
  Audit& audit_;
  std::size_t before_;
  int trial_ = -1;
  std::int64_t t_us_ = 0;
};

void compare_samples(const std::vector<const Sample*>& stored, const std::vector<Sample>& played,
                     int trial, Comparison& compare) {
  compare.at(trial, 0);
  compare.text("number of samples", std::to_string(stored.size()), std::to_string(played.size()));
  for (std::size_t i = 0; i < std::min(stored.size(), played.size()); ++i) {
    const Sample& one = *stored[i];
    compare.at(trial, one.t_us);
    compare.text("t_us of a sample", std::to_string(one.t_us), std::to_string(played[i].t_us));
    compare.number("d", one.d, played[i].d);
    const bool alike = one.weights.size() == played[i].weights.size();
    if (!alike) compare.text("weights", "of another number", "than the motions");
    for (Eigen::Index k = 0; alike && k < one.weights.size(); ++k) {
      compare.number(fmt::format("weight {}", k), one.weights(k), played[i].weights(k));
    }
  }
}

void compare_ends(const LoggedTrial& stored, const std::optional<TrialEnded>& played, int trial,
                  Comparison& compare) {
  compare.at(trial, stored.started_us);
  compare.text("outcome", stored.outcome, played ? to_text(played->outcome) : "");
  if (!played || stored.outcome.empty()) return;
  const TrialEnded& a = stored.ended;
  const TrialEnded& b = *played;
  const auto count = [&compare](const char* what, std::int64_t one, std::int64_t other) {
    compare.text(what, std::to_string(one), std::to_string(other));
  };
  count("ended_us", a.t_us, b.t_us);
  compare.number("d_best", a.d_best, b.d_best);
  compare.number("d_final", a.d_final, b.d_final);
  compare.number("d_sum", a.d_sum, b.d_sum);
  compare.number("seconds_difference", a.seconds_difference, b.seconds_difference);
  compare.number("first_below_us", a.first_below_us, b.first_below_us);
  count("paused_us", a.paused_us, b.paused_us);
  count("clicks", a.clicks, b.clicks);
  count("changes", a.changes, b.changes);
  count("late_frames", a.late_frames, b.late_frames);
  const ProcessMeasures& p = a.process;
  const ProcessMeasures& q = b.process;
  compare.number("d_area_m_s", p.d_area_m_s, q.d_area_m_s);
  compare.number("path_m", p.path_m, q.path_m);
  compare.number("map_coverage", p.map_coverage, q.map_coverage);
  count("reversals", p.reversals, q.reversals);
  count("drags", p.drags, q.drags);
  count("controls_touched", p.controls_touched, q.controls_touched);
  count("examples_visited", p.examples_visited, q.examples_visited);
  count("idle_us", p.idle_us, q.idle_us);
  count("camera_moves", p.camera_moves, q.camera_moves);
}

void compare_identity(const LoggedTrial& stored, const Played::Trial& played, const Study& study,
                      const Plan& plan, Comparison& compare) {
  const PlannedTrial& planned = plan.trials[static_cast<std::size_t>(played.index)];
  compare.text("position", std::to_string(stored.position), std::to_string(planned.position));
  compare.text("attempt", std::to_string(stored.attempt), std::to_string(played.attempt));
  compare.text("superseded", stored.superseded ? "1" : "0", played.superseded ? "1" : "0");
  compare.text("task", stored.task, task_of(study, planned).name);
  compare.text("target", stored.target, target_of(study, planned).name);
  if (planned.interface < 0) return;
  compare.text("interface", stored.interface,
               study.interfaces[static_cast<std::size_t>(planned.interface)].name);
}

void compare_answers(const std::vector<Answer>& stored, const std::vector<Answer>& played,
                     Comparison& compare) {
  compare.at(-1, 0);
  compare.text("number of answers", std::to_string(stored.size()), std::to_string(played.size()));
  for (std::size_t i = 0; i < std::min(stored.size(), played.size()); ++i) {
    const Answer& a = stored[i];
    const Answer& b = played[i];
    compare.at(-1, a.t_us);
    compare.text("item", a.instrument + "/" + a.item, b.instrument + "/" + b.item);
    compare.number("answer", a.value, b.value);
    compare.text("answer's text", a.text, b.text);
    compare.text("declined", a.declined ? "1" : "0", b.declined ? "1" : "0");
    compare.text("touched", a.touched ? "1" : "0", b.touched ? "1" : "0");
  }
}

// Of the start of a trial: which walk through a motion graph was shown; empty: none.
std::string_view stimulus_in(std::string_view detail) {
  return detail.starts_with(R"({"stimulus")") ? detail : std::string_view();
}

void compare_events(const LoggedSession& log, const std::vector<Event>& played,
                    Comparison& compare) {
  std::size_t i = 0;
  for (const LoggedStep& step : log.steps) {
    if (step.sample) continue;
    const Event* event = i < played.size() ? &played[i] : nullptr;
    ++i;
    compare.at(step.trial, step.event.t_us);
    compare.text("event", step.event.kind, event ? std::string_view(event->kind) : "nothing");
    if (event == nullptr || event->kind != step.event.kind) return;  // all behind is shifted
    if (step.event.kind == "start") {
      compare.text("what was shown", stimulus_in(step.event.detail), stimulus_in(event->detail));
    }
    compare.text("event's time", std::to_string(step.event.t_us), std::to_string(event->t_us));
  }
  compare.text("number of events", std::to_string(i), std::to_string(played.size()));
}

}  // namespace

void audit(const StudyBundle& bundle, const InterfaceRegistry& registry, const LoggedSession& log,
           Audit& audit) {
  Played played;
  const Session session = replay(
      bundle, registry, log,
      [&played](const Session&, const std::vector<Record>& records) { played.take(records); });
  Comparison compare(log, audit);
  compare.text("number of trials", std::to_string(log.trials.size()),
               std::to_string(played.trials.size()));
  std::vector<std::vector<const Sample*>> stored(log.trials.size());
  for (const LoggedStep& step : log.steps) {
    if (step.sample && step.trial >= 0) {
      stored[static_cast<std::size_t>(step.trial)].push_back(&step.shown);
      ++audit.samples;
    }
    audit.events += step.sample ? 0 : 1;
  }
  for (std::size_t i = 0; i < std::min(log.trials.size(), played.trials.size()); ++i) {
    const int trial = static_cast<int>(i);
    compare.at(trial, log.trials[i].started_us);
    compare_identity(log.trials[i], played.trials[i], bundle.study, session.plan(), compare);
    compare.number("d_first", log.trials[i].d_first, played.trials[i].d_first);
    compare_samples(stored[i], played.trials[i].samples, trial, compare);
    compare_ends(log.trials[i], played.trials[i].ended, trial, compare);
  }
  compare_events(log, played.events, compare);
  compare_answers(log.answers, played.answers, compare);
  compare.at(-1, log.last_us);
  // A session that died on its last page: earlier versions of the program left it running.
  const bool open = log.outcome == to_text(Outcome::running);
  const Outcome outcome = open ? session.outcome() : session.decided();
  if (log.outcome != "withdrawn") compare.text("outcome", log.outcome, to_text(outcome));
  ++audit.sessions;
  audit.trials += static_cast<int>(log.trials.size());
}

}  // namespace promenade::study
