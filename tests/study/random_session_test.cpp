// Anything may happen in a session, and it may die at any step: the file is whole, the session
// goes on, and the audit agrees. One walk over all actions, kinds of tasks and pages.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <memory>

#include "play.h"
#include "study/replay.h"
#include "study/sqlite.h"
#include "study/store.h"
#include "toy.h"

namespace promenade::study {
namespace {

namespace fs = std::filesystem;

std::string study_text(const std::string& resume, const std::string& nesting) {
  return "[study]\nname = 'walk'\nseed = 5\nnesting = " + nesting + "\n" + R"(
[[interface]]
name = 'pick'
[[interface]]
name = 'mix'
[[task]]
name = 'first'
kind = 'guess'
targets = [{example = 'far'}, {example = 'side'}]
practice = [{example = 'side'}]
threshold = 0.1
[[task]]
name = 'then'
kind = 'match'
start = 'first'
threshold = 0.1
limit_s = 8
[[task]]
name = 'seek'
kind = 'find'
limit_s = 6
qualities = [{name = 'jolly'}]
[[task]]
name = 'judge'
kind = 'rate'
instrument = 'impression'
limit_s = 9
targets = [{example = 'far'}, {example = 'near'}]
[[task]]
name = 'again'
kind = 'rate'
instrument = 'impression'
targets = [{example = 'far'}, {example = 'near'}, {example = 'side'}]
practice = [{example = 'far'}, {example = 'near'}]
each = 2
repeats = 1
[[rating]]
item = 'liked'
question = 'Well?'
[[questionnaire]]
instrument = 'demographics'
when = 'start'
[[questionnaire]]
instrument = 'umux-lite'
when = 'block'
[[questionnaire]]
instrument = 'ranking'
when = 'end'
[practice]
until = 'criterion'
most_rounds = 2
[breaks]
after = 'block'
every = 2
least_s = 3
[safety]
leave = true
resume = ')" +
         resume + "'\n";
}

using Action = decltype(Input::action);

Action any_answer(const Session& session, Rng& rng) {
  const Instrument* asked = session.questions();
  if (asked == nullptr) return SetAnswer{"nothing", 1};
  const Item& item = asked->items[rng.below(asked->items.size())];
  if (rng.below(8) == 0) return SetAnswer{item.name, {}, "", true};
  if (item.kind == ItemKind::scale) {
    const double steps = (item.most - item.least) / item.step;
    const auto at = static_cast<double>(rng.below(static_cast<std::uint64_t>(steps) + 1));
    return SetAnswer{item.name, item.least + item.step * at};
  }
  if (item.kind == ItemKind::choice) {
    const std::size_t at = rng.below(item.choices.size());
    return SetAnswer{item.name, static_cast<double>(at) + 1, item.choices[at].name};
  }
  if (item.kind == ItemKind::ranking) return SetAnswer{item.name, {}, "mix\npick"};
  return SetAnswer{item.name, {}, "words"};
}

Action any_control(Rng& rng) {
  const char* walks[] = {"near", "side", "far", "nowhere"};
  const char* walk = walks[rng.below(4)];
  if (rng.below(2) == 0) return toy::pick(walk);
  return toy::slide(walk, static_cast<double>(rng.below(5)) / 4);
}

Action anything(const Session& session, Rng& rng) {
  if (session.left() && rng.below(3) > 0) return Return{86'400'000'000};
  if (session.paused() && rng.below(3) > 0) return Resume{};
  switch (rng.below(34)) {
    case 0:
      return Pause{};
    case 1:
      return Note{"a note"};
    case 2:
      return rng.below(6) == 0 ? Action(Skip{"why"}) : Action(Tick{});
    case 3:
      return rng.below(6) == 0 ? Action(Repeat{rng.below(2) == 0, "why"}) : Action(Tick{});
    case 4:
      return Undo{};
    case 5:
      return Redo{};
    case 6:
      return StartOver{};
    case 7:
      return LateFrame{1234};
    case 8:
      return Camera{0.1, 0.2, 1.5, 0, 0};
    case 9:
      return Press{};
    case 10:
    case 11:
      return Done{};
    case 12:
    case 13:
      return Back{};
    case 14:
      return Leave{};
    default:
      break;
  }
  if (session.trial() != nullptr && session.questions() == nullptr) return any_control(rng);
  if (rng.below(3) > 0 && session.questions() != nullptr) return any_answer(session, rng);
  return session.trial() != nullptr ? Action(Done{}) : Action(Continue{});
}

class RandomSession : public testing::TestWithParam<int> {
 protected:
  RandomSession() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~RandomSession() override { fs::remove_all(folder_); }
  std::string file() const { return (folder_ / "walk.db").string(); }

  static Actor actor_of(const Action& action) {
    if (std::holds_alternative<Skip>(action) || std::holds_alternative<Repeat>(action) ||
        std::holds_alternative<Note>(action)) {
      return Actor::experimenter;
    }
    const bool system = std::holds_alternative<Tick>(action) ||
                        std::holds_alternative<LateFrame>(action) ||
                        std::holds_alternative<Return>(action);
    return system ? Actor::system : Actor::participant;
  }

  // Goes on until the session ends or it dies; what was not flushed is lost then.
  void live(Store& store, Session& session, std::int64_t from_us, Rng& rng) {
    t_us_ = from_us;
    for (std::uint64_t left = 5 + rng.below(120); left > 0 && !session.ended(); --left) {
      Input input;
      t_us_ += static_cast<std::int64_t>(rng.below(900'000));
      input.t_us = t_us_;
      input.action = anything(session, rng);
      input.actor = actor_of(input.action);
      store.write(session.step(input));
      if (rng.below(3) == 0) store.alive(t_us_);
      if (rng.below(2) == 0) store.flush();
    }
  }

  // What a kill leaves: the files as they are while the store is open, without what it holds in
  // its transaction.
  void die(std::unique_ptr<Store> store) const {
    for (const char* end : {"", "-wal"}) {
      if (fs::exists(file() + end)) fs::copy_file(file() + end, file() + ".dead" + end);
    }
    store.reset();
    for (const char* end : {"", "-wal", "-shm"}) fs::remove(file() + end);
    for (const char* end : {"", "-wal"}) {
      if (fs::exists(file() + ".dead" + end)) fs::rename(file() + ".dead" + end, file() + end);
    }
    Database database(file(), Database::Mode::read_write);
    database.exec("UPDATE session SET process_start = 'another boot:1'");
  }

  fs::path folder_ = fs::temp_directory_path() / ("promenade_walk_" + std::to_string(::getpid()) +
                                                  "_" + std::to_string(GetParam()));
  std::int64_t t_us_ = 0;
};

TEST_P(RandomSession, DiesAnywhereGoesOnAndPassesTheAudit) {
  const char* policies[] = {"continue", "trial", "block"};
  const char* nestings[] = {"['interface', 'task', 'target']", "['target', 'task', 'interface']"};
  const StudyBundle bundle =
      toy::bundle(study_text(policies[GetParam() % 3], nestings[GetParam() / 3 % 2]));
  Rng rng(static_cast<std::uint64_t>(GetParam()), 0, "walk");
  auto first = std::make_unique<Store>(file(), bundle);
  Session fresh(bundle, toy::registry(), make_plan(bundle.study, 0));
  first->begin_session({}, fresh.plan());
  live(*first, fresh, 0, rng);
  die(std::move(first));
  int deaths = 0;
  for (bool over = false; !over && deaths < 60; ++deaths) {
    auto store = std::make_unique<Store>(file(), bundle);
    const auto interrupted = store->interrupted_sessions(false, false);
    over = interrupted.empty();
    if (over) break;
    const LoggedSession log = store->read_session(interrupted[0].uuid);
    Audit found;
    audit(bundle, toy::registry(), log, found);
    ASSERT_TRUE(found.differences.empty())
        << deaths << ": " << found.differences[0].what << " at " << found.differences[0].t_us
        << " stored " << found.differences[0].stored << " replayed "
        << found.differences[0].replayed;
    Session session = replay(bundle, toy::registry(), log);
    store->resume_session(log, session.plan());
    Input input;
    input.t_us = log.last_us;
    input.actor = Actor::system;
    input.action = Interrupted{1'000'000, bundle.study.safety.resume};
    if (session.left()) input.action = Return{1'000'000};
    store->write(session.step(input));
    live(*store, session, log.last_us, rng);
    die(std::move(store));
  }
  EXPECT_GT(deaths, 1);
  Database database(file(), Database::Mode::read_only);
  const LoggedSession log = read_session(database, session_uuids(database).at(0));
  Audit found;
  audit(bundle, toy::registry(), log, found);
  EXPECT_TRUE(found.differences.empty()) << found.differences[0].what;
  EXPECT_GT(found.numbers, 100);
}

INSTANTIATE_TEST_SUITE_P(Walks, RandomSession, testing::Range(0, 24));

}  // namespace
}  // namespace promenade::study
