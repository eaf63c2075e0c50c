// Random edits of every file in configs/.
#include <gtest/gtest.h>

#include <filesystem>

#include "motion/files.h"
#include "motion/problem.h"
#include "motion/rng.h"
#include "study/toml_edit.h"
#include "study/toml_parse.h"
#include "study/toml_spans.h"
#include "tests/source_dir.h"

namespace promenade::study {
namespace {

void collect(const TomlValue& value, const TomlPath& path, std::vector<TomlPath>& paths) {
  if (!path.empty()) paths.push_back(path);
  for (const auto& entry : value.entries) collect(entry.value, joined(path, entry.key), paths);
  for (std::size_t i = 0; i < value.elements.size(); ++i) {
    collect(value.elements[i], joined(path, i), paths);
  }
}

TomlValue some_value(motion::Rng& rng) {
  switch (rng.below(6)) {
    case 0:
      return toml_text("say \"これ\" #\\");
    case 1:
      return toml_text("two\nlines");
    case 2:
      return toml_number(rng.normal());
    case 3:
      return toml_boolean(rng.below(2) == 0);
    case 4:
      return toml_texts({"a", "b"});
    default:
      return toml_table({{"x y", toml_integer(-3)}, {"z", toml_table({})}});
  }
}

TomlEdit some_edit(const TomlValue& root, const std::vector<TomlPath>& paths, motion::Rng& rng) {
  const TomlPath& path = paths[rng.below(paths.size())];
  const TomlValue& value = *value_at(root, path);
  if (value.kind == TomlValue::Kind::array && rng.below(2) == 0) {
    const std::size_t count = value.elements.size();
    if (count > 1 && rng.below(2) == 0) return move_value(path, rng.below(count), rng.below(count));
    return insert_value(path, rng.below(count + 1), some_value(rng));
  }
  if (value.kind == TomlValue::Kind::table && rng.below(2) == 0) {
    return set_value(joined(path, "new key"), some_value(rng));
  }
  if (rng.below(4) == 0) return remove_value(path);
  return set_value(path, some_value(rng));
}

// As many as there are; each file with other line ends, too.
std::vector<std::string> texts_of_configs() {
  std::vector<std::string> texts;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(source_dir() / "configs")) {
    if (entry.path().extension() != ".toml") continue;
    texts.push_back(read_file(entry.path().string()));
    std::string with_returns = "\xEF\xBB\xBF";
    for (const char letter : texts.back()) {
      if (letter == '\n') with_returns += '\r';
      with_returns += letter;
    }
    texts.push_back(with_returns);
  }
  return texts;
}

// Nothing where it was refused.
std::string edited_or_refused(const std::string& text, const TomlEdit& edit) {
  try {
    return edited_toml("config.toml", text, edit);
  } catch (const InputError&) {
    return "";
  }
}

// What both texts begin and end with makes up the whole old text but for the value.
void expect_only_the_value_differs(const std::string& text, const std::string& result, Span span) {
  EXPECT_EQ(text.substr(0, span.begin), result.substr(0, span.begin));
  const std::size_t rest = text.size() - span.end;
  EXPECT_EQ(text.substr(span.end), result.substr(result.size() - rest));
}

TEST(TomlEdit, ChangesOneThingInEveryFileOfTheProgram) {
  motion::Rng rng(7, 0, "toml edits");
  int done = 0, refused = 0;
  for (std::string text : texts_of_configs()) {
    for (int k = 0; k < 12; ++k) {
      TomlValue root = parse_toml("config.toml", text);
      std::vector<TomlPath> paths;
      collect(root, {}, paths);
      const TomlEdit edit = some_edit(root, paths, rng);
      const std::string result = edited_or_refused(text, edit);
      ++(result.empty() ? refused : done);
      if (result.empty()) continue;
      ASSERT_TRUE(apply_edit(root, edit));
      if (edit.kind == TomlEdit::Kind::remove && !value_at(root, parent_of(edit.path))) continue;
      text = result;
    }
  }
  // Whole sections are no values: those may be refused.
  EXPECT_LT(refused, done / 4) << refused << " of " << done;
}

TEST(TomlEdit, KeepsEveryByteBesideTheValue) {
  motion::Rng rng(8, 0, "toml edits");
  for (const std::string& text : texts_of_configs()) {
    const TomlValue root = parse_toml("config.toml", text);
    const TomlSpans spans = scan_toml(text);
    std::vector<TomlPath> paths;
    collect(root, {}, paths);
    for (int k = 0; k < 12; ++k) {
      const TomlPath& path = paths[rng.below(paths.size())];
      const auto held = find_node(spans, path);
      if (!held) continue;
      const std::string result = edited_or_refused(text, set_value(path, some_value(rng)));
      ASSERT_FALSE(result.empty()) << to_text(path);
      expect_only_the_value_differs(text, result, *held->node);
    }
  }
}

}  // namespace
}  // namespace promenade::study
