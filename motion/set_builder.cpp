#include "motion/set_builder.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "motion/cycle_cut.h"
#include "motion/load_clip.h"

namespace promenade::motion {
namespace {

using Eigen::Vector3d;

struct LoadedTake {
  TakeSource source;
  Take take;
};

// Reads all takes before any is judged, so that all problems come at once.
std::vector<LoadedTake> load_takes(const std::vector<TakeSource>& sources,
                                   const SetOptions& options, BuiltSet& built,
                                   const std::function<void(const TakeSource&)>& progress) {
  std::vector<LoadedTake> takes;
  std::vector<Problem> problems;
  const auto add = [](std::vector<Problem>& to, const std::vector<Problem>& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  for (const TakeSource& source : sources) {
    if (progress) progress(source);
    try {
      const Clip clip = load_clip(source.file);
      const Figure figure = find_figure(clip, options.figure);
      add(built.warnings, clip.warnings);
      add(built.warnings, figure.notes);
      takes.push_back({source, unrolled(make_take(clip, figure))});
    } catch (const InputError& error) {
      add(problems, error.problems());
    }
  }
  if (!problems.empty()) throw InputError(problems);
  return takes;
}

bool same_tree(const Skeleton& a, const Skeleton& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t j = 0; j < a.joints.size(); ++j) {
    if (a.joints[j].name != b.joints[j].name || a.joints[j].parent != b.joints[j].parent) {
      return false;
    }
  }
  return true;
}

// Takes with the skeleton that most of them have; the others are refused. Bones get
// their mean length.
std::vector<const LoadedTake*> agree_on_skeleton(const std::vector<LoadedTake>& takes,
                                                 BuiltSet& built) {
  const auto followers = [&](const LoadedTake& one) {
    return std::count_if(takes.begin(), takes.end(), [&](const LoadedTake& other) {
      return same_tree(one.take.skeleton, other.take.skeleton);
    });
  };
  const auto model = std::max_element(
      takes.begin(), takes.end(),
      [&](const LoadedTake& a, const LoadedTake& b) { return followers(a) < followers(b); });
  std::vector<const LoadedTake*> kept;
  built.set.skeleton = model->take.skeleton;
  built.set.body = model->take.body;
  for (Joint& joint : built.set.skeleton.joints) joint.offset.setZero();
  for (const LoadedTake& take : takes) {
    if (!same_tree(model->take.skeleton, take.take.skeleton)) {
      built.reports.push_back(
          {take.source.label, "", "its joints are not those of the other takes", {}, 0, 0, {}, 0});
      continue;
    }
    kept.push_back(&take);
    for (std::size_t j = 0; j < take.take.skeleton.joints.size(); ++j) {
      built.set.skeleton.joints[j].offset += take.take.skeleton.joints[j].offset;
    }
  }
  for (Joint& joint : built.set.skeleton.joints) {
    joint.offset /= static_cast<double>(kept.size());
  }
  return kept;
}

// The most that a joint of the body lies from where it was in the capture, both with
// the pelvis above the origin and facing along +Z.
double distance_from_capture(const MotionSet& set, const Cycle& cycle, const Take& take,
                             const CycleCandidate& cut) {
  double most = 0;
  const Vector3d start = pose_at(take, cut.first()).root;
  const Vector3d travel = pose_at(take, cut.keys.back()).root - start;
  const Eigen::AngleAxisd turn(-std::atan2(travel.x(), travel.z()), Vector3d::UnitY());
  for (int k = 0; k < 30; ++k) {
    const double share = k / 30.0;
    auto original = body_at(take, cut.first() + share * cut.length());
    auto now = body_over_ground(set, cycle, share * cycle.seconds);
    for (auto* body : {&original, &now}) {
      const Vector3d at = body->col(pelvis);
      body->colwise() -= Vector3d(at.x(), 0, at.z());
    }
    most = std::max(most, (now - turn.toRotationMatrix() * original).colwise().norm().maxCoeff());
  }
  return most;
}

// The best loops of a take that do not share frames.
std::vector<CycleCandidate> best_apart(const std::vector<CycleCandidate>& all, int count) {
  std::vector<CycleCandidate> chosen;
  for (const CycleCandidate& one : all) {
    const bool apart = std::all_of(chosen.begin(), chosen.end(), [&](const CycleCandidate& other) {
      return one.keys.back() <= other.first() + 1 || one.first() >= other.keys.back() - 1;
    });
    if (apart && static_cast<int>(chosen.size()) < count) chosen.push_back(one);
  }
  std::sort(chosen.begin(), chosen.end(),
            [](const CycleCandidate& a, const CycleCandidate& b) { return a.first() < b.first(); });
  return chosen;
}

void refuse(BuiltSet& built, const LoadedTake& take, const std::string& reason) {
  built.reports.push_back({take.source.label, "", reason, {}, 0, 0, {}, 0});
}

void add_cycle(BuiltSet& built, const LoadedTake& take, const CycleCandidate& cut,
               std::map<std::string, int>& numbers) {
  MotionSet& set = built.set;
  Cycle cycle = cut_cycle(set, take.take, cut);
  CycleReport report;
  report.plant = plant_feet(set, cycle);
  report.seam = seam(set, cycle);
  report.slide_left_m = stance_slide_m(set, cycle, Side::left);
  report.slide_right_m = stance_slide_m(set, cycle, Side::right);
  report.from_capture_m = distance_from_capture(set, cycle, take.take, cut);
  cycle.style = take.source.style;
  cycle.source = take.source.label;
  cycle.name = cycle.style + "_" + std::to_string(++numbers[cycle.style]);
  report.file = take.source.label;
  report.cycle = cycle.name;
  built.reports.push_back(std::move(report));
  set.cycles.push_back(std::move(cycle));
}

void add_take(BuiltSet& built, const LoadedTake& take, const SetOptions& options,
              std::map<std::string, int>& numbers) {
  const CycleSearch search = find_cycles(take.take, find_contacts(take.take));
  if (search.candidates.empty()) return refuse(built, take, search.refusal);
  std::vector<CycleCandidate> good;
  for (const CycleCandidate& one : search.candidates) {
    if (one.loop_error_m <= options.most_loop_error_m) good.push_back(one);
  }
  if (good.empty()) return refuse(built, take, "no cycle of it comes back to where it began");
  for (const CycleCandidate& cut : best_apart(good, options.cycles_per_take)) {
    add_cycle(built, take, cut, numbers);
  }
}

}  // namespace

BuiltSet build_set(std::vector<TakeSource> sources, const SetOptions& options,
                   const std::function<void(const TakeSource&)>& progress) {
  std::sort(sources.begin(), sources.end(), [](const TakeSource& a, const TakeSource& b) {
    return std::tie(a.label, a.file) < std::tie(b.label, b.file);
  });
  BuiltSet built;
  built.set.name = options.name;
  built.set.credit = options.credit;
  built.set.phases = options.phases;
  const std::vector<LoadedTake> takes = load_takes(sources, options, built, progress);
  if (takes.empty()) throw InputError(options.name, "there is no take to cut a cycle from");
  std::map<std::string, int> numbers;
  for (const LoadedTake* take : agree_on_skeleton(takes, built)) {
    add_take(built, *take, options, numbers);
  }
  if (built.set.cycles.empty()) {
    std::vector<Problem> problems;
    for (const CycleReport& report : built.reports) {
      problems.push_back({report.file, 0, 0, report.refusal, Severity::error});
    }
    throw InputError(problems);
  }
  return built;
}

}  // namespace promenade::motion
