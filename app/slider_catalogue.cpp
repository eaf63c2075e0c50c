#include "app/slider_catalogue.h"

#include <algorithm>

namespace promenade::app {

using Eigen::VectorXd;

int find_parameter(const SliderCatalogue& catalogue, std::string_view name) {
  const auto found = std::find_if(catalogue.parameters.begin(), catalogue.parameters.end(),
                                  [&](const SliderParameter& one) { return one.name == name; });
  return found == catalogue.parameters.end()
             ? -1
             : static_cast<int>(found - catalogue.parameters.begin());
}

double in_unit(const SliderParameter& parameter, double value) {
  return parameter.lowest + value * (parameter.highest - parameter.lowest);
}

std::vector<study::ParameterSpec> slider_parameter_specs() {
  return {{.name = "weights",
           .standard = std::string("shown"),
           .choices = {"shown", "hidden", "draggable"},
           .sentence = "shown: the blend weights stand beside the sliders, and can be hidden; "
                       "hidden: they are not there; draggable: they can be dragged, too"},
          {.name = "negative",
           .standard = std::string("clamp"),
           .choices = {"clamp", "keep", "project"},
           .sentence = "what becomes of negative weights: clamp: 0 (as in the source); keep: they "
                       "stay; project: the nearest weights without any"}};
}

void read_slider_parameters(const study::Parameters& parameters, SliderCatalogue& catalogue) {
  const auto& column = std::get<std::string>(parameters.at("weights"));
  catalogue.column = column == "hidden"      ? WeightsColumn::hidden
                     : column == "draggable" ? WeightsColumn::draggable
                                             : WeightsColumn::shown;
  const auto& rule = std::get<std::string>(parameters.at("negative"));
  catalogue.rule = rule == "keep"      ? motion::NegativeRule::keep
                   : rule == "project" ? motion::NegativeRule::project
                                       : motion::NegativeRule::clamp;
}

std::vector<std::string> slider_texts(std::vector<std::string> own) {
  own.insert(own.end(), {"sliders.add", "sliders.most", "sliders.none", "sliders.add_title",
                         "sliders.alter_title", "sliders.weights", "sliders.show", "sliders.hide",
                         "sliders.primary"});
  return own;
}

}  // namespace promenade::app
