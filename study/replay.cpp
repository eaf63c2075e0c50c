#include "study/replay.h"

#include "study/event_input.h"

namespace promenade::study {
namespace {

// What leads there: the input that was logged, or else that time passed.
Input input_at(const LoggedStep& step) {
  if (!step.sample) {
    if (auto input = input_of(step.event)) return *input;
  }
  Input input;
  input.t_us = step.sample ? step.shown.t_us : step.event.t_us;
  input.actor = Actor::system;
  return input;
}

bool asks_language(const LoggedSession& log) {
  return !log.steps.empty() && log.steps.front().event.target == to_text(PageKind::language);
}

}  // namespace

Session replay(const StudyBundle& bundle, const InterfaceRegistry& registry,
               const LoggedSession& log,
               const std::function<void(const Session&, const std::vector<Record>&)>& stepped) {
  Session session(bundle, registry, make_plan(bundle.study, log.sequence), asks_language(log));
  for (const LoggedStep& step : log.steps) {
    const std::vector<Record> records = session.step(input_at(step));
    if (stepped) stepped(session, records);
  }
  return session;
}

}  // namespace promenade::study
