// The figures of a page: which cycles, at which phase, seen how. Owns what walks
// on; draws with the renderer.
#pragma once

#include <cstdint>

#include "app/figure/renderer.h"
#include "app/layout.h"
#include "app/look.h"

namespace promenade::app {

enum class Role { target, created };

class Stage {
 public:
  explicit Stage(const motion::MotionSet& set);

  // One step of time with what is on stage: null figures are not there. Both walk
  // at one phase; how fast is the created one's affair, so that a change of its
  // weights never makes a figure jump.
  void advance(std::int64_t now_us, const motion::Cycle* target, const motion::Cycle* created);
  void draw(FigureRenderer& renderer, const Layout& layout, const Palette& palette);

  Orbit& orbit() { return orbit_; }
  double phase() const { return phase_; }
  bool shows(Role role) const { return figure(role).present; }
  // Under the feet of a figure, where its plate goes: pixels.
  Eigen::Vector2f plate(const Layout& layout, Role role) const;

 private:
  struct Figure {
    bool present = false;
    std::vector<Part> parts;
    Shadow shadow;
    Eigen::Vector2f travel = Eigen::Vector2f::Zero();  // metres
    View view;
  };
  const Figure& figure(Role role) const { return figures_[role == Role::target ? 0 : 1]; }
  void pose(Figure& figure, const motion::Cycle* cycle, double seconds);
  Box spot(const Layout& layout, Role role) const;

  const motion::MotionSet& set_;
  Mannequin mannequin_;
  Orbit orbit_;
  double phase_ = 0;
  std::int64_t last_us_ = -1;
  std::array<Figure, 2> figures_;
};

}  // namespace promenade::app
