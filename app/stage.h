// The figures of a page: which cycles, at which phase, seen how. Owns what walks
// on; draws with the renderer.
#pragma once

#include <cstdint>

#include "app/figure/renderer.h"
#include "app/layout.h"
#include "app/look.h"
#include "app/small_figures.h"
#include "app/stimulus_stage.h"

namespace promenade::app {

enum class Role { target, created, reference };
inline constexpr std::array<Role, 3> roles = {Role::target, Role::reference, Role::created};

const Rgb& colour_of(const Palette& palette, Role role);

// What is to be seen: null figures are not there.
struct Cast {
  const motion::Cycle* target = nullptr;
  const motion::Cycle* created = nullptr;
  const motion::Cycle* reference = nullptr;
  bool blind = false;                         // the created figure has its place, but is not shown
  const study::Stimulus* stimulus = nullptr;  // takes the place of the target
  double stimulus_s = 0;                      // seconds of it, with all repetitions
};

struct Pace {
  bool playing = true;
  double speed = 1;  // 1: as in life
  bool operator==(const Pace&) const = default;
};

class Stage {
 public:
  // `travels`: the figures walk over the ground; else on the spot. A cast has no other stimuli
  // than these.
  Stage(const motion::MotionSet& set, const motion::PoseBank& bank, bool travels = true,
        const StimulusList& stimuli = {});

  // One step of time. All walk at one phase, so that a change of weights never makes a
  // figure jump. The target sets the pace, since what is to be matched must not change
  // with the controls; alone, the created figure walks at its own. A reference is a
  // yardstick of tempo, too: it walks in its own time.
  void advance(std::int64_t now_us, const Cast& cast);
  // The same in two halves: so many seconds of life pass, as slowly as the pace says (the
  // rotations of the cycles are not needed); and the figures are as they now are.
  void walk(double seconds, const Cast& cast);
  void pose(const Cast& cast);
  void restart();  // as if nothing had walked yet
  // Time passed in which nothing moved.
  void rest(std::int64_t now_us) { last_us_ = now_us; }
  void draw(FigureRenderer& renderer, const Layout& layout, const StagePlan& plan,
            const Palette& palette);
  void draw_small(FigureRenderer& renderer, const Palette& palette);

  Orbit& orbit() { return orbit_; }
  Pace& pace() { return pace_; }
  SmallFigures& small_figures() { return small_; }
  // Of the walk, 0 to 1; of a stimulus the share of it that was shown.
  double phase() const { return stimulus_share_.value_or(phase_); }
  // A stimulus stands where the session says.
  void scrub(double phase) { phase_ = phase; }
  bool shows(Role role) const { return figure(role).present; }
  // What is drawn of it: metres, about its spot.
  const std::vector<Part>& parts(Role role) const { return figure(role).parts; }
  // Is there only its place?
  bool hides(Role role) const { return figure(role).present && figure(role).hidden; }
  // Under the feet of a figure, where its plate goes: pixels.
  Eigen::Vector2f plate(const StagePlan& plan, Role role) const;

 private:
  struct Figure {
    bool present = false, hidden = false;
    std::vector<Part> parts;
    Shadow shadow;
    double height = 0;                                 // metres
    Eigen::Vector2f travel = Eigen::Vector2f::Zero();  // metres
    View view;
  };
  const Figure& figure(Role role) const { return figures_[static_cast<std::size_t>(role)]; }
  Figure& figure(Role role) { return figures_[static_cast<std::size_t>(role)]; }
  double walked(const motion::Cycle& cycle, double phase, double seconds) const;
  void enter(const Cast& cast);
  void go(Figure& figure, const motion::Cycle* cycle, double before, double phase);
  void pose(Figure& figure, const motion::Cycle* cycle, double phase);
  void pose(Figure& figure, const study::Stimulus& stimulus, double seconds);
  void place(Figure& figure, const Mannequin& mannequin);
  Box spot(const Box& stage, Role role) const;
  void draw_ground(FigureRenderer& renderer, const Layout& layout, const StagePlan& plan,
                   const Palette& palette, Role role);

  const motion::MotionSet& set_;
  bool travels_;
  Mannequin mannequin_;
  SmallFigures small_;
  StimulusFigures stimuli_;
  Orbit orbit_;
  Pace pace_;
  double phase_ = 0, reference_phase_ = 0;
  std::optional<double> stimulus_share_;  // of the stimulus that is shown; nothing: none is
  std::int64_t last_us_ = -1;
  std::array<Figure, 3> figures_;
  motion::Pose pose_;
  motion::WorldPose world_;
};

}  // namespace promenade::app
