#include "study/simulated.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/builtin.h"
#include "motion/models/adjective_pairs.h"
#include "study/asked_quality.h"
#include "study/impressions.h"
#include "study/simulated_raters.h"
#include "study/stimulus.h"

namespace promenade::study {
namespace {

constexpr std::int64_t away_us = 24LL * 3600 * 1'000'000;  // of those who leave
constexpr double second_thoughts = 0.04;  // share of rated motions after which people go back

// Positive, with this mean; sigma is the standard deviation of the logarithm.
double log_normal(Rng& rng, double mean, double sigma) {
  return mean * std::exp(sigma * rng.normal() - 0.5 * sigma * sigma);
}

// The same for everyone: how much a style has of a quality, 0 to 0.8.
double arbitrary_appeal(const std::string& quality, const std::string& style) {
  return 0.8 * Rng(0, 0, quality + "\n" + style).uniform();
}

bool contains(const std::string& text, const std::string& part) {
  return !part.empty() && text.find(part) != std::string::npos;
}

const Eigen::MatrixXd& impressions_in(const StudyBundle& bundle) {
  return bundle.impressions->of(bundle.space.set,
                                motion::builtin_name(bundle.study.set).value_or(""));
}

// Of a quality that is one end of a pair of adjectives: how the walks seem on it.
std::optional<Eigen::VectorXd> felt_appeal(const Target& target, const StudyBundle& bundle) {
  std::vector<std::string> pairs;
  for (const motion::AdjectivePair& pair : motion::adjective_pairs) {
    pairs.push_back(motion::pair_name(pair));
  }
  const auto asked = asked_pair(pairs, target);
  if (!asked) return std::nullopt;
  const Eigen::MatrixXd& felt = impressions_in(bundle);
  const Eigen::VectorXd towards = (asked->left ? -1 : 1) * felt.row(asked->pair).transpose();
  return Eigen::VectorXd(0.5 + 0.25 * towards.unaryExpr(&judged).array());
}

Eigen::VectorXd appeal_of(const Target& target, const StudyBundle& bundle) {
  if (const auto felt = felt_appeal(target, bundle)) return *felt;
  const motion::MotionSet& set = bundle.space.set;
  Eigen::VectorXd appeal(set.size());
  const std::string quality = text_in(target.quality, "en");
  for (int i = 0; i < set.size(); ++i) {
    const std::string& style = set.cycles[static_cast<std::size_t>(i)].style;
    const bool named = contains(style, quality) || contains(quality, style);
    appeal(i) = named ? 1 : arbitrary_appeal(quality, style);
  }
  return appeal;
}

}  // namespace

Person draw_person(Rng& rng) {
  Person person;
  person.eye_noise_m = log_normal(rng, 0.008, 0.4);
  person.imagination_m = log_normal(rng, 0.045, 0.5);
  person.patience_s = log_normal(rng, 60, 0.4);
  person.think_s = log_normal(rng, 2.0, 0.35);
  person.ideas = 3 + static_cast<int>(rng.below(5));
  person.generosity = 0.1 * rng.normal();
  return person;
}

SimulatedParticipant::SimulatedParticipant(const StudyBundle& bundle,
                                           const InterfaceRegistry& registry, std::uint64_t seed,
                                           const Tendencies& tendencies)
    : bundle_(&bundle),
      registry_(&registry),
      rng_(seed, 0, "simulate"),
      person_(draw_person(rng_)),
      tendencies_(tendencies),
      seed_(seed),
      gram_(bundle.space.offsets.transpose() * bundle.space.offsets) {}

Intention SimulatedParticipant::after(double mean_s, decltype(Input::action) action) {
  const double slower = 1 + tendencies_.fatigue * awake_s_ / 600;
  const double seconds = std::max(0.15, log_normal(rng_, mean_s * slower, 0.5));
  trial_.spent_s += seconds;
  awake_s_ += seconds;
  return {static_cast<std::int64_t>(seconds * 1e6), std::move(action)};
}

Intention SimulatedParticipant::next(const Session& session) {
  if (session.left()) return {0, Return{away_us}};
  if (session.paused()) return after(person_.think_s, Resume{});
  switch (session.page().kind) {
    case PageKind::trial:
      return at_trial(session);
    case PageKind::questionnaire:
      return at_questionnaire(session);
    case PageKind::release:
      return after(5, Release{});
    case PageKind::language:
      return after(3, ChooseLanguage{bundle_->study.languages.front()});
    default:
      return at_page(session);
  }
}

Intention SimulatedParticipant::at_page(const Session& session) {
  const bool to_read =
      session.page().kind == PageKind::consent || session.page().kind == PageKind::instructions;
  if (session.can_leave() && Rng(seed_, ++chances_, "leave").uniform() < tendencies_.leaving) {
    return after(5, Leave{});
  }
  Intention next = after(to_read ? 12 : 3, Continue{});
  next.wait_us += session.break_left_us();
  return next;
}

// How much of a thing somebody has who is as content as the person after this trial.
double SimulatedParticipant::share_of_scale() {
  const double leaning = person_.generosity + trial_.liking;
  return std::clamp(0.25 + 0.55 * trial_.success + leaning + 0.12 * rng_.normal(), 0.0, 1.0);
}

// As simulated raters do (simulated_raters.cpp): a leaning on each pair, a hand of one's own, and
// a doubt that is another one each time.
std::optional<double> SimulatedParticipant::judgement_of(const Item& item) {
  const int pair = trial_.felt.size() > 0 ? pair_asked_by(item) : -1;
  if (pair < 0) return std::nullopt;
  const RaterOptions raters;
  const double leaning =
      raters.leaning * Rng(seed_, static_cast<std::uint64_t>(pair), "leaning").normal();
  const double bold = std::exp(raters.boldness * Rng(seed_, 0, "boldness").normal());
  const double felt =
      bold * judged(trial_.felt(pair)) + leaning + trial_.noise * doubt_about(pair) * rng_.normal();
  return std::clamp(0.5 + 0.25 * felt, 0.0, 1.0);
}

SetAnswer SimulatedParticipant::answer_to(const Item& item) {
  SetAnswer answer{item.name};
  const auto choose = [this](std::size_t count) { return rng_.below(count); };
  switch (item.kind) {
    case ItemKind::scale:
    case ItemKind::number: {
      const double steps = std::round((item.most - item.least) / item.step);
      const std::optional<double> judgement = judgement_of(item);
      const double share = judgement ? *judgement : share_of_scale();
      answer.value = item.least + item.step * std::round(steps * share);
      break;
    }
    case ItemKind::choice: {
      const std::size_t at = choose(item.choices.size());
      answer.value = static_cast<double>(at) + 1;
      answer.text = item.choices[at].name;
      break;
    }
    case ItemKind::text:
      answer.text = "simulated";
      break;
    case ItemKind::ranking: {
      std::vector<std::string> names;
      for (const Choice& choice : item.choices) names.push_back(choice.name);
      rng_.shuffle(names);
      for (const std::string& name : names) answer.text += (answer.text.empty() ? "" : "\n") + name;
      break;
    }
    case ItemKind::agree:
      answer.value = 1;
      break;
  }
  if (item.can_decline && rng_.below(20) == 0) answer = {.item = item.name, .declined = true};
  return answer;
}

// The next question without an answer; free words are left out now and then.
std::optional<SetAnswer> SimulatedParticipant::next_answer(const Session& session) {
  const Instrument* asked = session.questions();
  if (asked == nullptr) return std::nullopt;
  for (const int i : session.item_order()) {
    const Item& item = asked->items[static_cast<std::size_t>(i)];
    const bool given = session.answers()[static_cast<std::size_t>(i)].given();
    if (given || (!item.needed && item.kind == ItemKind::text)) continue;
    return answer_to(item);
  }
  return std::nullopt;
}

Intention SimulatedParticipant::at_questionnaire(const Session& session) {
  if (auto answer = next_answer(session)) return after(2.5, std::move(*answer));
  return after(1, Continue{});
}

// Now and then somebody thinks again about the motion before, and changes one answer there.
Intention SimulatedParticipant::at_rating(const Session& session) {
  const int index = session.trial()->index;
  const auto place = static_cast<std::uint64_t>(index);
  const bool again = session.can_go_back() && thought_again_.count(index) == 0 &&
                     Rng(seed_, place, "back").uniform() < second_thoughts;
  if (again) {
    thought_again_.insert(index);
    return after(2, Back{});
  }
  if (std::exchange(trial_.changes_one, false)) {
    const std::vector<Item>& items = session.questions()->items;
    return after(2.5, answer_to(items[rng_.below(items.size())]));
  }
  if (auto answer = next_answer(session)) {
    if (draws_a_line()) return after(0.5, in_line(session, std::move(*answer)));
    return after(2.5, std::move(*answer));
  }
  return after(1, Done{});
}

// Who only wants to be done with it.
bool SimulatedParticipant::draws_a_line() const {
  return Rng(seed_, 0, "straight_lining").uniform() < tendencies_.straight_lining;
}

// The same step of every scale of a motion, but for one in twenty.
SetAnswer SimulatedParticipant::in_line(const Session& session, SetAnswer answer) {
  const Item* item = find_item(*session.questions(), answer.item);
  if (item->kind != ItemKind::scale || rng_.below(20) == 0) return answer;
  const auto steps =
      static_cast<std::uint64_t>(std::lround((item->most - item->least) / item->step));
  const auto motion = static_cast<std::uint64_t>(session.trial()->index);
  const std::uint64_t line = Rng(seed_, motion, "line").below(steps + 1);
  answer.value = item->least + item->step * static_cast<double>(line);
  return answer;
}

void SimulatedParticipant::apply_tendencies(int interface) {
  trial_.noise = tendencies_.noise * std::pow(1 - tendencies_.learning, trial_.index);
  if (interface < 0) return;
  const auto index = static_cast<std::size_t>(interface);
  const std::string& name = bundle_->study.interfaces[index].name;
  const auto difficulty = tendencies_.difficulty.find(name);
  if (difficulty != tendencies_.difficulty.end()) trial_.noise *= difficulty->second;
  const auto preference = tendencies_.preference.find(name);
  if (preference != tendencies_.preference.end()) trial_.liking = preference->second;
  trial_.noise *= std::exp(tendencies_.aptitude * Rng(seed_, index, "aptitude").normal());
  trial_.liking += tendencies_.taste * Rng(seed_, index, "taste").normal();
}

void SimulatedParticipant::begin_trial(const Session& session) {
  const TrialState& state = *session.trial();
  const PlannedTrial& planned = session.plan().trials[static_cast<std::size_t>(state.index)];
  const Target& target = target_of(bundle_->study, planned);
  trial_ = {};
  trial_.index = state.index;
  trial_.started_us = state.started_us;
  trial_.blind = task_of(bundle_->study, planned).blind;
  trial_.first = state.d.value_or(1);
  trial_.patience_s = log_normal(rng_, person_.patience_s, 0.3);
  apply_tendencies(planned.interface);
  const Task& task = task_of(bundle_->study, planned);
  if (task.kind == TaskKind::rate) {
    trial_.changes_one = state.attempt > 1 && session.answered();
    if (!asks_for_pairs(*session.questions())) return;
    trial_.felt = target.stimulus ? felt_of(*target.stimulus, *bundle_)
                                  : impressions_in(*bundle_) * state.weights;
    return;
  }
  const Eigen::VectorXd* wanted = target_weights(bundle_->study, planned);
  if (wanted == nullptr) {
    trial_.appeal = appeal_of(target, *bundle_);
    return;
  }
  trial_.target = *wanted;
  const Eigen::VectorXd away = state.weights - trial_.target;
  const double length = std::sqrt(std::max(0.0, away.dot(gram_ * away)));
  trial_.metres_per_offset = length > 0 ? state.d.value_or(0) / length : 0;
}

double SimulatedParticipant::imagined(const Eigen::VectorXd& weights) const {
  if (trial_.target.size() == 0) return 1 - weights.dot(trial_.appeal);
  const Eigen::VectorXd away = weights - trial_.target;
  return trial_.metres_per_offset * std::sqrt(std::max(0.0, away.dot(gram_ * away)));
}

// Whoever works blind sees nothing of it.
double SimulatedParticipant::seen(const TrialState& trial) const {
  return trial.d && !trial_.blind ? *trial.d : imagined(trial.weights);
}

double SimulatedParticipant::unit() const {
  return trial_.noise * (trial_.target.size() > 0 ? 1 : 5);
}

std::optional<ControlInput> SimulatedParticipant::best_idea(const Session& session,
                                                            const TrialState& trial) {
  const PlannedTrial& planned = session.plan().trials[static_cast<std::size_t>(trial.index)];
  const InterfaceUse& use = bundle_->study.interfaces[static_cast<std::size_t>(planned.interface)];
  std::vector<ControlInput> ideas = registry_->find(use.type)->simulate(*trial.interface, rng_);
  rng_.shuffle(ideas);
  if (ideas.size() > static_cast<std::size_t>(person_.ideas)) {
    ideas.resize(static_cast<std::size_t>(person_.ideas));
  }
  // Only what seems better than what is seen is worth doing, except before the first try.
  const double noise_m = trial_.blind ? person_.imagination_m : person_.eye_noise_m;
  double best = trial.touched ? seen(trial) + noise_m * unit() * rng_.normal() : INFINITY;
  std::optional<ControlInput> chosen;
  for (const ControlInput& idea : ideas) {
    const std::unique_ptr<InterfaceState> next = trial.interface->clone();
    if (next->apply(idea) != Applied::done) continue;
    const double result =
        imagined(weights_of(*next, settled_us)) + person_.imagination_m * unit() * rng_.normal();
    if (result >= best) continue;
    best = result;
    chosen = idea;
  }
  return chosen;
}

// Nobody judges a stimulus before its end.
Intention SimulatedParticipant::watch(const Stimulus& stimulus) {
  awake_s_ += stimulus.seconds();
  return {std::llround(1e6 * stimulus.seconds()), Tick{}};
}

Intention SimulatedParticipant::at_trial(const Session& session) {
  const TrialState& trial = *session.trial();
  if (trial.index != trial_.index || trial.started_us != trial_.started_us) {
    begin_trial(session);
    if (trial.stimulus) return watch(*trial.stimulus);
    return after(1.5 * person_.think_s, Tick{});  // a first look
  }
  if (session.questions() != nullptr) return at_rating(session);
  const double now = seen(trial);
  trial_.success = std::clamp(1 - now / std::max(trial_.first, 1e-9), 0.0, 1.0);
  if (trial.below_since_us && !trial_.blind) return {300'000, Tick{}};  // it fits: hands off
  const bool has_done =
      task_of(bundle_->study, session.plan().trials[static_cast<std::size_t>(trial.index)])
          .has_done;
  const bool impatient = has_done && trial_.spent_s > trial_.patience_s;
  // In find tasks what is good enough comes down with the time spent.
  const double good_enough = 0.25 + 0.5 * trial_.spent_s / trial_.patience_s;
  // Blind, people stop when they believe that they are there.
  if (trial_.blind && trial.touched && trial_.spent_s > 0.3 * trial_.patience_s) {
    return after(person_.think_s, Done{});
  }
  const bool found = trial_.appeal.size() > 0 && trial.touched &&
                     now + person_.eye_noise_m * unit() * rng_.normal() < good_enough;
  if (impatient || found) return after(person_.think_s, Done{});
  if (auto idea = best_idea(session, trial)) return after(person_.think_s, Control{*idea});
  const bool lost = trial.touched && now > 1.5 * trial_.first && rng_.below(4) == 0;
  if (lost) return after(person_.think_s, StartOver{});
  return after(0.5 * person_.think_s, Tick{});
}

}  // namespace promenade::study
