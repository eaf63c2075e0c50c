// A stimulus: a motion that does not loop, to be rated beside the walks of the set. It is a walk
// through a motion graph (motion/graph/motion_graph.h) by the labels that the study asks for, one
// after the other.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "motion/graph/graph_walk.h"
#include "motion/graph/label_walk.h"
#include "study/study.h"

namespace promenade::study {

struct Stimulus {
  std::string name;
  std::string file;  // of the graph, as the study says it
  std::shared_ptr<const motion::MotionGraph> graph;
  std::vector<int> edges;                    // the walk
  std::vector<motion::LabelledPart> labels;  // what is seen when: frames of the take
  motion::Take take;  // metres; begins over the origin and goes along +Z; at least two frames

  double seconds() const { return (take.frames() - 1) * take.frame_time; }
};

// At its end a stimulus stands for so long before it begins again (ours).
inline constexpr double stimulus_rest_s = 0.5;

// The moment of a stimulus after so many seconds of playing it again and again.
struct StimulusMoment {
  int round = 0;       // from 0: how often it was played to its end, with the rest there
  double seconds = 0;  // of the motion, 0 to its length
};
StimulusMoment moment_of(const Stimulus& stimulus, double seconds);

// A walk that shows these labels in their order, `seed` of the possible ones. Throws InputError
// where the graph has none; each label is one of the graph's.
std::vector<int> find_walk(const motion::MotionGraph& graph,
                           const std::vector<motion::WantedLabel>& parts, std::uint64_t seed);

// The motion of a walk along these edges of the graph, at least one.
Stimulus make_stimulus(std::string name, std::shared_ptr<const motion::MotionGraph> graph,
                       std::vector<int> edges);

// Joints alike and no bone 5 mm longer, so that a figure made for one skeleton fits the other.
bool same_bones(const motion::Skeleton& a, const motion::Skeleton& b);

// "happy 4.1 s, sad 3.9 s": what is seen, in its order.
std::string describe_parts(const Stimulus& stimulus);
// How often it passes from one place of the captures to another.
int count_transitions(const Stimulus& stimulus);

// 41: how it seems to simulated people, in steps of the scale (study/impressions.h): as the walks
// of its labels do, by the time that each is seen. Labels without a walk in the set are neutral.
Eigen::VectorXd felt_of(const Stimulus& stimulus, const StudyBundle& bundle);

}  // namespace promenade::study
