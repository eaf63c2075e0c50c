// What each of the five interfaces can do about a target, whether the study uses it or
// the program shows it or not: the numbers of `check` and `model targets`.
#pragma once

#include "motion/models/control_maps.h"
#include "study/adjective_model.h"
#include "study/fairness.h"

namespace promenade::study {

// Everything that the targets of one motion set share: made once, never changed.
struct ReachModels {
  motion::PoseBank bank;
  std::vector<motion::ControlMap> maps;          // adjectives, features, labels, map, weights
  std::optional<AdjectiveModel> adjectives;      // behind the map of this name
  std::optional<PredictedAdjectives> predicted;  // or these, where they were given
  struct Missing {
    std::string name, reason;
  };
  std::vector<Missing> missing;  // interfaces that this set cannot have
};

// The sliders of one interface, or why this set has none. `model` may be null.
struct ControlMapOrReason {
  std::optional<motion::ControlMap> map;
  std::string reason;
};
ControlMapOrReason adjective_controls(const AdjectiveModel* model, const motion::MotionSet& set);
ControlMapOrReason feature_controls(const motion::MotionSet& set);

// Without a model of its own a built-in set gets that of its simulated raters.
ReachModels make_reach_models(const StudyBundle& bundle,
                              std::optional<AdjectiveModel> adjectives = std::nullopt);
// The same with adjectives that were told from the features of the bundle's motions.
ReachModels make_reach_models(const StudyBundle& bundle, PredictedAdjectives predicted);

// By the type of an interface; null: none.
const motion::ControlMap* find_map(const ReachModels& models, std::string_view type);

// Of a target with weights; `share_below` is of the threshold, metres. 500 random
// settings from a fixed seed (all, of an interface of finitely many), then a search:
// the same figures every time.
Reach reach(const ReachModels& models, const motion::ControlMap& map, const Target& target,
            double threshold_m, DistanceTimes times);

// Of an interface as the study uses it: by the map of its type; one that has none is tried as it
// is (study/fairness.h).
Reach reach(const StudyBundle& bundle, const InterfaceRegistry& registry, const ReachModels& models,
            const Task& task, int interface, const Target& target, double threshold_m);

// What `check` and `model targets` judge by: the task's threshold, or the automatic one.
double judged_threshold(const motion::MotionSpace& space, const Task& task);

}  // namespace promenade::study
