#include "app/desk/edit_line.h"

#include <algorithm>

namespace promenade::app {
namespace {

// Without its line end.
study::Span span_of_line(const std::string& text, int line) {
  const std::size_t begin = study::byte_at(text, {line, 1});
  std::size_t end = std::min(text.find('\n', begin), text.size());
  if (end > begin && text[end - 1] == '\r') --end;
  return {begin, end};
}

}  // namespace

bool EditLine::take(study::StudyDraft& draft) {
  if (written_ == 0) return false;
  const study::Span span = span_of_line(draft.text(), written_);
  written_ = 0;
  std::string text = draft.text();
  text.replace(span.begin, span.end - span.begin, field_.words());
  const bool changed = text != draft.text();
  draft.write(std::move(text));
  return changed;
}

bool EditLine::draw(const FormPass& pass, const Box& box, int line) {
  study::StudyDraft& draft = pass.scene.draft;
  // Another line is chosen: what was written in the one before is not lost.
  bool changed = written_ != line && take(draft);
  const study::Span span = span_of_line(draft.text(), line);
  const std::string label = pass.words.with("edit.line", {{"line", std::to_string(line)}});
  const float wide = pass.ui.layout.size(80);
  draw_line(pass.ui.look.fonts.text, {box.x, box.y, wide, box.height}, pass.ui.look.palette.quiet,
            label);
  const WrittenField::Look look{.target = "file_line",
                                .shown = draft.text().substr(span.begin, span.end - span.begin),
                                .hint = "",
                                .several = false,
                                .keeps = true};
  const bool enter = pass.ui.focus.on("type", "file_line") && key_pressed(ImGuiKey_Enter, false);
  if (field_.draw(pass.ui, {box.x + wide, box.y, box.width - wide, box.height}, look,
                  pass.scene.now_us)) {
    written_ = line;
  }
  if (enter || field_.left()) changed = take(draft) || changed;
  return changed;
}

}  // namespace promenade::app
