// The walks of the study on the Edit page as small figures: those that stand, and those that walk.
#pragma once

#include <memory>

#include "app/captions.h"
#include "app/small_figures.h"
#include "study/study.h"

namespace promenade::app {

class EditFigures {
 public:
  // The motions of the study (StudyCheck::motions); null leaves what is there. The same walks stay
  // as they are.
  void follow(const std::shared_ptr<const study::StudyBundle>& motions);
  bool ready() const { return bundle_ != nullptr; }
  const study::StudyBundle& bundle() const { return *bundle_; }
  // In a language of the program.
  const Captions& captions(const std::string& language);

  void advance(std::int64_t now_us);
  // Before each drawing: nothing is asked for.
  void clear();
  // A walk of the set, by its place.
  void stand(const Box& box, const Box& clip, int walk, const Rgb& colour);
  void walk(const Box& box, const Box& clip, int walk, const Rgb& colour);
  void walk(const Box& box, const Box& clip, const Eigen::VectorXd& weights, const Rgb& colour);
  SmallFigures& walking() { return figures_->walking; }
  bool moves() const { return figures_ && figures_->walking.size() > 0; }
  void draw(FigureRenderer& renderer, const Palette& palette);

 private:
  struct Figures {
    explicit Figures(const study::StudyBundle& bundle)
        : mannequin(make_mannequin(bundle.space.set)),
          standing(bundle.bank, mannequin),
          walking(bundle.bank, mannequin) {}
    Mannequin mannequin;
    SmallFigures standing, walking;
  };
  const Eigen::VectorXd& only(int walk);

  std::shared_ptr<const study::StudyBundle> bundle_;  // of the figures
  std::unique_ptr<Figures> figures_;
  std::optional<Captions> captions_;
  Eigen::VectorXd weights_;
  double phase_ = 0;
  std::int64_t last_us_ = 0;
};

}  // namespace promenade::app
