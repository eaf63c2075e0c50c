#include "motion/graph/graph_takes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>

#include "motion/decimal.h"
#include "motion/quantile.h"
#include "motion/shared_skeleton.h"

namespace promenade::motion {
namespace {

constexpr double most_frames = 1e6;  // of a take that is brought to another rate

struct LoadedTake {
  const TakeSource* source;
  Take take;
};

// Poses as a capture of another rate would show them.
Take resampled(const Take& take, double frame_time) {
  Take other{take.source, take.skeleton, take.body, frame_time, {}, take.first_frame, 0};
  const double last = take.frames() - 1;
  const double step = frame_time / take.frame_time;
  // A thousandth of a frame more: the last frame is not lost to rounding.
  for (int f = 0; f * step <= last + 1e-3; ++f) {
    other.poses.push_back(pose_at(take, std::min(f * step, last)));
  }
  return other;
}

// The motion alone: what stands before it in a T-pose is none.
Take without_t_pose(ReadTake read, const TakeSource& source) {
  const int before = read.figure.t_pose_frames - read.take.first_frame;
  if (before <= 0 || source.from) return std::move(read.take);
  if (before >= read.take.frames()) {
    throw InputError(source.file, "holds nothing but a T-pose");
  }
  return part(read.take, before, read.take.frames() - 1);
}

void scale_way(Take& take, double scale) {
  for (Pose& pose : take.poses) pose.root *= scale;
}

std::string rate_text(double frame_time) {
  return short_number(1 / frame_time, 5) + " frames a second";
}

// Reads all takes and collects what is wrong with any of them.
class GraphTakeLoader {
 public:
  GraphTakeLoader(const GraphTakeOptions& options, GraphTakes& result)
      : options_(options), result_(result) {}

  void read(const TakeSource& source) {
    try {
      ReadTake read = read_take(source, options_.read);
      result_.warnings.insert(result_.warnings.end(), read.warnings.begin(), read.warnings.end());
      Take take = without_t_pose(std::move(read), source);
      if (options_.rate) {
        check_length(take, source);
        take = resampled(take, 1 / *options_.rate);
      }
      loaded_.push_back({&source, std::move(take)});
    } catch (const InputError& error) {
      problems_.insert(problems_.end(), error.problems().begin(), error.problems().end());
    }
  }

  void check_length(const Take& take, const TakeSource& source) const {
    const double frames = take.frames() * take.frame_time * *options_.rate;
    if (frames <= most_frames) return;
    throw InputError(source.file, "would have " + short_number(frames, 3) +
                                      " frames at that rate; ask for a lower one");
  }

  void check_rates() {
    if (loaded_.empty()) return;
    const Take& first = loaded_.front().take;
    for (const LoadedTake& one : loaded_) {
      if (std::abs(one.take.frame_time / first.frame_time - 1) < 1e-3) continue;
      complain(one, "has " + rate_text(one.take.frame_time) + ", and " + first.source + " has " +
                        rate_text(first.frame_time) + "; ask for one rate for all");
    }
  }

  void finish() {
    const SharedSkeleton shared = skeleton();
    for (LoadedTake& one : loaded_) {
      Fitted fitted = fit_to(shared, one.take);
      if (!fitted.refusal.empty()) complain(one, fitted.refusal);
      if (!problems_.empty()) continue;
      const double leg = leg_length(fitted.take.skeleton, fitted.take.body);
      scale_way(fitted.take, leg_length(shared.skeleton, shared.body) / leg);
      fitted.take.skeleton = shared.skeleton;
      fitted.take.body = shared.body;
      fitted.take.frame_time = loaded_.front().take.frame_time;
      result_.takes.push_back({std::move(fitted.take), one.source->style, one.source->sha256});
    }
    if (!problems_.empty()) throw InputError(problems_);
  }

 private:
  void complain(const LoadedTake& one, const std::string& message) {
    problems_.push_back(asked_at(options_.read.recipe, one.source->place, *one.source, message));
  }

  SharedSkeleton skeleton() const {
    std::vector<Take> skeletons;
    for (const LoadedTake& one : loaded_) {
      skeletons.push_back(
          {one.take.source, one.take.skeleton, one.take.body, one.take.frame_time, {}, 0, 0});
    }
    return skeletons.empty() ? SharedSkeleton{} : shared_skeleton(skeletons);
  }

  const GraphTakeOptions& options_;
  GraphTakes& result_;
  std::vector<LoadedTake> loaded_;
  std::vector<Problem> problems_;
};

// The height at which toes stand, metres.
double floor_of(const Take& take) {
  std::vector<double> heights;
  for (int f = 0; f < take.frames(); ++f) {
    const auto body = body_at(take, f);
    heights.push_back(std::min(body(1, left_toe), body(1, right_toe)));
  }
  return quantile(std::move(heights), 0.05);
}

// Captures of one figure may have been cleaned differently: nobody shall sink or rise as he
// passes from one into another.
void stand_on_one_floor(std::vector<GraphTake>& takes) {
  std::vector<double> floors;
  for (const GraphTake& one : takes) floors.push_back(floor_of(one.take));
  const double common = quantile(floors, 0.5);
  for (std::size_t t = 0; t < takes.size(); ++t) {
    for (Pose& pose : takes[t].take.poses) pose.root.y() += common - floors[t];
  }
}

Take cycle_take(const MotionSet& set, const Cycle& cycle, double rate, int times) {
  Take take{cycle.name, set.skeleton, set.body, 1 / rate, {}, 0, 0};
  const int frames = static_cast<int>(std::floor(times * cycle.seconds * rate)) + 1;
  for (int f = 0; f < frames; ++f) {
    const double seconds = f / rate;
    Pose pose = pose_at(set, cycle, phase_at(set, cycle, seconds));
    pose.root.x() += seconds * cycle.velocity.x();
    pose.root.z() += seconds * cycle.velocity.y();
    take.poses.push_back(std::move(pose));
  }
  return take;
}

}  // namespace

GraphTakes load_graph_takes(std::vector<TakeSource> sources, const GraphTakeOptions& options,
                            const std::function<void(const TakeSource&)>& progress) {
  std::sort(sources.begin(), sources.end(), [](const TakeSource& a, const TakeSource& b) {
    return std::tie(a.label, a.file) < std::tie(b.label, b.file);
  });
  GraphTakes result;
  GraphTakeLoader loader(options, result);
  for (const TakeSource& source : sources) {
    if (progress) progress(source);
    loader.read(source);
  }
  loader.check_rates();
  loader.finish();
  if (result.takes.empty()) throw InputError("graph", "there is no take to make a graph of");
  stand_on_one_floor(result.takes);
  return result;
}

std::vector<GraphTake> takes_of_set(const MotionSet& set, double rate, int times) {
  assert(rate > 0 && times > 0 && "frames to look at");
  std::vector<GraphTake> takes;
  for (const Cycle& cycle : set.cycles) {
    takes.push_back({cycle_take(set, cycle, rate, times), cycle.style, cycle.origin.sha256});
  }
  return takes;
}

}  // namespace promenade::motion
