// Plays sessions in a loop and keeps what they log.
#pragma once

#include "study/session.h"
#include "toy.h"

namespace promenade::study::toy {

inline Control pick(const std::string& walk) { return {{.kind = "pick", .target = walk}}; }
inline Control slide(const std::string& walk, double value) {
  return {{.kind = "slide", .target = walk, .value = value}};
}

struct Player {
  explicit Player(const StudyBundle& bundle, int sequence = 0)
      : session(bundle, registry(), make_plan(bundle.study, sequence)) {}

  std::vector<Record> at(std::int64_t t_us, decltype(Input::action) action) {
    Input input;
    input.action = std::move(action);
    return step(t_us, std::move(input));
  }

  // As the experimenter, whom a watcher asked.
  std::vector<Record> obey(std::int64_t t_us, const std::string& request,
                           decltype(Input::action) action) {
    Input input;
    input.actor = Actor::experimenter;
    input.request = request;
    input.action = std::move(action);
    return step(t_us, std::move(input));
  }

  std::vector<Record> step(std::int64_t t_us, Input input) {
    input.t_us = t_us;
    std::vector<Record> made = session.step(input);
    records.insert(records.end(), made.begin(), made.end());
    return made;
  }

  // Continues at one time until a trial is open.
  void to_trial(std::int64_t t_us) {
    while (!session.trial() && session.can_continue()) at(t_us, Continue{});
  }

  // One second for each page, one control and Done in each trial, best ratings.
  void whole_session() {
    for (std::int64_t t = 1'000'000; !session.ended(); t += 1'000'000) {
      if (session.page().kind == PageKind::trial) {
        at(t, pick("near"));
        at(t + 1000, slide("side", 0.5));
        at(t + 2000, Done{});
      } else if (session.can_continue()) {
        at(t, Continue{});
      } else {
        at(t, SetAnswer{"liked", 7});
      }
    }
  }

  template <typename T>
  std::vector<T> all() const {
    std::vector<T> found;
    for (const Record& record : records) {
      if (const T* one = std::get_if<T>(&record)) found.push_back(*one);
    }
    return found;
  }

  Session session;
  std::vector<Record> records;
};

}  // namespace promenade::study::toy
