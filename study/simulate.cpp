#include "study/simulate.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "study/identity.h"
#include "study/replay.h"

namespace promenade::study {
namespace {

constexpr std::int64_t press_to_action_us = 90'000;
constexpr std::int64_t frame_us = 16'667;
constexpr std::int64_t longest_session_us = 24LL * 3600 * 1'000'000;

bool by_hand(const decltype(Input::action)& action) {
  return std::holds_alternative<Control>(action) || std::holds_alternative<Done>(action) ||
         std::holds_alternative<StartOver>(action) || std::holds_alternative<Continue>(action) ||
         std::holds_alternative<SetAnswer>(action) ||
         std::holds_alternative<ChooseLanguage>(action) || std::holds_alternative<Resume>(action) ||
         std::holds_alternative<Back>(action) || std::holds_alternative<Leave>(action);
}

// Work that several threads do out of order and one takes in order, never more than
// a few ahead.
class Ordered {
 public:
  using Work = std::function<Steps(int index)>;

  Ordered(int count, int jobs, Work work)
      : count_(count), ahead_(4 * jobs), work_(std::move(work)) {
    for (int i = 0; i < jobs; ++i) threads_.emplace_back([this] { run(); });
  }

  ~Ordered() {
    {
      const std::lock_guard lock(mutex_);
      next_ = count_;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  Steps take(int index) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return error_ || done_.count(index) > 0; });
    if (error_) std::rethrow_exception(error_);
    Steps records = std::move(done_[index]);
    done_.erase(index);
    taken_ = index + 1;
    changed_.notify_all();
    return records;
  }

 private:
  // The next index, or count_ when there is none left.
  int claim() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return next_ >= count_ || next_ < taken_ + ahead_; });
    return next_ >= count_ ? count_ : next_++;
  }

  void run() {
    for (int index = claim(); index < count_; index = claim()) {
      try {
        Steps records = work_(index);
        const std::lock_guard lock(mutex_);
        done_[index] = std::move(records);
      } catch (...) {
        const std::lock_guard lock(mutex_);
        error_ = std::current_exception();
      }
      changed_.notify_all();
    }
  }

  int count_;
  int ahead_;
  Work work_;
  std::mutex mutex_;
  std::condition_variable changed_;
  int next_ = 0;
  int taken_ = 0;
  std::map<int, Steps> done_;
  std::exception_ptr error_;
  std::vector<std::thread> threads_;
};

void store_session(Store& store, const Plan& plan, const Cohort& cohort, const std::string& code,
                   const Steps& steps) {
  SessionHeader header;
  header.participant = code;
  header.simulated = true;
  header.new_participant = true;
  header.machine = cohort.machine;
  header.started_utc = utc_now();
  store.begin_session(header, plan);
  for (const std::vector<Record>& step : steps) store.write(step);
  store.flush();
  store.end_session(utc_now());
}

std::string code_of(int number) {
  const std::string digits = std::to_string(number);
  return "S" + std::string(digits.size() < 3 ? 3 - digits.size() : 0, '0') + digits;
}

// Do the weights still move by themselves?
bool glides(const Session& session) {
  const TrialState* trial = session.trial();
  return trial && trial->touched && weights_of(*trial->interface, settled_us) != trial->weights;
}

// Goes on from `done` until the cohort is whole or another process takes a number or an
// order that was meant for it; then those that were simulated ahead are worth nothing.
// False: the caller wants to stop.
bool simulate_rest(const StudyBundle& bundle, const InterfaceRegistry& registry, Store& store,
                   const Cohort& cohort, int& done) {
  const int count = cohort.participants - done;
  const std::vector<int> sequences = store.next_sequences(true, false, count);
  const int first = store.next_simulated_number();
  const auto plan_of = [&](int index) {
    return make_plan(bundle.study, sequences[static_cast<std::size_t>(index)]);
  };
  Ordered sessions(count, std::max(1, cohort.jobs), [&](int index) {
    const auto number = static_cast<std::uint64_t>(first) + static_cast<std::uint64_t>(index);
    const std::uint64_t seed = Rng(cohort.seed, number, "person").next();
    return simulate_steps(bundle, registry, plan_of(index), seed, cohort.tendencies);
  });
  for (int index = 0; index < count; ++index) {
    const Steps steps = sessions.take(index);
    try {
      store_session(store, plan_of(index), cohort, code_of(first + index), steps);
    } catch (const TakenError&) {
      return true;
    }
    ++done;
    if (cohort.progress && !cohort.progress(done)) return false;
  }
  return true;
}

}  // namespace

