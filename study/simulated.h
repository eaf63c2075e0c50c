// A simulated participant: tries, looks, improves, sometimes gives up. Works
// with every interface through InterfaceType::simulate, and drives the session
// by the same inputs as a person. The window's autopilot turns its intentions
// into mouse events; `simulate` hands them to the session directly.
//
// How it decides: of a handful of things that it could do next it imagines the
// result, roughly, and does what seems best; then it looks at what came of it. In
// find tasks a walk appeals as it seems on the pair of adjectives that has the asked quality
// (impressions.h); where none has it, every style appeals to it by a fixed but arbitrary
// amount, which all simulated people share, and most by a style of that name.
#pragma once

#include <map>
#include <set>
#include <string>

#include "study/session.h"

namespace promenade::study {

// How a person is, drawn at random for each participant.
struct Person {
  double eye_noise_m = 0.01;     // standard deviation of the D that is seen
  double imagination_m = 0.045;  // the same for a motion that is only imagined
  double patience_s = 60;        // gives up around then, in tasks that have Done
  double think_s = 2;            // mean time between two actions
  int ideas = 5;                 // how many next steps come to mind
  double generosity = 0;         // added to every rating, as a share of the scale
};
Person draw_person(Rng& rng);

// What all simulated people of a cohort have beside what each is drawn as (docs/methods.md, 3).
// The defaults change nothing. Maps go by the name of the interface.
struct Tendencies {
  double noise = 1;     // factor of what people misjudge, seen or imagined
  double learning = 0;  // share of it that each trial of the session takes away, practice included
  double fatigue = 0;   // every ten minutes of the session actions take this share longer
  std::map<std::string, double> difficulty;  // factor of the noise; 1 where it is not named
  std::map<std::string, double> preference;  // added to ratings, as a share of the scale
  // Between people, drawn for each interface anew: standard deviations of the logarithm of their
  // own factor of the noise, and of their own addition to ratings.
  double aptitude = 0;
  double taste = 0;
  double leaving = 0;          // share of the pages where people can leave on which they do
  double straight_lining = 0;  // share of people who answer all items of a motion alike
};

// What the person does next, and after how long.
struct Intention {
  std::int64_t wait_us = 0;
  decltype(Input::action) action = Tick{};
};

class SimulatedParticipant {
 public:
  SimulatedParticipant(const StudyBundle& bundle, const InterfaceRegistry& registry,
                       std::uint64_t seed, const Tendencies& tendencies = {});
  Intention next(const Session& session);

 private:
  struct Trial {
    int index = -1;
    std::int64_t started_us = -1;  // of this attempt
    bool blind = false;
    double patience_s = 0;  // of this trial
    double spent_s = 0;
    Eigen::VectorXd target;        // N; empty in find tasks
    double metres_per_offset = 0;  // from the length of a difference of offsets to D
    Eigen::VectorXd appeal;        // N, 0 to 1; empty in match tasks
    double first = 1;              // how far from the wish the start was
    double success = 0;            // how it went so far, 0 to 1
    double noise = 1;              // factor of what is misjudged
    double liking = 0;             // of its interface: added to ratings, as a share of the scale
    bool changes_one = false;      // it is a motion that the person has come back to
    Eigen::VectorXd felt;          // 41: how what is rated seems (impressions.h); empty otherwise
  };
  Intention at_page(const Session& session);
  Intention at_trial(const Session& session);
  Intention watch(const Stimulus& stimulus);
  Intention at_questionnaire(const Session& session);
  Intention at_rating(const Session& session);
  bool draws_a_line() const;
  SetAnswer in_line(const Session& session, SetAnswer answer);
  std::optional<SetAnswer> next_answer(const Session& session);
  SetAnswer answer_to(const Item& item);
  // A pair of adjectives, by what is seen of the walk that is rated; nothing for other items.
  std::optional<double> judgement_of(const Item& item);
  double share_of_scale();  // 0 to 1
  void begin_trial(const Session& session);
  void apply_tendencies(int interface);  // to the trial that began; -1: no interface
  // How far from the wish: metres of D in match, 1 - appeal in find.
  double imagined(const Eigen::VectorXd& weights) const;
  double seen(const TrialState& trial) const;
  double unit() const;  // how much of it is one metre of noise
  std::optional<ControlInput> best_idea(const Session& session, const TrialState& trial);
  Intention after(double mean_s, decltype(Input::action) action);

  const StudyBundle* bundle_;
  const InterfaceRegistry* registry_;
  Rng rng_;
  Person person_;
  Tendencies tendencies_;
  std::uint64_t seed_;
  double awake_s_ = 0;           // since the session began
  std::uint64_t chances_ = 0;    // to leave, so far
  std::set<int> thought_again_;  // rated trials that were left to go back
  Eigen::MatrixXd gram_;         // N x N: offsets^T offsets
  Trial trial_;
};

}  // namespace promenade::study
