#include "app/desk/edit/edit_rows.h"

#include "app/desk/edit/edit_values.h"

namespace promenade::app {
namespace {

using study::TomlPath;
using study::TomlValue;

class Rows {
 public:
  Rows(const TomlValue& root, const study::InterfaceRegistry& registry,
       const std::set<std::string>& open)
      : root_(root), registry_(registry), open_(open) {}

  void add(const EditField& field, const TomlPath& table, int depth) {
    const TomlPath path = study::joined(table, study::toml_path(field.key));
    if (field.kind == FieldKind::list) return add_list(field, path, depth);
    rows_.push_back({FormRow::Kind::field, field, path, depth});
  }
  std::vector<FormRow> take() { return std::move(rows_); }

 private:
  void add_list(const EditField& field, const TomlPath& path, int depth) {
    const TomlValue* list = study::value_at(root_, path);
    const std::size_t count = list != nullptr ? list->elements.size() : 0;
    rows_.push_back({FormRow::Kind::list, field, path, depth, 0, count});
    for (std::size_t i = 0; i < count; ++i) {
      add_item(field, list->elements[i], study::joined(path, i), depth, i, count);
    }
    rows_.push_back({FormRow::Kind::add, field, path, depth, count, count});
  }

  void add_item(const EditField& field, const TomlValue& item, const TomlPath& path, int depth,
                std::size_t index, std::size_t count) {
    const bool open = open_.contains(study::to_text(path));
    rows_.push_back({FormRow::Kind::item, field, path, depth, index, count, open, title_of(item)});
    if (!open) return;
    for (const EditField& inner : edit_items(field.choices)) {
      if (is_shown(inner, item)) add(inner, path, depth + 1);
    }
    if (field.choices != "interface") return;
    const TomlValue* type = study::find_key(item, "type");
    for (const EditField& parameter :
         parameter_fields(registry_, type != nullptr ? type->text : title_of(item))) {
      add(parameter, path, depth + 1);
    }
  }

  const TomlValue& root_;
  const study::InterfaceRegistry& registry_;
  const std::set<std::string>& open_;
  std::vector<FormRow> rows_;
};

}  // namespace

std::vector<FormRow> form_rows(const TomlValue& root, const study::InterfaceRegistry& registry,
                               const EditSection& section, const std::set<std::string>& open) {
  Rows rows(root, registry, open);
  for (const EditField& field : section.fields) rows.add(field, {}, 0);
  return rows.take();
}

void unfold(const TomlPath& path, std::set<std::string>& open) {
  TomlPath part;
  for (const study::TomlStep& step : path) {
    part.push_back(step);
    if (std::holds_alternative<std::size_t>(step)) open.insert(study::to_text(part));
  }
}

}  // namespace promenade::app
