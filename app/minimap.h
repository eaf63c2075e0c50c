// The state of the minimap ([N] 5.4-5.5; docs/methods.md, 7) during one trial: a point of the
// plane, the shelf, and which part of the plane is seen. No clock, no UI.
#pragma once

#include <array>

#include "app/shelf.h"
#include "motion/models/map.h"
#include "study/rng.h"

namespace promenade::app {

// What is worked out once for a study.
struct MinimapModel final : study::InterfaceModel {
  std::array<motion::Minimap, 4> maps;  // by heuristic: they differ in nothing else
  Eigen::Vector2d radii;                // half axes of the valid points' ellipse around 0
  double half = 1;                      // of the side of the square around 0 that shows it all
  // The three primary clusters: the dots at their outlines, anticlockwise.
  std::vector<std::vector<int>> clusters;
};

study::PreparedModel prepare_minimap(const study::InterfaceResources& resources,
                                     const study::Parameters& parameters);

constexpr double closest_zoom = 8;

// Which part of the plane is seen.
struct MapSight {
  double zoom = 1;  // 1: the whole square
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
};

class MinimapState final : public study::InterfaceState {
 public:
  explicit MinimapState(const study::InterfaceContext& context);

  std::unique_ptr<InterfaceState> clone() const override;
  // Kinds: go happy; point map x y, with value 1 while it is dragged on; heuristic zero;
  // zoom, pan and whole map (aside); and those of the shelf.
  study::Applied apply(const study::ControlInput& input) override;
  void weights(std::int64_t t_us, Eigen::VectorXd& weights) const override;
  std::vector<study::ControlInput> settings() const override;
  void restored(const InterfaceState& left, const Eigen::VectorXd&, std::int64_t) override {
    sight_ = static_cast<const MinimapState&>(left).sight_;
  }

  const MinimapModel& model() const { return *model_; }
  const motion::Minimap& map() const;
  const Shelf& shelf() const { return shelf_; }
  const MapSight& sight() const { return sight_; }
  Eigen::Vector2d point() const;                     // of what is shown
  bool pulled_back() const { return pulled_back_; }  // the last point asked for was not valid
  motion::MapHeuristic heuristic() const { return heuristic_; }
  bool has_switch() const { return has_switch_; }
  bool names_always() const { return names_always_; }
  bool shows_clusters() const { return shows_clusters_; }

 private:
  bool apply_point(const study::ControlInput& input);
  void move_to(const Eigen::Vector2d& point, bool pick, std::int64_t t_us);
  void take_over(std::int64_t t_us);
  study::Applied look(const study::ControlInput& input);
  study::Applied switch_to(const study::ControlInput& input);

  std::shared_ptr<const MinimapModel> model_;
  Eigen::VectorXd start_;
  Shelf shelf_;
  study::Rng rng_;
  motion::MapHeuristic heuristic_;
  bool has_switch_, names_always_, shows_clusters_;
  motion::MapState cursor_;
  bool touched_ = false;  // the cursor was put somewhere
  bool pulled_back_ = false;
  MapSight sight_;
};

}  // namespace promenade::app
