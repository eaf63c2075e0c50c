#include "app/desk/edit/edit_options.h"

#include <algorithm>
#include <filesystem>

#include "study/embedded.h"
#include "study/published.h"
#include "study/toml_text.h"

namespace promenade::app {
namespace {

using study::TomlValue;

std::vector<std::string> names_in(const TomlValue& root, std::string_view list) {
  std::vector<std::string> names;
  const TomlValue* found = study::find_key(root, list);
  if (found == nullptr) return names;
  for (const TomlValue& element : found->elements) {
    const TomlValue* name = study::find_key(element, "name");
    if (name != nullptr && !name->text.empty()) names.push_back(name->text);
  }
  return names;
}

std::vector<std::string> guesses_in(const TomlValue& root) {
  std::vector<std::string> names = {"average"};
  const TomlValue* tasks = study::find_key(root, "task");
  if (tasks == nullptr) return names;
  for (const TomlValue& task : tasks->elements) {
    const TomlValue* kind = study::find_key(task, "kind");
    const TomlValue* name = study::find_key(task, "name");
    if (kind != nullptr && name != nullptr && kind->text == "guess") names.push_back(name->text);
  }
  return names;
}

// Each walk, and each style of several walks once.
std::vector<std::string> walks_of(const motion::MotionSet& set) {
  std::vector<std::string> names;
  const auto add = [&names](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const motion::Cycle& cycle : set.cycles) add(cycle.name);
  for (const motion::Cycle& cycle : set.cycles) add(cycle.style);
  return names;
}

}  // namespace

EditOptions::EditOptions(std::string file, const study::InterfaceRegistry& registry)
    : file_(std::move(file)) {
  for (const study::InterfaceType& type : registry.all()) lists_["@types"].push_back(type.name);
  lists_["@languages"] = study::known_languages();
  lists_["@published"] = study::published_studies();
  find_files();
}

void EditOptions::find_files() {
  std::vector<std::string> sets;
  std::error_code error;
  const auto folder = std::filesystem::absolute(file_, error).parent_path();
  // Beside the study, and where the desk makes them.
  for (const std::string beside : {"", "../sets/"}) {
    for (const auto& entry : std::filesystem::directory_iterator(folder / beside, error)) {
      const std::string name = entry.path().filename().string();
      if (entry.path().extension() == ".set") sets.push_back(beside + name);
    }
  }
  std::sort(sets.begin(), sets.end());
  lists_["@sets"] = {"builtin:A", "builtin:B", "builtin:N"};
  lists_["@sets"].insert(lists_["@sets"].end(), sets.begin(), sets.end());
  lists_["@instruments"] = study::embedded_names("instruments");
}

void EditOptions::follow(const TomlValue& root, const study::StudyBundle* motions) {
  lists_["@interfaces"] = names_in(root, "interface");
  lists_["@tasks"] = names_in(root, "task");
  lists_["@stimuli"] = names_in(root, "stimulus");
  lists_["@starts"] = guesses_in(root);
  find_files();
  if (motions != nullptr) lists_["@walks"] = walks_of(motions->space.set);
}

const std::vector<std::string>& EditOptions::of(std::string_view source) const {
  static const std::vector<std::string> none;
  const auto found = lists_.find(source);
  return found != lists_.end() ? found->second : none;
}

}  // namespace promenade::app
