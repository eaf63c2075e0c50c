#include "tests/screenshots/studies.h"

#include <fmt/format.h>

#include <cstdio>

#include "app/registry.h"
#include "study/embedded.h"

namespace promenade::app::screenshots {
namespace {

constexpr const char* study_text = R"toml([study]
name = "pictures"
set = "{set}"
languages = ["en", "ja"]
order = "fixed"

[display]
{display}

[breaks]
{breaks}

{interfaces}
[[task]]
name = "match"
kind = "match"
limit_s = 45
targets = [{{ example = "{target}" }}]
practice = [{{ example = "{practice}" }}]
{match}

[[task]]
name = "find"
kind = "find"
qualities = [{{ name = "confident", en = "confident", ja = "自信に満ちた" }}]

[[rating]]
item = "satisfaction"
question = {{ en = "How satisfied are you with the walk that you made?", ja = "できあがった歩き方にどのくらい満足していますか。" }}
low = {{ en = "not at all", ja = "まったく満足していない" }}
high = {{ en = "completely", ja = "完全に満足している" }}
points = 7

[[rating]]
item = "effort"
question = {{ en = "How hard did you have to work?", ja = "どのくらい大変でしたか。" }}
low = {{ en = "very little", ja = "ほとんど大変でなかった" }}
high = {{ en = "very much", ja = "とても大変だった" }}
points = 7
)toml";

// Every instrument, and every task that has no picture of its own elsewhere.
constexpr const char* pages_text = R"toml([study]
name = "pages"
languages = ["en", "ja"]
order = "fixed"
nesting = ["target", "interface", "task"]

[practice]
until = "released"

[safety]
withdraw = "link"
leave = true

[[interface]]
name = "labels"

[[interface]]
name = "weights"

[[task]]
name = "look"
kind = "rate"
instrument = "impression"
reference = "normal"
targets = [{ example = "sad" }]

[[task]]
name = "words"
kind = "rate"
instrument = "adjectives"
reference = "normal"
targets = [{ example = "happy" }, { example = "old" }, { example = "proud" }, { example = "sad" }]

[[task]]
name = "guess"
kind = "guess"
targets = [{ example = "proud" }, { example = "old" }]
practice = [{ example = "happy" }]

)toml";

motion::MotionSet set_of(const Scene& scene, const std::string& folder) {
  motion::MotionSet set = study::load_motion_set(scene.set, folder);
  if (!scene.long_names) return set;
  for (motion::Cycle& cycle : set.cycles) {
    cycle.style = "a_rather_long_winded_way_of_walking_that_is_" + cycle.style;
    cycle.name = cycle.style;
  }
  return set;
}

study::StudyBundle study_with(const Scene& scene, const motion::MotionSet& set,
                              const std::vector<std::string>& names) {
  std::string uses;
  for (const std::string& name : names) uses += "[[interface]]\nname = \"" + name + "\"\n\n";
  const std::string text = fmt::format(
      fmt::runtime(study_text), fmt::arg("set", scene.set), fmt::arg("display", scene.display),
      fmt::arg("breaks", scene.breaks), fmt::arg("interfaces", uses),
      fmt::arg("match", scene.match), fmt::arg("target", set.cycles[set.cycles.size() / 2].name),
      fmt::arg("practice", set.cycles.back().name));
  return study::read_study("pictures.toml", text, interfaces(),
                           [&](const std::string&, const std::string&) { return set; });
}

}  // namespace

study::StudyBundle make_study_of_pages() {
  std::string text = pages_text;
  for (const std::string& name : study::embedded_names("instruments")) {
    text += "[[questionnaire]]\ninstrument = \"" + name + "\"\nwhen = \"end\"\n\n";
  }
  return study::read_study("pages.toml", text, interfaces(), study::load_motion_set);
}

bool can_have(const Scene& scene, const std::string& interface) {
  try {
    study_with(scene, set_of(scene, "."), {interface});
    return true;
  } catch (const InputError& error) {
    for (const Problem& problem : error.problems()) {
      if (problem.severity != Severity::error) continue;
      std::fputs(
          fmt::format("without {} in {}: {}\n", interface, scene.set, problem.message).c_str(),
          stderr);
    }
    return false;
  }
}

study::StudyBundle make_study(const Scene& scene) {
  const motion::MotionSet set = set_of(scene, ".");
  std::vector<std::string> names = scene.interfaces;
  if (names.empty()) {
    for (const study::InterfaceType& type : interfaces().all()) {
      if (can_have(scene, type.name)) names.push_back(type.name);
    }
  }
  return study_with(scene, set, names);
}

}  // namespace promenade::app::screenshots
