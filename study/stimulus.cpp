#include "study/stimulus.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "motion/builtin.h"
#include "study/impressions.h"

namespace promenade::study {
namespace {

// How the walk of this name, or the mean one of this style, seems; nothing: there is none.
std::optional<Eigen::VectorXd> felt_of_label(const std::string& label, const motion::MotionSet& set,
                                             const Eigen::MatrixXd& all) {
  const auto& cycles = set.cycles;
  const int one = motion::find_cycle(set, label);
  if (one >= 0) return all.col(one);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(all.rows());
  int count = 0;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    if (cycles[i].style != label) continue;
    sum += all.col(static_cast<Eigen::Index>(i));
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

constexpr double same_bone_m = 0.005;

// "happy", then "sad"
std::string in_words(const std::vector<motion::WantedLabel>& parts) {
  std::string words;
  for (const motion::WantedLabel& part : parts) {
    words += (words.empty() ? "\"" : ", then \"") + part.label + "\"";
  }
  return words;
}

}  // namespace

bool same_bones(const motion::Skeleton& a, const motion::Skeleton& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t j = 0; j < a.joints.size(); ++j) {
    const motion::Joint &one = a.joints[j], &other = b.joints[j];
    if (one.name != other.name || one.parent != other.parent) return false;
    if ((one.offset - other.offset).norm() > same_bone_m) return false;
  }
  return true;
}

StimulusMoment moment_of(const Stimulus& stimulus, double seconds) {
  const double length = stimulus.seconds();
  const double round = std::floor(std::max(0.0, seconds) / (length + stimulus_rest_s));
  const double within = std::max(0.0, seconds) - round * (length + stimulus_rest_s);
  return {static_cast<int>(round), std::min(within, length)};
}

std::vector<int> find_walk(const motion::MotionGraph& graph,
                           const std::vector<motion::WantedLabel>& parts, std::uint64_t seed) {
  std::vector<int> edges = motion::walk_through_labels(graph, parts, seed).edges;
  const std::vector<motion::LabelledPart> seen = motion::labelled_parts(graph, edges);
  auto from = seen.begin();
  for (const motion::WantedLabel& part : parts) {
    from = std::find_if(from, seen.end(), [&](auto& one) { return one.label == part.label; });
    if (from != seen.end()) continue;
    throw InputError(graph.name, "the motion graph has no walk that shows " + in_words(parts) +
                                     " about as long as asked; ask for other labels or times, or "
                                     "build it with a larger threshold");
  }
  return edges;
}

Stimulus make_stimulus(std::string name, std::shared_ptr<const motion::MotionGraph> graph,
                       std::vector<int> edges) {
  Stimulus stimulus;
  stimulus.name = std::move(name);
  stimulus.take = motion::walk_take(*graph, {edges, motion::start_at_origin(*graph, edges)});
  stimulus.labels = motion::labelled_parts(*graph, edges);
  stimulus.graph = std::move(graph);
  stimulus.edges = std::move(edges);
  return stimulus;
}

std::string describe_parts(const Stimulus& stimulus) {
  std::string text;
  for (const motion::LabelledPart& part : stimulus.labels) {
    text += fmt::format("{}{} {:.1f} s", text.empty() ? "" : ", ", part.label,
                        (part.to - part.from) * stimulus.take.frame_time);
  }
  return text;
}

int count_transitions(const Stimulus& stimulus) {
  return static_cast<int>(
      std::count_if(stimulus.edges.begin(), stimulus.edges.end(),
                    [&](int edge) { return stimulus.graph->edge(edge).transition >= 0; }));
}

Eigen::VectorXd felt_of(const Stimulus& stimulus, const StudyBundle& bundle) {
  const motion::MotionSet& set = bundle.space.set;
  const Eigen::MatrixXd& all =
      bundle.impressions->of(set, motion::builtin_name(bundle.study.set).value_or(""));
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(all.rows());
  double frames = 0;
  for (const motion::LabelledPart& part : stimulus.labels) {
    frames += part.to - part.from;
    if (const auto felt = felt_of_label(part.label, set, all)) {
      sum += (part.to - part.from) * *felt;
    }
  }
  return frames > 0 ? Eigen::VectorXd(sum / frames) : sum;
}

}  // namespace promenade::study
