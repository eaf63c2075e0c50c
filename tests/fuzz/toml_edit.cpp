// Any text, each of whose values is changed and taken out: refused, or a text that says just that.
#include "study/toml_edit.h"

#include <cstdint>
#include <cstdlib>

#include "motion/problem.h"
#include "study/toml_parse.h"
#include "study/toml_spans.h"

namespace {

using namespace promenade;
using namespace promenade::study;

void collect(const TomlValue& value, const TomlPath& path, std::vector<TomlPath>& paths) {
  constexpr std::size_t most = 40;
  if (paths.size() >= most) return;
  paths.push_back(path);
  for (const auto& entry : value.entries) collect(entry.value, joined(path, entry.key), paths);
  for (std::size_t i = 0; i < value.elements.size(); ++i) {
    collect(value.elements[i], joined(path, i), paths);
  }
}

void edit(const std::string& text, const TomlValue& root, const TomlEdit& edit) {
  try {
    const std::string result = edited_toml("fuzz.toml", text, edit);
    TomlValue wanted = root;
    if (!apply_edit(wanted, edit)) std::abort();
    if (edit.kind == TomlEdit::Kind::remove) return;  // the last [[block]] takes its list along
    if (!same_toml(parse_toml("fuzz.toml", result), wanted)) std::abort();
  } catch (const InputError&) {
    // Refused with a sentence: that is what should happen.
  }
}

void edit_everything(const std::string& text) {
  const TomlValue root = parse_toml("fuzz.toml", text);
  std::vector<TomlPath> paths;
  collect(root, {}, paths);
  for (const TomlPath& path : paths) {
    edit(text, root, set_value(path, toml_text("\"a\nb\\")));
    edit(text, root, set_value(joined(path, "new key"), toml_number(0.5)));
    edit(text, root, remove_value(path));
    edit(text, root, insert_value(path, 0, toml_table({{"name", toml_text("x")}})));
    edit(text, root, insert_value(path, 1, toml_boolean(true)));
    edit(text, root, move_value(path, 0, 1));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t longest = 4096;
  const std::string text(reinterpret_cast<const char*>(data), std::min(size, longest));
  const TomlSpans spans = scan_toml(text);
  for (std::size_t at = 0; at < text.size(); at += 7) span_of(spans, path_at(spans, at));
  try {
    edit_everything(text);
  } catch (const InputError&) {
    // No TOML.
  }
  return 0;
}
