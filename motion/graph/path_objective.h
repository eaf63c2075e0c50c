// What a walk along a path is to be like; used by path_walk only.
#pragma once

#include "motion/graph/path_walk.h"

namespace promenade::motion {

// Near the path, and in the style of its parts.
class PathObjective : public WalkObjective {
 public:
  // All but the options are kept as references.
  PathObjective(const MotionGraph& graph, const std::vector<EdgeWay>& ways, const GroundPath& path,
                const PathWalkOptions& options);

  WalkState after(const WalkState& state, int edge, int frames) const override;
  double outlook(const WalkState& state, int frames) const override;

  // Where a walk can begin: at each node with such a label (empty: any), so that its pelvis is
  // where the path begins and moves as the path does.
  std::vector<WalkState> starts(const std::string& label) const;

  // Of the frames of an edge, from the state on, those before the path ends.
  int counted(const WalkState& state, int edge, int frames) const;
  // From the wanted point, metres, where the walk is at a frame of an edge.
  double distance(const WalkState& state, int edge, int frame) const;
  // How many of the first `frames` frames have another label than their part wants.
  int other_label(const WalkState& state, int edge, int frames) const;

 private:
  struct Part {
    double from_m, to_m;
    std::vector<int> frames_before;  // for each node (graph_labels.h)
    std::vector<bool> shown;         // for each edge, whether it has the label
  };

  const Part* part_at(double metres) const;

  const MotionGraph& graph_;
  const std::vector<EdgeWay>& ways_;
  const GroundPath& path_;
  std::vector<Part> parts_;
  double other_label_cost_;      // of a frame, m^2
  std::vector<int> first_edge_;  // of each node; -1: none
};

}  // namespace promenade::motion
