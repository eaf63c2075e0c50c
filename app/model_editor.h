// What the window of `promenade model adjectives` and `model features` shows and changes: where
// the tree is cut, what the clusters are called, and which pairs are left. Knows no window.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "motion/models/dendrogram_layout.h"
#include "motion/motion_set.h"
#include "study/adjective_model.h"

namespace promenade::app {

// A line of the table beside the tree.
struct ModelRow {
  std::string name;      // "slow – fast"
  double extreme = 0;    // mu*; NaN: not rated
  double deviation = 0;  // sigma
  std::string fate;      // "kept", or why not
  int cluster = -1;      // -1: left out
};

class ModelEditor {
 public:
  explicit ModelEditor(study::AdjectiveModel model);
  // Of the features of at least two motions: they have no thresholds and cannot be saved.
  ModelEditor(const motion::MotionSet& set, int clusters);

  const std::string& title() const { return title_; }
  bool simulated() const { return model_ && model_->simulated(); }
  const motion::Dendrogram& tree() const { return tree_; }
  const motion::DendrogramLayout& layout() const { return layout_; }
  const std::vector<std::string>& leaves() const { return leaves_; }
  const std::vector<int>& cluster() const { return cluster_; }  // of each leaf
  const std::vector<std::string>& names() const { return names_; }
  const std::vector<ModelRow>& rows() const { return rows_; }

  // The height of the cut; it is moved to between two merges only when the tree changes.
  double cut() const { return cut_; }
  double top() const;  // of the axis
  void cut_at(double height);

  // Null: features.
  const study::AdjectiveModel* model() const { return model_ ? &*model_ : nullptr; }
  void set_thresholds(double least_extreme, double most_deviation);
  // The name stays with the pairs of the cluster, also when another cut comes between.
  void rename(int cluster, const std::string& name);

 private:
  void remake(const motion::QuantificationOptions& options);
  void show_model();
  void show_features(int clusters);

  std::string title_;
  std::optional<study::AdjectiveModel> model_;
  std::optional<motion::MotionSet> set_;
  std::map<std::vector<std::string>, study::PrimaryWords> given_;  // by the pairs
  motion::Dendrogram tree_;
  motion::DendrogramLayout layout_;
  std::vector<std::string> leaves_, names_;
  std::vector<int> cluster_;
  std::vector<ModelRow> rows_;
  double cut_ = 0;
};

}  // namespace promenade::app
