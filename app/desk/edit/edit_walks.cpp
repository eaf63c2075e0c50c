#include "app/desk/edit/edit_walks.h"

#include <algorithm>
#include <cmath>

#include "app/choice.h"
#include "app/scroll_area.h"

namespace promenade::app {
namespace {

using study::TomlPath;
using study::TomlValue;

// A task that can have a walk as its target.
struct TargetTask {
  std::string name;
  TomlPath targets;
};

std::vector<TargetTask> target_tasks(const TomlValue& root) {
  std::vector<TargetTask> found;
  const TomlValue* tasks = study::find_key(root, "task");
  if (tasks == nullptr) return found;
  for (std::size_t i = 0; i < tasks->elements.size(); ++i) {
    const TomlValue* kind = study::find_key(tasks->elements[i], "kind");
    const bool finds = kind != nullptr && kind->text == "find";
    const TomlValue* start = study::find_key(tasks->elements[i], "start");
    const bool has_own = start == nullptr || start->text == "average";
    if (finds || !has_own) continue;
    found.push_back({title_of(tasks->elements[i]), {"task", i, "targets"}});
  }
  return found;
}

std::vector<std::string> target_walks(const TomlValue& root) {
  std::vector<std::string> walks;
  for (const TargetTask& task : target_tasks(root)) {
    const TomlValue* targets = study::value_at(root, task.targets);
    if (targets == nullptr) continue;
    for (const TomlValue& target : targets->elements) {
      const TomlValue* example = study::find_key(target, "example");
      if (example != nullptr) walks.push_back(example->text);
    }
  }
  return walks;
}

}  // namespace

void EditWalks::draw(const FormPass& pass, const Box& box, EditFigures& figures) {
  const Ui& ui = pass.ui;
  targets_ = target_walks(pass.root());
  hovered_.clear();
  walking_.clear();
  const float foot = ui.layout.size(52);
  const Box view{box.x, box.y, box.width, box.height - foot};
  const float bar = ImGui::GetStyle().ScrollbarSize;
  const int count = figures.bundle().space.set.size();
  const int columns = std::max(1, static_cast<int>((view.width - bar) / ui.layout.size(108)));
  const float width = std::floor((view.width - bar) / static_cast<float>(columns));
  const int rows = (count + columns - 1) / columns;
  // A few are larger.
  const float height = std::floor(
      std::clamp(view.height / static_cast<float>(rows), ui.layout.size(136), 1.7f * width));
  const std::vector<int>& by_name = figures.captions(pass.words("edit.language")).by_name;
  go_by_key(ui, figures, by_name, columns);
  scrolled("walks", view, static_cast<float>(rows) * height, [&](const Box& inner) {
    for (int k = 0; k < count; ++k) {
      const int column = k % columns;
      const int row = k / columns;
      const Box tile{inner.x + static_cast<float>(column) * width,
                     inner.y + static_cast<float>(row) * height, width, height};
      draw_tile(pass, tile, view, by_name[static_cast<std::size_t>(k)], figures);
    }
  });
  draw_foot(pass, {box.x, view.bottom(), box.width, foot});
}

void EditWalks::go_by_key(const Ui& ui, const EditFigures& figures, const std::vector<int>& order,
                          int columns) {
  const auto target = [&](int k) {
    const auto walk = static_cast<std::size_t>(order[static_cast<std::size_t>(k)]);
    return "walk/" + figures.bundle().space.set.cycles[walk].name;
  };
  int by = 0;
  if (key_pressed(ImGuiKey_RightArrow)) by = 1;
  if (key_pressed(ImGuiKey_LeftArrow)) by = -1;
  if (key_pressed(ImGuiKey_DownArrow)) by = columns;
  if (key_pressed(ImGuiKey_UpArrow)) by = -columns;
  if (by == 0 || !ui.focus.on_first("press", "walk/")) return;
  const int count = static_cast<int>(order.size());
  for (int k = 0; k < count; ++k) {
    if (!ui.focus.on("press", target(k))) continue;
    if (k + by >= 0 && k + by < count) ui.focus.write_in("press", target(k + by));
    return;
  }
}

void EditWalks::draw_tile(const FormPass& pass, const Box& tile, const Box& view, int walk,
                          EditFigures& figures) {
  const Ui& ui = pass.ui;
  const Palette& palette = ui.look.palette;
  const auto place = static_cast<std::size_t>(walk);
  const std::string& name = figures.bundle().space.set.cycles[place].name;
  const float edge = ui.layout.size(3);
  const Box frame_box{tile.x + edge, tile.y + edge, tile.width - 2 * edge, tile.height - 2 * edge};
  const std::string target = "walk/" + name;
  if (app::tile(ui, "press", target, frame_box)) chosen_ = name;
  if (name == chosen_) frame(frame_box, palette.created, ui.layout.size(3));
  const float caption = ui.layout.size(24);
  const Box words{frame_box.x + edge, frame_box.bottom() - caption - edge,
                  frame_box.width - 2 * edge, caption};
  const bool is_target = std::find(targets_.begin(), targets_.end(), name) != targets_.end();
  if (is_target) {
    fill({frame_box.x + edge, frame_box.y + edge, ui.layout.size(12), ui.layout.size(12)},
         palette.target);
  }
  draw_line(name == chosen_ ? ui.look.fonts.bold : ui.look.fonts.text, words, palette.text,
            figures.captions(pass.words("edit.language")).names[place], Align::centre);
  if (tile.bottom() < view.y || tile.y > view.bottom()) return;
  const Box body{frame_box.x, frame_box.y, frame_box.width, words.y - frame_box.y};
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool under = tile.holds(mouse.x, mouse.y) && view.holds(mouse.x, mouse.y);
  if (under) hovered_ = name;
  if (under || ui.focus.on("press", target)) {
    walking_.push_back(name);
    figures.walk(body, view, walk, palette.created);
  } else {
    figures.stand(body, view, walk, palette.example);
  }
}

void EditWalks::draw_foot(const FormPass& pass, const Box& box) {
  const Ui& ui = pass.ui;
  const std::vector<TargetTask> tasks = target_tasks(pass.root());
  const float high = ui.layout.size(40);
  const float y = box.bottom() - high;
  const float press = ui.layout.size(176);
  const float list = ui.layout.size(160);
  const float gap = ui.layout.size(8);
  const Box words{box.x, y, box.width - press - list - 2 * gap, high};
  if (chosen_.empty() || tasks.empty()) {
    draw_line(ui.look.fonts.text, {box.x, y, box.width, high}, ui.look.palette.quiet,
              tasks.empty()      ? pass.words("edit.no_task")
              : hovered_.empty() ? pass.words("edit.choose_walk")
                                 : hovered_);
    return;
  }
  draw_line(ui.look.fonts.bold, words, ui.look.palette.text, chosen_);
  const float said =
      std::min(text_width(ui.look.fonts.bold, chosen_), words.width) + ui.layout.size(16);
  if (hovered_ != chosen_) {
    draw_line(ui.look.fonts.text, {words.x + said, y, words.width - said, high},
              ui.look.palette.quiet, hovered_);
  }
  std::vector<std::string> names;
  for (const TargetTask& task : tasks) names.push_back(task.name);
  task_ = std::min(task_, tasks.size() - 1);
  const Box choice{words.right() + gap, y, list, high};
  if (const auto picked = drop_down(ui, "target_task", choice, names, task_)) task_ = *picked;
  if (!button(ui, "use_walk", {choice.right() + gap, y, press, high}, pass.words("edit.use_walk"),
              ButtonKind::filled)) {
    return;
  }
  const TomlValue* targets = study::value_at(pass.root(), tasks[task_].targets);
  const std::size_t end = targets != nullptr ? targets->elements.size() : 0;
  const TomlValue target = study::toml_table({{"example", study::toml_text(chosen_)}});
  pass.scene.draft.change(study::insert_value(tasks[task_].targets, end, target));
}

}  // namespace promenade::app
