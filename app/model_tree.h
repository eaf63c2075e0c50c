// The tree of a ModelEditor with the cut through it: leaves on the left, merges, and room for the
// names of the clusters on the right.
#pragma once

#include <functional>
#include <optional>

#include "app/model_editor.h"
#include "app/widgets.h"

namespace promenade::app {

// Row `row` of the leaves within a box, each `high` pixels; between two rows for a merge.
Box tree_row(const Box& box, double row, float high);

// Where a cluster stands in the box of names.
struct ClusterPlace {
  Box bar, name;
};
ClusterPlace place_of_cluster(const Ui& ui, const ModelEditor& editor, int cluster,
                              const Box& names, float row);

// `draw_names` draws into the box on the right, beside rows of that height. Returns where the cut
// was dragged to, in the unit of the tree.
std::optional<double> draw_model_tree(
    const Ui& ui, const ModelEditor& editor, const Box& box,
    const std::function<void(const Box& names, float row)>& draw_names);

// The names as they are, in the colours of their clusters.
void draw_cluster_names(const Ui& ui, const ModelEditor& editor, const Box& names, float row);

}  // namespace promenade::app
