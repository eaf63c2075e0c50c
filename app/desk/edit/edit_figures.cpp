#include "app/desk/edit/edit_figures.h"

#include <cmath>

#include "app/figure/view.h"

namespace promenade::app {
namespace {

constexpr double standing_phase = 0.2;  // in mid-stride
constexpr double cycle_s = 1.1;

}  // namespace

void EditFigures::follow(const std::shared_ptr<const study::StudyBundle>& motions) {
  if (motions == nullptr) return;
  if (bundle_ != nullptr && bundle_->set_sha256 == motions->set_sha256) return;
  figures_ = std::make_unique<Figures>(*motions);
  bundle_ = motions;
  captions_.reset();
}

const Captions& EditFigures::captions(const std::string& language) {
  if (!captions_ || captions_->language != language) {
    captions_ = captions_of(study::load_texts(language), bundle_->space.set);
    captions_->language = language;
  }
  return *captions_;
}

void EditFigures::advance(std::int64_t now_us) {
  const auto passed = static_cast<double>(std::min<std::int64_t>(now_us - last_us_, 100'000));
  last_us_ = now_us;
  phase_ = std::fmod(phase_ + 1e-6 * passed / cycle_s, 1.0);
}

void EditFigures::clear() {
  if (!figures_) return;
  figures_->standing.clear();
  figures_->walking.clear();
}

const Eigen::VectorXd& EditFigures::only(int walk) {
  weights_.setZero(bundle_->space.set.size());
  weights_(walk) = 1;
  return weights_;
}

void EditFigures::stand(const Box& box, const Box& clip, int walk, const Rgb& colour) {
  figures_->standing.ask(box, clip, only(walk), colour);
}

void EditFigures::walk(const Box& box, const Box& clip, int walk, const Rgb& colour) {
  figures_->walking.ask(box, clip, only(walk), colour);
}

void EditFigures::walk(const Box& box, const Box& clip, const Eigen::VectorXd& weights,
                       const Rgb& colour) {
  figures_->walking.ask(box, clip, weights, colour);
}

void EditFigures::draw(FigureRenderer& renderer, const Palette& palette) {
  if (!figures_) return;
  figures_->standing.draw(renderer, standing_phase, start_yaw, palette.track);
  figures_->walking.draw(renderer, phase_, start_yaw, palette.track);
}

}  // namespace promenade::app
