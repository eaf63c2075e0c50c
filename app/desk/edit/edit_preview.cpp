#include "app/desk/edit/edit_preview.h"

#include <algorithm>

#include "app/choice.h"
#include "app/model_tree.h"
#include "app/panel.h"

namespace promenade::app {

namespace {

constexpr int usual_clusters = 4;  // of features, as [O] has them

}  // namespace

// Anew for another interface, and when the file says something else about it.
void EditPreview::begin(const FormPass& pass,
                        const std::shared_ptr<const study::StudyBundle>& bundle) {
  const bool same = bundle == bundle_ && chosen_ == shown_;
  bundle_ = bundle;
  shown_ = chosen_;
  if (same || chosen_ >= bundle_->study.interfaces.size()) return;
  const study::InterfaceUse& use = bundle_->study.interfaces[chosen_];
  weights_ = study::start_weights(bundle_->space);
  state_ = pass.scene.registry.find(use.type)->start(
      {bundle_->space, use.parameters, weights_, bundle_->study.seed, use.model});
}

void EditPreview::draw(const FormPass& pass, const Box& box,
                       const std::shared_ptr<const study::StudyBundle>& bundle,
                       EditFigures& figures) {
  const Ui& ui = pass.ui;
  // The figures follow the newest text, and an interface the last one without errors, which may
  // have been of another set.
  if (bundle == nullptr || bundle->set_sha256 != figures.bundle().set_sha256) {
    draw_paragraphs(ui.look.fonts.text, box.x, box.y + ui.layout.size(8), box.width,
                    ui.look.palette.quiet, pass.words("edit.no_preview"));
    return;
  }
  std::vector<std::string> names;
  for (const study::InterfaceUse& use : bundle->study.interfaces) names.push_back(use.name);
  const std::size_t interfaces = names.size();
  std::vector<Tree> trees;
  if (bundle->adjectives) trees.push_back(Tree::adjectives);
  if (bundle->space.set.size() > 1) trees.push_back(Tree::features);
  for (const Tree tree : trees) {
    names.push_back(
        pass.words(tree == Tree::features ? "edit.feature_tree" : "edit.adjective_tree"));
  }
  if (names.empty()) return;
  chosen_ = std::min(chosen_, names.size() - 1);
  const Box line{box.x, box.y, ui.layout.size(280), ui.layout.size(36)};
  if (const auto picked = drop_down(ui, "preview", line, names, chosen_)) chosen_ = *picked;
  const float top = line.bottom() + ui.layout.size(8);
  const Box rest{box.x, top, box.width, box.bottom() - top};
  begin(pass, bundle);
  if (chosen_ < interfaces) return draw_interface(pass, rest, figures);
  draw_tree(pass, rest, trees[chosen_ - interfaces]);
}

void EditPreview::draw_interface(const FormPass& pass, const Box& box, EditFigures& figures) {
  const Ui& ui = pass.ui;
  const float wide = std::min(ui.layout.size(416), box.width - ui.layout.size(120));
  const Box panel_box{box.right() - wide, box.y, wide, box.height};
  const Box figure{box.x, box.y + 0.2f * box.height, panel_box.x - box.x, 0.6f * box.height};
  fill(panel_box, ui.look.palette.panel);
  const study::InterfacePanel::Content content{
      bundle_->space, figures.captions(pass.words("edit.language")), &figures.walking()};
  changes_.clear();
  study::InterfacePanel panel(ui, panel_box, content, pass.scene.now_us, changes_);
  pass.scene.registry.find(bundle_->study.interfaces[shown_].type)->draw(*state_, panel);
  for (study::ControlInput& change : changes_) {
    change.t_us = pass.scene.now_us;
    state_->apply(change);
  }
  state_->weights(pass.scene.now_us, weights_);
  figures.walk(figure, figure, weights_, ui.look.palette.created);
}

void EditPreview::plant(Tree tree) {
  if (planted_ == bundle_ && planted_tree_ == tree) return;
  planted_ = bundle_;
  planted_tree_ = tree;
  work_.start([bundle = bundle_, tree](const std::stop_token&) {
    return tree == Tree::features ? std::make_shared<ModelEditor>(bundle->space.set, usual_clusters)
                                  : std::make_shared<ModelEditor>(*bundle->adjectives);
  });
}

// The cut can be moved to see what would come of it; the study stays as it is.
void EditPreview::draw_tree(const FormPass& pass, const Box& box, Tree tree) {
  plant(tree);
  if (auto found = work_.news()) tree_ = std::move(*found);
  if (tree_ == nullptr || working()) return;
  fill(box, pass.ui.look.palette.on_colour);
  const float edge = pass.ui.layout.size(8);
  const Box inner{box.x + edge, box.y + edge, box.width - 2 * edge, box.height - 2 * edge};
  const auto cut = draw_model_tree(pass.ui, *tree_, inner, [&](const Box& names, float row) {
    draw_cluster_names(pass.ui, *tree_, names, row);
  });
  if (cut) tree_->cut_at(*cut);
}

}  // namespace promenade::app
