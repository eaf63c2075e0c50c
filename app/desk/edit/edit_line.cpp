#include "app/desk/edit/edit_line.h"

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

std::string line_of(const std::string& text, int line) {
  const study::Span span = span_of_line(text, line);
  return text.substr(span.begin, span.end - span.begin);
}

}  // namespace

// Not where the line is another one meanwhile: the file was read again.
bool EditLine::waits(const study::StudyDraft& draft) const {
  return written_ != 0 && line_of(draft.text(), written_) == before_;
}

bool EditLine::differs(const study::StudyDraft& draft) const {
  return waits(draft) && field_.words() != before_;
}

bool EditLine::take(study::StudyDraft& draft) {
  const bool waited = waits(draft);
  const study::Span span = span_of_line(draft.text(), std::max(written_, 1));
  written_ = 0;
  if (!waited) return false;
  field_.accept(field_.words());  // whoever goes on writing there goes on
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
  const std::string now = line_of(draft.text(), line);
  const std::string label = pass.words.with("edit.line", {{"line", std::to_string(line)}});
  const float wide = pass.ui.layout.size(80);
  draw_line(pass.ui.look.fonts.text, {box.x, box.y, wide, box.height}, pass.ui.look.palette.quiet,
            label);
  const WrittenField::Look look{
      .target = "file_line", .shown = now, .hint = "", .several = false, .keeps = true};
  const bool enter = pass.ui.focus.on("type", "file_line") && key_pressed(ImGuiKey_Enter, false);
  if (field_.draw(pass.ui, {box.x + wide, box.y, box.width - wide, box.height}, look,
                  pass.scene.now_us)) {
    written_ = line;
    before_ = now;
  }
  if (enter || field_.left()) changed = take(draft) || changed;
  return changed;
}

}  // namespace promenade::app
