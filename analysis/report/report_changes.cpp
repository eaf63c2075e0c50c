#include "analysis/report/report_changes.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "analysis/format.h"
#include "motion/problem.h"

namespace promenade::analysis {
namespace {

using Json = nlohmann::ordered_json;

std::string value_text(const Json& value) {
  if (!value.is_structured()) return value.dump(-1, ' ', false, Json::error_handler_t::replace);
  const auto size = static_cast<int>(value.size());
  return value.is_array() ? count_of(size, "entry", "entries") : count_of(size, "value", "values");
}

// What a row is about: its texts, "d_final match participants map labels". Empty: it has none.
std::string label_of(const Json& row) {
  std::string label;
  if (!row.is_object()) return label;
  for (const auto& [key, value] : row.items()) {
    if (!value.is_string()) continue;
    label += (label.empty() ? "" : " ") + value.get<std::string>();
  }
  return label;
}

// The rows by their labels; empty unless each has one of its own.
std::map<std::string, const Json*> rows_by_label(const Json& list) {
  std::map<std::string, const Json*> rows;
  for (const Json& row : list) {
    const std::string label = label_of(row);
    if (label.empty() || !rows.emplace(label, &row).second) return {};
  }
  return rows;
}

class Comparer {
 public:
  std::vector<std::string> changes;

  void compare(const std::string& path, const Json& before, const Json& after) {
    if (before == after) return;
    if (before.is_object() && after.is_object()) return compare_objects(path, before, after);
    if (before.is_array() && after.is_array()) return compare_lists(path, before, after);
    say(path, value_text(before), value_text(after));
  }

 private:
  void say(const std::string& path, const std::string& before, const std::string& after) {
    changes.push_back(path + ": " + before + " -> " + after);
  }

  void compare_objects(const std::string& path, const Json& before, const Json& after) {
    const std::string stem = path.empty() ? "" : path + ".";
    for (const auto& [key, value] : after.items()) {
      if (before.contains(key)) {
        compare(stem + key, before[key], value);
      } else {
        say(stem + key, "nothing", value_text(value));
      }
    }
    for (const auto& [key, value] : before.items()) {
      if (!after.contains(key)) say(stem + key, value_text(value), "nothing");
    }
  }

  void compare_lists(const std::string& path, const Json& before, const Json& after) {
    const auto old_rows = rows_by_label(before);
    if (old_rows.empty() || rows_by_label(after).empty()) return by_place(path, before, after);
    std::set<std::string> known;
    for (const Json& row : after) {
      const std::string label = label_of(row);
      known.insert(label);
      const auto found = old_rows.find(label);
      const std::string place = path + "[" + label + "]";
      if (found != old_rows.end()) {
        compare(place, *found->second, row);
      } else {
        say(place, "nothing", value_text(row));
      }
    }
    for (const Json& row : before) {
      const std::string label = label_of(row);
      if (known.count(label) == 0) say(path + "[" + label + "]", value_text(row), "nothing");
    }
  }

  void by_place(const std::string& path, const Json& before, const Json& after) {
    for (std::size_t i = 0; i < std::max(before.size(), after.size()); ++i) {
      const std::string place = path + "[" + std::to_string(i) + "]";
      if (i >= before.size()) {
        say(place, "nothing", value_text(after[i]));
      } else if (i >= after.size()) {
        say(place, value_text(before[i]), "nothing");
      } else {
        compare(place, before[i], after[i]);
      }
    }
  }
};

}  // namespace

std::vector<std::string> report_changes(const std::string& file, const std::string& before,
                                        const std::string& after) {
  if (before == after) return {};
  const Json old_json = Json::parse(before, nullptr, false);
  if (old_json.is_discarded()) {
    throw InputError(file, "is no JSON, so nobody knows what has changed since");
  }
  Comparer comparer;
  comparer.compare("", old_json, Json::parse(after));
  return std::move(comparer.changes);
}

}  // namespace promenade::analysis
