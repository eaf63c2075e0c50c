#include "app/desk/edit_preview.h"

#include <algorithm>

#include "app/choice.h"
#include "app/panel.h"

namespace promenade::app {

// Anew for another interface, and when the file says something else about it.
void EditPreview::begin(const FormPass& pass,
                        const std::shared_ptr<const study::StudyBundle>& bundle) {
  if (state_ && bundle == bundle_ && chosen_ == shown_) return;
  bundle_ = bundle;
  shown_ = chosen_;
  const study::InterfaceUse& use = bundle_->study.interfaces[chosen_];
  weights_ = study::start_weights(bundle_->space);
  state_ = pass.scene.registry.find(use.type)->start(
      {bundle_->space, use.parameters, weights_, bundle_->study.seed, use.model});
}

void EditPreview::draw(const FormPass& pass, const Box& box,
                       const std::shared_ptr<const study::StudyBundle>& bundle,
                       EditFigures& figures) {
  const Ui& ui = pass.ui;
  if (bundle == nullptr || bundle->study.interfaces.empty()) {
    draw_paragraphs(ui.look.fonts.text, box.x, box.y + ui.layout.size(8), box.width,
                    ui.look.palette.quiet, pass.words("edit.no_preview"));
    return;
  }
  std::vector<std::string> names;
  for (const study::InterfaceUse& use : bundle->study.interfaces) names.push_back(use.name);
  chosen_ = std::min(chosen_, names.size() - 1);
  const Box line{box.x, box.y, ui.layout.size(240), ui.layout.size(36)};
  if (const auto picked = drop_down(ui, "preview", line, names, chosen_)) chosen_ = *picked;
  begin(pass, bundle);
  const float top = line.bottom() + ui.layout.size(8);
  const float wide = std::min(ui.layout.size(416), box.width - ui.layout.size(120));
  const Box panel_box{box.right() - wide, top, wide, box.bottom() - top};
  const Box figure{box.x, top + 0.2f * panel_box.height, panel_box.x - box.x,
                   0.6f * panel_box.height};
  fill(panel_box, ui.look.palette.panel);
  const study::InterfacePanel::Content content{
      bundle->space, figures.captions(pass.words("edit.language")), &figures.walking()};
  changes_.clear();
  study::InterfacePanel panel(ui, panel_box, content, pass.scene.now_us, changes_);
  pass.scene.registry.find(bundle->study.interfaces[chosen_].type)->draw(*state_, panel);
  for (study::ControlInput& change : changes_) {
    change.t_us = pass.scene.now_us;
    state_->apply(change);
  }
  state_->weights(pass.scene.now_us, weights_);
  figures.walk(figure, figure, weights_, ui.look.palette.created);
}

}  // namespace promenade::app