namespace {

// A session that a simulated participant plays, from where it stands to its end.
class PlayedSession {
 public:
  using Sink = std::function<void(std::vector<Record>)>;
  PlayedSession(const StudyBundle& bundle, const InterfaceRegistry& registry, Session& session,
                std::uint64_t seed, const Tendencies& tendencies, std::int64_t from_us, Sink sink)
      : participant_(bundle, registry, seed, tendencies),
        session_(session),
        sink_(std::move(sink)) {
    input_.t_us = from_us;
  }

  void play() {
    while (!session_.ended()) {
      if (input_.t_us > longest_session_us) {
        step(0, Stop{"a simulated session never ends"});
      } else {
        act(participant_.next(session_));
      }
    }
  }

  void step(std::int64_t wait_us, decltype(Input::action) action) {
    input_.t_us += wait_us;
    const bool by_experimenter = std::holds_alternative<Release>(action);
    const bool by_system =
        std::holds_alternative<Interrupted>(action) || std::holds_alternative<Return>(action);
    input_.actor = by_experimenter ? Actor::experimenter
                   : by_system     ? Actor::system
                                   : Actor::participant;
    input_.action = std::move(action);
    sink_(session_.step(input_));
  }

 private:
  // Frames pass while the controls glide, so that what they pass by is measured.
  std::int64_t wait(std::int64_t wait_us) {
    while (wait_us > frame_us && glides(session_)) {
      step(frame_us, Tick{});
      wait_us -= frame_us;
    }
    return wait_us;
  }

  void act(Intention intention) {
    const Page page = session_.page();
    if (!by_hand(intention.action)) {
      return step(wait(intention.wait_us), std::move(intention.action));
    }
    step(wait(std::max<std::int64_t>(0, intention.wait_us - press_to_action_us)), Press{});
    // The page may have changed under the hand.
    const Page& now = session_.page();
    const bool same = now.kind == page.kind && now.trial == page.trial;
    if (same) step(press_to_action_us, std::move(intention.action));
  }

  SimulatedParticipant participant_;
  Session& session_;
  Sink sink_;
  Input input_;
};

void resume_simulated(const StudyBundle& bundle, const InterfaceRegistry& registry, Store& store,
                      const InterruptedSession& interrupted, std::uint64_t seed) {
  const LoggedSession log = store.read_session(interrupted.uuid);
  Session session = replay(bundle, registry, log);
  store.resume_session(log, session.plan());
  PlayedSession played(bundle, registry, session, Rng(seed, log.seed, "resumed").next(), {},
                       log.last_us,
                       [&store](const std::vector<Record>& step) { store.write(step); });
  const std::int64_t gap = gap_us(log, utc_now());
  played.step(0, session.left() ? decltype(Input::action)(Return{gap})
                                : Interrupted{gap, bundle.study.safety.resume});
  played.play();
  store.end_session(utc_now());
}

}  // namespace

Steps simulate_steps(const StudyBundle& bundle, const InterfaceRegistry& registry, const Plan& plan,
                     std::uint64_t seed, const Tendencies& tendencies) {
  Steps steps;
  Session session(bundle, registry, plan);
  PlayedSession(bundle, registry, session, seed, tendencies, 0, [&steps](std::vector<Record> step) {
    if (!step.empty()) steps.push_back(std::move(step));
  }).play();
  return steps;
}

int resume_simulated_sessions(const StudyBundle& bundle, const InterfaceRegistry& registry,
                              Store& store, std::uint64_t seed) {
  int done = 0;
  for (const InterruptedSession& one : store.interrupted_sessions(true, false)) {
    try {
      resume_simulated(bundle, registry, store, one, seed);
      ++done;
    } catch (const TakenError&) {
      // Another process goes on with it.
    }
  }
  return done;
}

std::vector<Record> simulate_session(const StudyBundle& bundle, const InterfaceRegistry& registry,
                                     const Plan& plan, std::uint64_t seed) {
  std::vector<Record> records;
  for (std::vector<Record>& step : simulate_steps(bundle, registry, plan, seed)) {
    records.insert(records.end(), std::make_move_iterator(step.begin()),
                   std::make_move_iterator(step.end()));
  }
  return records;
}

int simulate_cohort(const StudyBundle& bundle, const InterfaceRegistry& registry, Store& store,
                    const Cohort& cohort) {
  int done = 0;
  while (done < cohort.participants && simulate_rest(bundle, registry, store, cohort, done)) {
  }
  return done;
}

}  // namespace promenade::study
