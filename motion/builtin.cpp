#include "motion/builtin.h"

#include "motion/canonical.h"
#include "motion/gait/emotions.h"
#include "motion/gait/families.h"
#include "motion/gait/styles.h"
#include "motion/gait/walk.h"

namespace promenade::motion {
namespace {

Cycle walked(const MotionSet& set, const gait::GaitStyle& style) {
  const gait::Walk walk = gait::make_walk(style);
  const double start = gait::first_toe_off(style);
  const double length = gait::stride_seconds(style);
  Cycle cycle = canonical_cycle(set, gait::walking_keytimes(style), [&](double seconds) {
    return gait::walking_pose(walk, start + seconds / length);
  });
  cycle.name = style.name;
  cycle.style = style.style;
  cycle.source = "generated";
  return cycle;
}

// No styles: there is no such set.
std::vector<gait::GaitStyle> styles_of(std::string_view name) {
  if (name == "A") return gait::styles_of_set_a();
  if (name == "B") return gait::styles_of_set_b();
  if (name == "N") return gait::styles_of_set_n();
  return {};
}

}  // namespace

std::optional<std::string> builtin_name(std::string_view set) {
  constexpr std::string_view prefix = "builtin:";
  if (set.substr(0, prefix.size()) != prefix) return std::nullopt;
  return std::string(set.substr(prefix.size()));
}

std::optional<MotionSet> builtin_set(std::string_view name) {
  const std::vector<gait::GaitStyle> styles = styles_of(name);
  if (styles.empty()) return std::nullopt;
  MotionSet set;
  set.name = name;
  set.credit = "made by Promenade";
  set.skeleton = gait::make_skeleton();
  set.body = gait::make_body_map(set.skeleton);
  for (const gait::GaitStyle& style : styles) set.cycles.push_back(walked(set, style));
  return set;
}

std::vector<StyleCharacter> builtin_characters(std::string_view name) {
  std::vector<StyleCharacter> characters;
  for (const gait::GaitStyle& style : styles_of(name)) characters.push_back(style.character);
  return characters;
}

std::vector<std::string> builtin_names(std::string_view name) {
  std::vector<std::string> names;
  for (const gait::GaitStyle& style : styles_of(name)) names.push_back(style.name);
  return names;
}

}  // namespace promenade::motion
