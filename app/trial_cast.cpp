#include "app/trial_cast.h"

namespace promenade::app {

Cast trial_cast(const study::StudyBundle& bundle, const study::Session& session,
                const motion::Cycle& made, std::int64_t now_us) {
  const study::TrialState& trial = *session.trial();
  const study::Task& task =
      study::task_of(bundle.study, session.plan().trials[static_cast<std::size_t>(trial.index)]);
  const auto& cycles = bundle.space.set.cycles;
  // What is rated is shown as a target is.
  const bool rated = task.kind == study::TaskKind::rate;
  return {
      .target = trial.stimulus ? nullptr
                : rated        ? &made
                : trial.target ? &*trial.target
                               : nullptr,
      .created = rated ? nullptr : &made,
      .reference = task.reference < 0 ? nullptr : &cycles[static_cast<std::size_t>(task.reference)],
      .blind = task.blind,
      .stimulus = trial.stimulus,
      .stimulus_s = trial.stimulus ? trial.showing.seconds(session.trial_us(now_us)) : 0};
}

}  // namespace promenade::app
