// Every field of the form, by hand: it changes its own key and no other, and undo gives the old
// bytes back.
#include "app/registry.h"
#include "study/toml_parse.h"
#include "tests/app/desk/edit/edit_bench.h"

namespace promenade::app {
namespace {

using study::TomlPath;
using study::TomlValue;

// One of everything, so that every field can be seen.
constexpr const char* full_study = R"([study]
name = "all"
set = "builtin:A"

[[interface]]
name = "labels"

[[interface]]
name = "sliders"
type = "weights"

[[task]]
name = "guess"
kind = "guess"
targets = [{ example = "proud" }, { name = "m", weights = { sad = 0.5, old = 0.5 } }]

[[task]]
name = "match"
kind = "match"
targets = [{ random = "weights", count = 2 }, { example = "sad" }]

[[task]]
name = "find"
kind = "find"
qualities = [{ name = "tired" }]

[[task]]
name = "rate"
kind = "rate"
instrument = "sus"
targets = [{ all = true }, { file = "walks.csv" }, { stimulus = "two" }]

[[questionnaire]]
instrument = "comment"
when = "task"

[[rating]]
item = "liked"
question = "How do you like it?"

[[stimulus]]
name = "one"
graph = "walks.graph"
parts = [{ label = "sad", seconds = 4 }]

[[stimulus]]
name = "two"
graph = "walks.graph"
parts = [{ label = "sad", seconds = 4 }]
)";

// Without what is at the path.
TomlValue without(TomlValue root, const TomlPath& path) {
  study::apply_edit(root, study::remove_value(path));
  const TomlPath table = study::parent_of(path);
  const TomlValue* left = study::value_at(root, table);
  // A section that the change has made.
  if (left != nullptr && left->entries.empty() && left->kind == TomlValue::Kind::table) {
    study::apply_edit(root, study::remove_value(table));
  }
  return root;
}

class EditEveryField : public bench::EditBench {
 protected:
  EditEveryField() : EditBench(full_study) {}

  TomlValue root() const { return study::parse_toml("study.toml", text()); }

  void change(const FormRow& row) {
    const std::string target = study::to_text(row.path);
    switch (row.field.kind) {
      case FieldKind::choice:
      case FieldKind::pick:
      case FieldKind::nesting:
      case FieldKind::source:
        return step(target);
      case FieldKind::flag:
        return click("tick", target);
      case FieldKind::some:
        return click("tick", page_.widgets().find_first("tick", target + "/")->target);
      case FieldKind::words:
      case FieldKind::page:
      case FieldKind::spoken:
        return write(target + "/en", "Words");
      case FieldKind::shares:
        return write(target, "sad 0.25, old 0.75");
      case FieldKind::text:
        return write(target, "other");
      default:
        return write(target, row.field.most > 50 ? "42" : row.field.most == 1 ? "0.75" : "9");
    }
  }
  // Another option by the arrow keys, which work while the list is shut.
  void step(const std::string& target) {
    const std::string before = text();
    page_.focus().take("open", target);
    frames(1);
    key(GLFW_KEY_DOWN);
    if (text() == before) key(GLFW_KEY_UP);
  }

  void expect_only(const FormRow& row, const TomlValue& before) {
    const std::string name = study::to_text(row.path);
    EXPECT_FALSE(study::same_toml(root(), before)) << name << " is as it was";
    TomlValue one = without(before, row.path);
    TomlValue other = without(root(), row.path);
    EXPECT_TRUE(study::same_toml(one, other)) << name << " changed something else";
  }

  void try_rows(std::size_t section, const std::set<std::string>& open) {
    const EditSection& one = edit_sections()[section];
    for (const FormRow& row : form_rows(root(), interfaces(), one, open)) {
      if (row.kind != FormRow::Kind::field) continue;
      const TomlValue before = root();
      const std::string bytes = text();
      change(row);
      expect_only(row, before);
      while (edit_->draft()->can_undo()) control(GLFW_KEY_Z);
      ASSERT_EQ(text(), bytes) << study::to_text(row.path);
    }
  }
  void open_items(std::set<std::string>& open, std::size_t section) {
    for (bool more = true; more;) {
      more = false;
      for (const FormRow& row : form_rows(root(), interfaces(), edit_sections()[section], open)) {
        if (row.kind != FormRow::Kind::item || row.open) continue;
        press("item/" + study::to_text(row.path));
        open.insert(study::to_text(row.path));
        more = true;
        break;
      }
    }
  }
};

TEST_F(EditEveryField, ChangesItsKeyAndNoOther) {
  check();
  for (std::size_t section = 0; section < edit_sections().size(); ++section) {
    click("section", edit_sections()[section].name);
    std::set<std::string> open;
    open_items(open, section);
    try_rows(section, open);
  }
}

}  // namespace
}  // namespace promenade::app
