#include "tests/app/logged_trial.h"

#include "app/registry.h"
#include "study/load_study.h"

namespace promenade::app::bench {
namespace {

using Action = decltype(study::Input::action);

study::StudyBundle bundle_of(const std::string& interface, const std::string& more) {
  const std::string text =
      "[study]\nname = 'replay'\nlanguages = ['en', 'ja']\n"
      "[[interface]]\nname = '" +
      interface +
      "'\n"
      "[[task]]\nname = 'copy'\nkind = 'match'\nplayback = true\n" +
      more + "\ntargets = [{example = 'proud'}]\n";
  return study::read_study("replay.toml", text, interfaces(), study::load_motion_set);
}

class Person {
 public:
  explicit Person(const study::StudyBundle& bundle)
      : type_(*interfaces().find(bundle.study.interfaces[0].type)),
        session_(bundle, interfaces(), study::make_plan(bundle.study, 0)) {}

  std::vector<study::Record> play(double seconds) {
    while (session_.trial() == nullptr) take(study::Continue{}, 100'000);
    const std::int64_t end_us = t_us_ + static_cast<std::int64_t>(1e6 * seconds);
    while (t_us_ < end_us) {
      take(anything(), 1'000 * static_cast<std::int64_t>(3 + rng_.below(10)));
      for (int frame = 0; frame < 20; ++frame) take(study::Tick{}, 17'000);
    }
    if (session_.paused()) take(study::Resume{}, 0);
    take(study::Done{}, 1234);
    return records_;
  }

 private:
  void take(Action action, std::int64_t later_us) {
    study::Input input;
    input.t_us = t_us_ += later_us;
    input.x = 100 + static_cast<double>(rng_.below(1000));
    input.y = 100 + static_cast<double>(rng_.below(500));
    input.action = std::move(action);
    for (study::Record& record : session_.step(input)) records_.push_back(std::move(record));
  }

  Action anything() {
    if (session_.paused()) return study::Resume{};
    switch (rng_.below(12)) {
      case 0:
        return study::Undo{};
      case 1:
        return study::Pause{};
      case 2:
        return study::Camera{rng_.uniform(), 0.1, 1.2, 0.1, 0};
      case 3:
        return study::Playback{rng_.below(2) == 0, 0.5, rng_.below(2) == 0 ? 0.25 : -1};
      case 4:
      case 5:
        return study::Press{};
      default:
        return idea();
    }
  }

  Action idea() {
    const auto ideas = type_.simulate(*session_.trial()->interface, rng_);
    if (ideas.empty()) return study::Press{};
    return study::Control{ideas[rng_.below(ideas.size())]};
  }

  const study::InterfaceType& type_;
  study::Session session_;
  study::Rng rng_{1, 7, "replay"};
  std::int64_t t_us_ = 0;
  std::vector<study::Record> records_;
};

}  // namespace

study::LoggedSession logged(const std::vector<study::Record>& records) {
  study::LoggedSession log;
  log.participant = "P07";
  log.language = "en";
  log.machine = R"({"width":1280,"height":720})";
  const auto trial_of = [&log](int planned) {
    return planned < 0 ? -1 : static_cast<int>(log.trials.size()) - 1;
  };
  for (const study::Record& record : records) {
    study::LoggedStep step;
    if (const auto* started = std::get_if<study::TrialStarted>(&record)) {
      study::LoggedTrial trial;
      trial.uuid = "trial";
      trial.position = started->trial + 1;
      trial.task = "copy";
      trial.started_us = started->t_us;
      log.trials.push_back(trial);
    } else if (const auto* ended = std::get_if<study::TrialEnded>(&record)) {
      log.trials.back().outcome = study::to_text(ended->outcome);
      log.trials.back().ended = *ended;
    } else if (const auto* event = std::get_if<study::Event>(&record)) {
      step.event = *event;
      step.trial = trial_of(event->trial);
      log.steps.push_back(step);
    } else if (const auto* sample = std::get_if<study::Sample>(&record)) {
      step.sample = true;
      step.shown = *sample;
      step.trial = trial_of(sample->trial);
      log.steps.push_back(step);
    }
  }
  return log;
}

LoggedTrial played_trial(const std::string& interface, double seconds, const std::string& more) {
  LoggedTrial made{bundle_of(interface, more), {}};
  made.log = logged(Person(made.bundle).play(seconds));
  return made;
}

}  // namespace promenade::app::bench
