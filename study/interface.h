// What an interface is: a map from its controls to N weights over the motion
// set. One declaration fills in everything that the rest of the program needs;
// app/interfaces/NAME.cpp holds it, and adding an interface touches nothing else.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "motion/motion_space.h"
#include "study/rng.h"

namespace promenade::study {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

// What a person did to one control, as it is logged and replayed. What a control does
// not have is no_value, and null in the log.
struct ControlInput {
  std::string kind;                   // "pick", "slide", "only", ...
  std::string target;                 // which control, by the interface's own word: "happy"
  std::string text = {};              // what was typed: a filter, the name of a bookmark
  double value = no_value;            // where it was set, in the control's unit
  double x = no_value, y = no_value;  // of controls of two dimensions
  std::int64_t t_us = 0;              // microseconds since the session began
};

using ParameterValue = std::variant<bool, double, std::string>;
std::string to_text(const ParameterValue& value);  // without quotes
using Parameters = std::map<std::string, ParameterValue, std::less<>>;

// A key that [[interface]] in a study file may set.
struct ParameterSpec {
  std::string name;
  ParameterValue standard;           // its type is the type that is allowed
  std::vector<std::string> choices;  // for strings; empty: any
  std::string sentence;              // with its unit; for the documentation
  // For numbers: the ends of what is allowed, and whether it must be a whole one.
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool whole = false;
};

struct AdjectiveModel;

// What an interface can be made of.
struct InterfaceResources {
  const motion::MotionSpace& space;
  // Made when first asked for; null: nobody has rated the motions of this set.
  std::function<std::shared_ptr<const AdjectiveModel>()> adjectives;
};

// What an interface works out once for a study (a map, a fit); derive from it.
struct InterfaceModel {
  virtual ~InterfaceModel() = default;
};

// Made, or why this motion set cannot have the interface.
struct PreparedModel {
  std::shared_ptr<const InterfaceModel> model;
  std::string problem;  // "nobody has rated the motions of this set"; empty: none
};

struct InterfaceContext {
  const motion::MotionSpace& space;
  const Parameters& parameters;  // complete: standards filled in
  Eigen::VectorXd start;         // N, the weights that are shown until a control is touched
  std::uint64_t seed;            // for interfaces that draw random numbers
  std::shared_ptr<const InterfaceModel> model = nullptr;  // of InterfaceType::prepare
};

// What became of an input.
enum class Applied {
  refused,  // no such control or value here: nothing changed
  aside,    // it changed what the panel shows, never the motion: a zoom, a filter
  done      // it changed the controls; undo takes it back
};

// The controls of an interface during one trial. No clock, no I/O, no UI.
class InterfaceState {
 public:
  virtual ~InterfaceState() = default;
  virtual std::unique_ptr<InterfaceState> clone() const = 0;
  virtual Applied apply(const ControlInput& input) = 0;
  // N weights that sum to 1, a function of the inputs and the time alone.
  // Allocation-free when `weights` has N.
  virtual void weights(std::int64_t t_us, Eigen::VectorXd& weights) const = 0;
  // Called on a state to which undo or redo comes back: `left` are the controls that are
  // left, and `shown` what they showed. What is aside (a zoom, a filter) stays as it is in
  // `left`; and where changes ease, this one does.
  virtual void restored([[maybe_unused]] const InterfaceState& left,
                        [[maybe_unused]] const Eigen::VectorXd& shown,
                        [[maybe_unused]] std::int64_t t_us) {}
  // The controls as they stand, as inputs that would set them: what is logged when a
  // trial begins, so that a start value is never taken for an answer.
  virtual std::vector<ControlInput> settings() const { return {}; }
};

// Long after every input: what glides has arrived.
constexpr std::int64_t settled_us = std::numeric_limits<std::int64_t>::max() / 4;

Eigen::VectorXd weights_of(const InterfaceState& state, std::int64_t t_us);

// Where an interface draws itself; app/panel.h defines it, study/ passes it along.
class InterfacePanel;

struct InterfaceType {
  std::string name;      // as study files say it: "labels"
  std::string sentence;  // what it is, for the documentation
  std::vector<ParameterSpec> parameters;
  std::vector<std::string> texts;  // keys of configs/languages/*.toml that it shows
  bool shows_motion = false;       // its panel shows the created figure: not for blind tasks
  // Once for each [[interface]] of a study; empty: there is nothing to work out.
  std::function<PreparedModel(const InterfaceResources&, const Parameters&)> prepare = {};
  std::function<std::unique_ptr<InterfaceState>(const InterfaceContext&)> start;
  // What a person might do next; the simulated participant chooses among these.
  std::function<std::vector<ControlInput>(const InterfaceState&, Rng&)> simulate;
  // Draws the controls and reports what was done to them to the panel.
  std::function<void(const InterfaceState&, InterfacePanel&)> draw;
};

class InterfaceRegistry {
 public:
  void add(InterfaceType type);
  const InterfaceType* find(std::string_view name) const;  // null: none
  const std::vector<InterfaceType>& all() const { return types_; }

 private:
  std::vector<InterfaceType> types_;  // by name
};

}  // namespace promenade::study
