// Small walking figures inside panels. A panel asks for them while it is drawn; in the
// next frame they walk there, under what the panel draws, in step with the large ones.
#pragma once

#include "app/figure/renderer.h"
#include "motion/pose_blender.h"

namespace promenade::app {

// One of them: parts that stand about the origin, on a disc in the colour of the ground.
void draw_small_figure(FigureRenderer& renderer, const Box& box, const Box& clip, double height,
                       const std::vector<Part>& parts, const Rgb& colour, const Rgb& ground);
Box common_box(const Box& a, const Box& b);  // what lies in both

class SmallFigures {
 public:
  // Both outlive it.
  SmallFigures(const motion::PoseBank& bank, const Mannequin& mannequin)
      : bank_(bank), mannequin_(mannequin) {}

  // A figure of N weights within `box`, pixels; nothing of it is drawn outside `clip`.
  void ask(const Box& box, const Box& clip, const Eigen::VectorXd& weights, const Rgb& colour);
  void clear() { used_ = 0; }
  std::size_t size() const { return used_; }

  // All that were asked for, at one phase (0 to 1) and turned by `yaw` (radians), each on a
  // disc in the colour of the ground.
  void draw(FigureRenderer& renderer, double phase, float yaw, const Rgb& ground);

 private:
  struct Figure {
    Box box, clip;
    Rgb colour;
    motion::PoseBlend blend;
  };
  const motion::PoseBank& bank_;
  const Mannequin& mannequin_;
  std::vector<Figure> figures_;  // the first `used_` are wanted; all keep their memory
  std::size_t used_ = 0;
  motion::Pose pose_;
  std::vector<Part> parts_;
};

}  // namespace promenade::app
