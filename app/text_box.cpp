#include "app/text_box.h"

#include <algorithm>
#include <cmath>

namespace promenade::app {
namespace {

struct Writing {
  Draft& draft;
  int most;
  bool goes_on;  // what is there stays: writing begins behind it
};

void put_caret(ImGuiInputTextCallbackData* data, std::size_t at) {
  data->CursorPos = data->SelectionStart = data->SelectionEnd = static_cast<int>(at);
}

// Dear ImGui asks after each edit, else once a frame.
int mind(ImGuiInputTextCallbackData* data) {
  const auto& writing = *static_cast<const Writing*>(data->UserData);
  WrittenText& text = writing.draft.text;
  const std::string_view now(data->Buf, static_cast<std::size_t>(data->BufTextLen));
  if (data->EventFlag == ImGuiInputTextFlags_CallbackEdit) {
    const std::size_t caret =
        text.edited(now, static_cast<std::size_t>(data->CursorPos), writing.most);
    writing.draft.changed = true;
    if (now != text.shown()) {
      data->DeleteChars(0, data->BufTextLen);
      data->InsertChars(0, text.shown().c_str());
    }
    put_caret(data, caret);
  } else if (writing.goes_on) {
    put_caret(data, now.size());
  }
  text.stand_at(static_cast<std::size_t>(data->CursorPos));
  return 0;
}

// Between Dear ImGui's frame and the words.
float inset(const Ui& ui) { return ui.layout.size(10); }

void input(const Ui& ui, const Box& box, const TextBoxOptions& options, Writing& writing) {
  // What a callback changes, Dear ImGui cannot undo.
  constexpr ImGuiInputTextFlags flags = ImGuiInputTextFlags_CallbackEdit |
                                        ImGuiInputTextFlags_CallbackAlways |
                                        ImGuiInputTextFlags_NoUndoRedo;
  std::vector<char>& buffer = writing.draft.buffer;
  const float pad =
      options.several ? inset(ui) : std::round(0.5f * (box.height - ImGui::GetFontSize()));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {inset(ui), pad});
  ImGui::PushStyleColor(ImGuiCol_FrameBg, 0);
  ImGui::SetCursorScreenPos({box.x, box.y});
  if (options.several) {
    ImGui::InputTextMultiline("", buffer.data(), buffer.size(), {box.width, box.height}, flags,
                              mind, &writing);
  } else {
    ImGui::SetNextItemWidth(box.width);
    ImGui::InputText("", buffer.data(), buffer.size(), flags, mind, &writing);
  }
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

// Room for the line ends, too.
void fill_buffer(Draft& draft, int most) {
  draft.buffer.resize(static_cast<std::size_t>(most) * 8 + 8);
  const std::string& shown = draft.text.shown();
  std::copy(shown.begin(), shown.end(), draft.buffer.begin());
  draft.buffer[shown.size()] = 0;
}

void write(const Ui& ui, std::string_view target, const Box& box, Draft& draft,
           const TextBoxOptions& options) {
  ImFont* const font = ui.look.fonts.text;
  const bool focused = place(ui, "type", target, box);
  const float room = box.width - 2 * inset(ui) - ImGui::GetStyle().ScrollbarSize;
  draft.text.fit(options.several ? room : 0,
                 [font](std::string_view text) { return text_width(font, text); });
  if (!draft.active) fill_buffer(draft, options.most);
  Writing writing{draft, options.most, focused && ui.focus.goes_on() && !draft.active};
  draft.changed = false;
  ImGui::PushFont(font);
  ImGui::PushID(target.data(), target.data() + target.size());
  if (focused && ui.focus.arrived()) ImGui::SetKeyboardFocusHere();
  input(ui, box, options, writing);
  if (ImGui::IsItemActivated() && !focused) ui.focus.take("type", target);
  draft.entered = !options.several && draft.active && key_pressed(ImGuiKey_Enter, false);
  draft.active = ImGui::IsItemActive();
  ImGui::PopID();
  ImGui::PopFont();
}

// Where the first line is written.
void draw_hint(const Ui& ui, const Box& box, const char* hint) {
  const float height = std::min(box.height, ui.layout.size(40));
  draw_line(ui.look.fonts.text, {box.x + inset(ui), box.y, box.width - 2 * inset(ui), height},
            ui.look.palette.quiet, hint);
}

}  // namespace

void text_box(const Ui& ui, std::string_view target, const Box& box, Draft& draft,
              const TextBoxOptions& options, std::int64_t now_us) {
  const Palette& palette = ui.look.palette;
  fill(box, palette.on_colour);
  if (!ui.inert) write(ui, target, box, draft, options);
  if (draft.changed) draft.changed_us = now_us;
  frame(box, draft.active ? palette.created : palette.quiet, ui.layout.size(1));
  if (!draft.active && draft.text.words().empty()) draw_hint(ui, box, options.hint);
}

}  // namespace promenade::app
