// Feature sliders ([O] 5): one for each cluster of motion features, over the range of the
// set; any of the 51 features can be added.
#include "motion/models/features.h"

#include <array>

#include "app/parameter_sliders.h"
#include "app/parameter_sliders_view.h"
#include "app/registry.h"
#include "motion/models/adjectives.h"
#include "motion/models/control_maps.h"

namespace promenade::app {
namespace {

using motion::MotionSet;

// What the ends of a slider are called; keys below interface.features.
struct Poles {
  const char *low, *high;
};

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

// A limb leans away from the body on its own side; torso and head to the left or right.
Poles side_poles(std::string_view feature) {
  if (contains(feature, "left-right") && contains(feature, "mu_left-"))
    return {"inward", "outward"};
  if (contains(feature, "left-right") && contains(feature, "mu_right-")) {
    return {"outward", "inward"};
  }
  return {"right", "left"};
}

Poles poles_of(std::string_view feature) {
  if (feature == "v_step-length_left-right") return {"narrow", "wide"};
  if (feature.rfind("v_", 0) == 0) return {"short", "long"};
  if (feature == "mu_com-velocity_front-back") return {"slow", "fast"};
  if (feature == "mu_com-position_vertical") return {"low", "high"};
  if (feature.rfind("sigma_", 0) == 0) return {"less", "more"};
  return contains(feature, "front-back") ? Poles{"backward", "forward"} : side_poles(feature);
}

Words pole(const char* word) { return {"interface.features." + std::string(word), word}; }

constexpr unsigned limbs = Pictogram::left_upper_arm | Pictogram::right_upper_arm |
                           Pictogram::left_forearm | Pictogram::right_forearm |
                           Pictogram::left_thigh | Pictogram::right_thigh;

// A cluster of the source: its key, its ends and its picture.
struct Cluster {
  const char *name, *key;
  Poles poles;
  Pictogram pictogram;
};
constexpr unsigned upper_body = Pictogram::torso | Pictogram::head;
constexpr unsigned feet = Pictogram::left_foot | Pictogram::right_foot;
constexpr std::array<Cluster, 4> clusters = {{
    {"lateral swing of the upper body",
     "cluster.lateral-swing",
     {"less", "more"},
     {upper_body, Pictogram::View::back, Pictogram::Arrow::across}},
    {"front-back swing of the arms and legs",
     "cluster.front-back-swing",
     {"less", "more"},
     {limbs, Pictogram::View::side, Pictogram::Arrow::across}},
    {"bending angle of the upper body",
     "cluster.bending",
     {"less", "more"},
     {upper_body, Pictogram::View::side, Pictogram::Arrow::across}},
    {"step length",
     "cluster.step-length",
     {"short", "long"},
     {feet, Pictogram::View::side, Pictogram::Arrow::across}},
}};

const Cluster* find_cluster(std::string_view name) {
  for (const Cluster& cluster : clusters) {
    if (cluster.name == name) return &cluster;
  }
  return nullptr;
}

// Small lengths are read in centimetres.
void set_unit(int feature, double lowest, double highest, SliderParameter& parameter) {
  parameter.unit = motion::feature_unit(feature);
  const bool small = parameter.unit == "m" && std::max(std::abs(lowest), std::abs(highest)) < 0.2;
  const double scale = small ? 100 : 1;
  if (small) parameter.unit = "cm";
  parameter.lowest = scale * lowest;
  parameter.highest = scale * highest;
}

SliderParameter parameter_of(int feature, double lowest, double highest) {
  const std::string name(motion::feature_names()[static_cast<std::size_t>(feature)]);
  const Poles poles = poles_of(name);
  SliderParameter parameter;
  parameter.name = name;
  parameter.title = {"feature." + name, name};
  parameter.low = pole(poles.low);
  parameter.high = pole(poles.high);
  parameter.pictogram = feature_pictogram(name);
  set_unit(feature, lowest, highest, parameter);
  return parameter;
}

// A cluster like none of the source is shown by its first feature, without a unit.
SliderParameter parameter_of_cluster(const motion::FeatureSliders& sliders, std::size_t c) {
  SliderParameter parameter;
  if (const Cluster* printed = find_cluster(sliders.names[c])) {
    parameter.title = {printed->key, printed->name};
    parameter.low = pole(printed->poles.low);
    parameter.high = pole(printed->poles.high);
    parameter.pictogram = printed->pictogram;
  } else {
    const auto first =
        std::find(sliders.cluster.begin(), sliders.cluster.end(), static_cast<int>(c));
    parameter = parameter_of(static_cast<int>(first - sliders.cluster.begin()), 0, 1);
    parameter.unit.clear();
  }
  parameter.name = sliders.names[c];
  return parameter;
}

std::shared_ptr<SliderCatalogue> make_catalogue(const MotionSet& set) {
  auto catalogue = std::make_shared<SliderCatalogue>();
  const motion::FeatureSliders sliders = motion::feature_sliders(set);
  const Eigen::MatrixXd features = motion::motion_features(set);
  catalogue->pictograms = true;
  catalogue->primary = static_cast<int>(sliders.names.size());
  for (std::size_t c = 0; c < sliders.names.size(); ++c) {
    catalogue->parameters.push_back(parameter_of_cluster(sliders, c));
  }
  for (int k = 0; k < motion::feature_count; ++k) {
    catalogue->parameters.push_back(
        parameter_of(k, features.row(k).minCoeff(), features.row(k).maxCoeff()));
  }
  catalogue->values.resize(sliders.parameters.rows() + features.rows(), set.size());
  catalogue->values << sliders.parameters, motion::scaled_to_range(features);
  catalogue->sections = {{"sliders.primary", 0}, {"interface.features.single", catalogue->primary}};
  return catalogue;
}

study::PreparedModel prepare(const study::InterfaceResources& resources,
                             const study::Parameters& parameters) {
  if (resources.space.set.size() < 2) {
    return {nullptr, "a single motion leaves its features no range"};
  }
  auto catalogue = make_catalogue(resources.space.set);
  read_slider_parameters(parameters, *catalogue);
  return {catalogue, ""};
}

std::vector<std::string> own_texts() {
  std::vector<std::string> keys;
  for (const char* word :
       {"title", "hint", "single", "less", "more", "backward", "forward", "right", "left", "inward",
        "outward", "slow", "fast", "low", "high", "short", "long", "narrow", "wide"}) {
    keys.push_back("interface.features." + std::string(word));
  }
  return keys;
}

const InterfaceEntry entry{{
    .name = "features",
    .sentence =
        "Sliders for measurable features of the motions, such as step length; features can be "
        "added, changed and taken away.",
    .parameters = slider_parameter_specs(),
    .texts = slider_texts(own_texts()),
    .prepare = prepare,
    .start =
        [](const study::InterfaceContext& context) {
          return std::make_unique<ParameterSliders>(context);
        },
    .simulate = simulate_sliders,
    .draw = draw_sliders,
}};

}  // namespace
}  // namespace promenade::app
