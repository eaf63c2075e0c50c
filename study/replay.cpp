#include "study/replay.h"

#include "study/event_input.h"

namespace promenade::study {
namespace {

bool asks_language(const LoggedSession& log) {
  return !log.steps.empty() && log.steps.front().event.target == to_text(PageKind::language);
}

}  // namespace

Session session_of(const StudyBundle& bundle, const InterfaceRegistry& registry,
                   const LoggedSession& log) {
  return {bundle, registry, make_plan(bundle.study, log.sequence), asks_language(log)};
}

Input input_of(const LoggedStep& step) {
  if (!step.sample) {
    if (auto input = input_of(step.event)) return *input;
  }
  Input input;
  input.t_us = step.t_us();
  input.actor = Actor::system;
  if (!step.sample) input.action = Wait{};
  return input;
}

Session replay(const StudyBundle& bundle, const InterfaceRegistry& registry,
               const LoggedSession& log,
               const std::function<void(const Session&, const std::vector<Record>&)>& stepped) {
  Session session = session_of(bundle, registry, log);
  for (const LoggedStep& step : log.steps) {
    const std::vector<Record> records = session.step(input_of(step));
    if (stepped) stepped(session, records);
  }
  // Killed before anything was stored: it has not begun.
  if (log.steps.empty()) return session;
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
