#include "app/desk/takes/takes_stage.h"

#include <cmath>

namespace promenade::app {
namespace {

Box half_of(const Box& box, bool right) {
  const float half = std::round(box.width / 2);
  return right ? Box{box.x + half, box.y, box.width - half, box.height}
               : Box{box.x, box.y, half, box.height};
}

void draw_one(FigureRenderer& renderer, const Gui& gui, const Orbit& orbit, const Box& box,
              double height, const FigureMoment& now, const Rgb& colour) {
  const View view = make_view(orbit, height, 0.68f * box.height,
                              {box.middle_x(), box.bottom() - 0.2f * box.height}, box);
  renderer.draw_ground(view,
                       {.ring = colour,
                        .travel = now.travel,
                        .yaw = start_yaw + orbit.yaw,
                        .stroke = gui.layout().scale},
                       now.shadow);
  renderer.draw_parts(view, now.parts, colour);
}

}  // namespace

// Figures are made for what is looked at now.
void TakesStage::follow() {
  const std::optional<std::size_t> now = work_.take();
  const auto review = now ? work_.shop().review(*now) : nullptr;
  if (!review) {
    take_.reset();
  } else if (!take_ || &take_->review() != review.get()) {
    take_ = std::make_unique<TakeFigure>(review);
  }
  const std::optional<study::WalkPlace> walk = work_.walk();
  const auto loop = walk ? work_.loop(*walk) : nullptr;
  if (!loop || !review) {
    loop_.reset();
  } else if (!loop_ || &loop_->loop() != loop.get()) {
    loop_ = std::make_unique<LoopFigure>(loop);
  }
}

void TakesStage::draw_figures(FigureRenderer& renderer, const Gui& gui) {
  if (box_.width < 1) return;
  follow();
  if (!take_) return;
  const Palette& palette = gui.look().palette;
  const float yaw = start_yaw + orbit_.yaw;
  take_->pose(work_.frame(), yaw, take_now_);
  const Box left = loop_ ? half_of(box_, false) : box_;
  draw_one(renderer, gui, orbit_, left, take_->height(), take_now_, palette.quiet);
  if (!loop_) return;
  // In step with the take where that goes through the loop.
  const double seconds =
      (work_.frame() - loop_->loop().cut.first()) * take_->review().take.frame_time;
  loop_->pose(seconds + 100 * loop_->seconds(), yaw, loop_now_);
  draw_one(renderer, gui, orbit_, half_of(box_, true), loop_->height(), loop_now_, palette.created);
}

void TakesStage::draw_plate(const Ui& ui, const Box& half, std::string_view label,
                            const Rgb& colour) const {
  const float most = half.width - ui.layout.size(16);
  const float wide =
      std::min(most, std::round(text_width(ui.look.fonts.bold, label)) + ui.layout.size(28));
  const Box plate{std::round(half.middle_x() - wide / 2), half.bottom() - ui.layout.size(42), wide,
                  ui.layout.size(30)};
  fill(plate, colour);
  draw_line(ui.look.fonts.bold,
            {plate.x + ui.layout.size(12), plate.y, plate.width - ui.layout.size(20), plate.height},
            ink_on(ui.look.palette, colour), label, Align::left);
}

void TakesStage::draw(const Ui& ui, const study::Texts& words, const Box& box,
                      const std::string& name) {
  box_ = box;
  follow();
  const PlaneTouch touch = plane(ui, "stage", "stage", box, {0, 0}, {1, 1});
  if (touch.held) orbit_.yaw += 0.008f * touch.moved.x() / ui.layout.scale;
  if (touch.focused && key_pressed(ImGuiKey_LeftArrow)) orbit_.yaw -= 0.1f;
  if (touch.focused && key_pressed(ImGuiKey_RightArrow)) orbit_.yaw += 0.1f;
  if (!take_) return;
  const Palette& palette = ui.look.palette;
  draw_plate(ui, loop_ ? half_of(box, false) : box, words.with("takes.the_take", {{"name", name}}),
             palette.quiet);
  if (loop_) draw_plate(ui, half_of(box, true), words("takes.the_loop"), palette.created);
}

}  // namespace promenade::app
