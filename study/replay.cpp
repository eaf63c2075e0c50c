#include "study/replay.h"

#include "study/event_input.h"

namespace promenade::study {
namespace {

// What leads there: the input that was logged; for a sample that what glides has moved on,
// and for what the system did by itself that its time had come.
Input input_at(const LoggedStep& step) {
  if (!step.sample) {
    if (auto input = input_of(step.event)) return *input;
  }
  Input input;
  input.t_us = step.sample ? step.shown.t_us : step.event.t_us;
  input.actor = Actor::system;
  if (!step.sample) input.action = Wait{};
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
  // The program lived on for a while.
  Input end;
  end.t_us = log.last_us;
  end.actor = Actor::system;
  end.action = Wait{};
  const std::vector<Record> records = session.step(end);
  if (stepped) stepped(session, records);
  return session;
}

}  // namespace promenade::study
