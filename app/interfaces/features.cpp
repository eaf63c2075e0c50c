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

// Correlation with the features that its name promises from which a slider may have it.
constexpr double least_promise = 0.5;

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

constexpr unsigned upper_body = Pictogram::torso | Pictogram::head;
constexpr unsigned feet = Pictogram::left_foot | Pictogram::right_foot;

// A cluster of the source: its key, the features that its name promises, its ends and its
// picture.
struct Cluster {
  const char *name, *key;
  std::array<const char*, 2> promised;
  Poles poles;
  Pictogram pictogram;
};
constexpr std::array<Cluster, 4> clusters = {{
    {"lateral swing of the upper body",
     "cluster.lateral-swing",
     {"sigma_torso_left-right", "sigma_head_left-right"},
     {"less", "more"},
     {upper_body, Pictogram::View::back, Pictogram::Arrow::across}},
    {"front-back swing of the arms and legs",
     "cluster.front-back-swing",
     {"sigma_left-forearm_front-back", "sigma_left-thigh_front-back"},
     {"less", "more"},
     {limbs, Pictogram::View::side, Pictogram::Arrow::across}},
    {"bending angle of the upper body",
     "cluster.bending",
     {"mu_torso_front-back", "mu_head_front-back"},
     {"backward", "forward"},
     {upper_body, Pictogram::View::side, Pictogram::Arrow::across}},
    {"step length",
     "cluster.step-length",
     {"v_step-length_front-back", "v_step-length_front-back"},
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

// The 51 features of a set and their clusters.
struct Measured {
  Eigen::MatrixXd features;  // 51 x N
  motion::FeatureSliders sliders;
};

double runs_like(const Measured& of, Eigen::Index c, int feature) {
  return motion::correlation(of.sliders.parameters.row(c), of.features.row(feature));
}

// How well a slider does what the name of its cluster promises, -1 to 1.
double keeps_promise(const Measured& of, Eigen::Index c, const Cluster& printed) {
  double sum = 0;
  for (const char* name : printed.promised) sum += runs_like(of, c, motion::find_feature(name));
  return sum / static_cast<double>(printed.promised.size());
}

// The feature that runs most like its cluster's mean, of equals the first.
int representative(const Measured& of, Eigen::Index c) {
  int best = -1;
  for (int k = 0; k < motion::feature_count; ++k) {
    if (of.sliders.cluster[static_cast<std::size_t>(k)] != c) continue;
    if (best < 0 || runs_like(of, c, k) > runs_like(of, c, best)) best = k;
  }
  return best;
}

// Clusters are named by what they share with those of the source, which on another set
// may be something else than the name says: "step length" without the step length. Such
// a slider is called after its most typical feature, and one that runs against its name
// is turned around (ours).
void add_cluster(const Measured& of, Eigen::Index c, SliderCatalogue& catalogue) {
  const std::string& name = of.sliders.names[static_cast<std::size_t>(c)];
  const Cluster* printed = find_cluster(name);
  const double kept = printed != nullptr ? keeps_promise(of, c, *printed) : 0;
  SliderParameter parameter;
  if (std::abs(kept) >= least_promise) {
    parameter = {.name = name,
                 .title = {printed->key, printed->name},
                 .low = pole(printed->poles.low),
                 .high = pole(printed->poles.high),
                 .pictogram = printed->pictogram};
  } else {
    parameter = parameter_of(representative(of, c), 0, 1);
    parameter.name = "cluster:" + parameter.name;
    parameter.unit.clear();
  }
  const auto values = of.sliders.parameters.row(c).array();
  const bool against = kept <= -least_promise;
  catalogue.values.row(c) = against ? Eigen::ArrayXXd(1 - values) : Eigen::ArrayXXd(values);
  catalogue.parameters.push_back(std::move(parameter));
}

std::shared_ptr<SliderCatalogue> make_catalogue(const MotionSet& set) {
  auto catalogue = std::make_shared<SliderCatalogue>();
  const Measured of{motion::motion_features(set), motion::feature_sliders(set)};
  const Eigen::Index primary = of.sliders.parameters.rows();
  catalogue->pictograms = true;
  catalogue->primary = static_cast<int>(primary);
  catalogue->values.resize(primary + motion::feature_count, set.size());
  for (Eigen::Index c = 0; c < primary; ++c) add_cluster(of, c, *catalogue);
  for (int k = 0; k < motion::feature_count; ++k) {
    catalogue->parameters.push_back(
        parameter_of(k, of.features.row(k).minCoeff(), of.features.row(k).maxCoeff()));
  }
  catalogue->values.bottomRows(motion::feature_count) = motion::scaled_to_range(of.features);
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
    .start = start_as<ParameterSliders>,
    .simulate = simulate_sliders,
    .draw = draw_sliders,
}};

}  // namespace
}  // namespace promenade::app
