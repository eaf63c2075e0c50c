#include "tests/app/odd_inputs.h"

#include "tests/app/panel_bench.h"

namespace promenade::app::bench {

using study::ControlInput;

namespace {

ControlInput idea_of(const study::InterfaceType& type, const study::InterfaceState& state,
                     study::Rng& rng) {
  const std::vector<ControlInput> ideas = type.simulate(state, rng);
  return ideas.empty() ? ControlInput{} : ideas[rng.below(ideas.size())];
}

const std::string& any_of(const std::vector<std::string>& words, study::Rng& rng) {
  return words[rng.below(words.size())];
}

}  // namespace

ControlInput likely_input(const study::InterfaceType& type, const study::InterfaceState& state,
                          study::Rng& rng) {
  const double odd[] = {0, 1, -1, 0.5, 1e300, 1e-320, INFINITY, -INFINITY, NAN};
  ControlInput input = idea_of(type, state, rng);
  if (rng.below(3) == 0) input.value = odd[rng.below(9)];
  if (rng.below(5) == 0) input.x = odd[rng.below(9)];
  if (rng.below(5) == 0) input.y = odd[rng.below(9)];
  if (rng.below(20) == 0) input.target = "nobody";
  if (rng.below(20) == 0) input.kind = "sing";
  return input;
}

ControlInput wild_input(const study::InterfaceType& type, const study::InterfaceState& state,
                        study::Rng& rng) {
  static const std::vector<std::string> kinds = {
      "go",     "point",  "pick",     "slide",  "only",  "reset",  "zoom",      "pan",     "whole",
      "goto",   "mix",    "unmix",    "share",  "offer", "rename", "remove",    "edit",    "delete",
      "filter", "step",   "others",   "list",   "back",  "show",   "hide",      "alter",   "add",
      "weight", "weight", "bookmark", "rename", "share", "mix",    "heuristic", "show_all"};
  static const std::vector<std::string> others = {
      "",          "1",         "2",
      "9",         "#1",        "#2",
      "map",       "list",      "larger",
      "smaller",   "weights",   "zero",
      "closest",   "random",    "slow-fast",
      "old-young", "sad-happy", "quickness",
      "largeness", "add",       "v_step-length_front-back",
      "nobody"};
  const auto& cycles = space().set.cycles;
  ControlInput input;
  input.kind = any_of(kinds, rng);
  switch (rng.below(3)) {
    case 0:
      input.target = cycles[rng.below(cycles.size())].name;
      break;
    case 1:
      input.target = any_of(others, rng);
      break;
    default:
      input.target = idea_of(type, state, rng).target;
  }
  if (rng.below(2) == 0) input.value = rng.uniform();
  if (rng.below(3) == 0) {
    input.x = 4 * rng.uniform() - 2;
    input.y = 4 * rng.uniform() - 2;
  }
  if (rng.below(4) == 0) input.text = std::string(rng.below(60), 'x') + "あ";
  // A slider for another parameter instead.
  if (input.kind == "alter") input.text = idea_of(type, state, rng).target;
  return input;
}

ControlInput any_input(const study::InterfaceType& type, const study::InterfaceState& state,
                       study::Rng& rng) {
  return rng.below(2) == 0 ? wild_input(type, state, rng) : likely_input(type, state, rng);
}

}  // namespace promenade::app::bench
