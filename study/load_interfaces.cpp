// [[interface]]: the conditions of a study and the parameters of their types.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "motion/did_you_mean.h"
#include "study/study_parts.h"

namespace promenade::study {
namespace {

const char* type_word(const ParameterValue& value) {
  if (std::holds_alternative<bool>(value)) return "true or false";
  return std::holds_alternative<double>(value) ? "a number" : "a text in quotes";
}

bool is_choice(const ParameterSpec& spec, const ParameterValue& value) {
  const std::string* word = std::get_if<std::string>(&value);
  return !word || spec.choices.empty() ||
         std::find(spec.choices.begin(), spec.choices.end(), *word) != spec.choices.end();
}

// "a whole number from 1 to 100"
std::string range_text(const ParameterSpec& spec) {
  std::string text = spec.whole ? "a whole number" : "a number";
  if (std::isfinite(spec.least)) text += fmt::format(" from {}", spec.least);
  if (std::isfinite(spec.most)) text += fmt::format(" to {}", spec.most);
  return text;
}

bool in_range(const ParameterSpec& spec, const ParameterValue& value) {
  const double* number = std::get_if<double>(&value);
  return !number || (*number >= spec.least && *number <= spec.most &&
                     (!spec.whole || *number == std::round(*number)));
}

ParameterValue read_parameter(const TomlTable& table, const ParameterSpec& spec) {
  const std::optional<TomlScalar> value = table.scalar(spec.name);
  if (!value) return spec.standard;
  if (value->index() != spec.standard.index()) {
    table.error(spec.name, "\"" + spec.name + "\" must be " + type_word(spec.standard) +
                               ", but is " + type_word(*value));
    return spec.standard;
  }
  if (!in_range(spec, *value)) {
    table.error(spec.name, "\"" + spec.name + "\" must be " + range_text(spec));
    return spec.standard;
  }
  if (!is_choice(spec, *value)) {
    const auto& word = std::get<std::string>(*value);
    table.error(spec.name, "\"" + spec.name + "\" is \"" + word + "\", but must be one of " +
                               quoted_list(spec.choices) + did_you_mean(word, spec.choices));
    return spec.standard;
  }
  return *value;
}

std::vector<std::string> type_names(const InterfaceRegistry& registry) {
  std::vector<std::string> names;
  for (const InterfaceType& type : registry.all()) names.push_back(type.name);
  return names;
}

// Keys of an interface that is not there are not looked at.
void accept_all_keys(const TomlTable& table) {
  for (const std::string& key : table.keys()) table.scalar(key);
}

// The model that all trials of this interface share.
void prepare(const TomlTable& table, const InterfaceType& type, const InterfaceResources& resources,
             InterfaceUse& use) {
  if (!type.prepare) return;
  PreparedModel prepared = type.prepare(resources, use.parameters);
  if (!prepared.problem.empty()) {
    table.error(table.has("type") ? "type" : "name",
                "this study cannot use the interface \"" + type.name + "\": " + prepared.problem);
  }
  use.model = std::move(prepared.model);
}

InterfaceUse read_interface(const TomlTable& table, const InterfaceRegistry& registry,
                            const InterfaceResources* resources) {
  InterfaceUse use;
  use.name = read_name(table);
  use.type = table.text("type").value_or(use.name);
  const InterfaceType* type = registry.find(use.type);
  if (!type) {
    accept_all_keys(table);
    const std::vector<std::string> names = type_names(registry);
    const std::string key = table.has("type") ? "type" : "name";
    if (!use.type.empty()) {
      table.error(key, "there is no interface \"" + use.type + "\", only " + quoted_list(names) +
                           did_you_mean(use.type, names));
    }
    return use;
  }
  for (const ParameterSpec& spec : type->parameters) {
    use.parameters[spec.name] = read_parameter(table, spec);
  }
  if (resources) prepare(table, *type, *resources, use);
  return use;
}

}  // namespace

std::vector<InterfaceUse> read_interfaces(const TomlTable& root, const InterfaceRegistry& registry,
                                          const InterfaceResources* resources) {
  std::vector<InterfaceUse> uses;
  std::vector<std::string> names;
  const std::vector<TomlTable> tables = root.tables("interface");
  for (const TomlTable& table : tables) {
    uses.push_back(read_interface(table, registry, resources));
    names.push_back(uses.back().name);
  }
  refuse_doubles(tables, names, "interface");
  return uses;
}

}  // namespace promenade::study
