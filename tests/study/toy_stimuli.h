// The toy study with a task that rates stimuli, out of a graph in which one walk leads into the
// other and not back.
#pragma once

#include "motion/graph/graph_file.h"
#include "study/load_study.h"
#include "tests/motion/graph/toy_graph.h"
#include "toy.h"

namespace promenade::study::toy {

// "near" can go on forever, or pass into "far", which can go on forever. Ten frames a second.
inline motion::MotionGraph walks_graph() {
  motion::MotionGraph graph = motion::toy_graph(
      {60, 60}, {motion::toy_passage({0, 55}, {0, 5}, 4), motion::toy_passage({0, 30}, {1, 8}, 4),
                 motion::toy_passage({0, 40}, {1, 8}, 4), motion::toy_passage({1, 30}, {1, 5}, 4),
                 motion::toy_passage({1, 55}, {1, 5}, 4)});
  graph.takes[0].label = "near";
  graph.takes[1].label = "far";
  return graph;
}

inline const std::string stimulus_text =
    "[[stimulus]]\nname = 'near_then_far'\ngraph = 'walks.graph'\n"
    "parts = [{ label = 'near', seconds = 3 }, { label = 'far', seconds = 2 }]\n";

inline const std::string rate_text =
    "[[task]]\nname = 'judge'\nkind = 'rate'\ninstrument = 'impression'\nplayback = true\n"
    "targets = [{ example = 'side' }, { stimulus = 'near_then_far' }]\n";

inline const std::string head_text = "[study]\nname = 'toy'\nset = 'toy'\nseed = 7\n";

// `graph`: the bytes of walks.graph; every other file is the program's.
inline StudyBundle stimulus_bundle(const std::string& text = head_text + stimulus_text + rate_text,
                                   const std::string& graph = motion::to_bytes(walks_graph())) {
  return read_study(
      "toy.toml", text, registry(),
      [](const std::string&, const std::string&) { return motion_set(); },
      [&](const std::string& name, const std::string& folder) {
        if (name == "walks.graph") return graph;
        return load_file(name, folder);
      });
}

}  // namespace promenade::study::toy
