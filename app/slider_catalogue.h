// What an interface of sliders offers: parameters with their names and their values at the
// examples. app/interfaces/adjectives.cpp and features.cpp each make one.
#pragma once

#include <string>
#include <vector>

#include "app/pictogram.h"
#include "motion/models/radial_basis.h"
#include "study/interface.h"
#include "study/texts.h"

namespace promenade::app {

// A text by its key in configs/languages, or what is shown where a language lacks it.
struct Words {
  std::string key, fallback;
  study::LocalText own = {};  // comes before the program's
};

struct SliderParameter {
  std::string name;                // in inputs and the log: "quickness", "slow-fast"
  Words title;                     // empty: the two poles are its name
  Words low, high;                 // what 0 and 1 mean
  Pictogram pictogram{};           // features only
  std::string unit = {};           // "deg", "m", ...; empty: values have none
  double lowest = 0, highest = 1;  // in the unit, at 0 and 1
};

// Part of the list of parameters, under a heading.
struct SliderSection {
  std::string heading;  // a key
  int first = 0;        // index of its first parameter
};

enum class WeightsColumn { hidden, shown, draggable };

// What an interface of sliders offers; made once for a study.
struct SliderCatalogue : study::InterfaceModel {
  std::vector<SliderParameter> parameters;  // P; the primary ones first
  int primary = 0;                          // how many begin with a slider
  std::vector<SliderSection> sections;
  Eigen::MatrixXd values;  // P x N, 0 to 1: of the examples
  motion::NegativeRule rule = motion::NegativeRule::clamp;
  WeightsColumn column = WeightsColumn::shown;
  bool pictograms = false;
};

int find_parameter(const SliderCatalogue& catalogue, std::string_view name);  // -1: none
// Where a slider at `value` stands in the unit of its parameter.
double in_unit(const SliderParameter& parameter, double value);

// `weights` and `negative`, which both interfaces have.
std::vector<study::ParameterSpec> slider_parameter_specs();
void read_slider_parameters(const study::Parameters& parameters, SliderCatalogue& catalogue);
std::vector<std::string> slider_texts(std::vector<std::string> own);

}  // namespace promenade::app
