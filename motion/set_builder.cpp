#include "motion/set_builder.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "motion/cycle_cut.h"
#include "motion/cycle_names.h"
#include "motion/quantile.h"
#include "motion/shared_skeleton.h"
#include "motion/take_loader.h"

namespace promenade::motion {
namespace {

using Eigen::Vector3d;
using Body = Eigen::Matrix<double, 3, body_joint_count>;

// The body over the origin, turned so that `travel` is ahead.
Body centred(Body body, const Eigen::Matrix3d& turn, double scale) {
  const Vector3d at = body.col(pelvis);
  body.colwise() -= Vector3d(at.x(), 0, at.z());
  return scale * (turn * body);
}

// How the take is turned where the cycle is straight ahead.
Eigen::Matrix3d ahead(const Cut& cut) {
  const Vector3d travel =
      pose_at(cut.part, cut.cycle.keys.back()).root - pose_at(cut.part, cut.cycle.first()).root;
  return Eigen::AngleAxisd(-std::atan2(travel.x(), travel.z()), Vector3d::UnitY())
      .toRotationMatrix();
}

// The most that a joint of the body lies from where it was in the capture (of this scale),
// both with the pelvis over the origin and facing along +Z.
double distance_from_capture(const MotionSet& set, const Cycle& cycle, const Cut& cut) {
  const Eigen::Matrix3d turn = ahead(cut);
  double most = 0;
  for (int k = 0; k < 30; ++k) {
    const double share = k / 30.0;
    const Body original = centred(body_at(cut.part, cut.cycle.first() + share * cut.cycle.length()),
                                  turn, cycle.origin.scale);
    const Body now = centred(body_over_ground(set, cycle, share * cycle.seconds),
                             Eigen::Matrix3d::Identity(), 1);
    most = std::max(most, (now - original).colwise().norm().maxCoeff());
  }
  return most;
}

// A cycle that is cut but not yet cleaned, and where it comes from.
struct RawCycle {
  Cycle cycle;
  const LoadedTake* take;
  const Cut* cut;
  int number;  // of the take
};

void refuse(BuiltSet& built, const LoadedTake& take, const std::string& reason) {
  built.reports.push_back({take.source.label, "", reason});
}

Cycle raw_cycle(const MotionSet& set, const LoadedTake& take, const Cut& cut) {
  Cycle cycle = cut_cycle(set, cut.part, cut.cycle);
  if (take.period > 0) cycle.first_frame %= take.period;
  cycle.style = take.source.style;
  cycle.source = take.source.label;
  cycle.origin.sha256 = take.source.sha256;
  cycle.origin.cycles_found = take.found;
  return cycle;
}

void note_lent(const Fitted& fitted, const LoadedTake& take, BuiltSet& built) {
  if (fitted.lent.empty()) return;
  std::string names;
  for (const std::string& name : fitted.lent) names += (names.empty() ? "" : ", ") + name;
  built.warnings.push_back({take.source.file, 0, 0,
                            "lacks joints of the set's skeleton, which stay unturned: " + names,
                            Severity::warning});
}

std::vector<RawCycle> cut_cycles(const std::vector<LoadedTake>& takes, const SharedSkeleton& shared,
                                 BuiltSet& built) {
  std::vector<RawCycle> raw;
  CycleNames names;
  for (std::size_t i = 0; i < takes.size(); ++i) {
    const LoadedTake& take = takes[i];
    if (!take.refusal.empty()) refuse(built, take, take.refusal);
    for (const Cut& cut : take.cuts) {
      const Fitted fitted = fit_to(shared, cut.part);
      if (!fitted.refusal.empty()) {
        refuse(built, take, fitted.refusal);
        break;
      }
      const Cut here{cut.name, fitted.take, cut.cycle, cut.in_take};
      if (&cut == &take.cuts.front()) note_lent(fitted, take, built);
      raw.push_back({raw_cycle(built.set, take, here), &take, &cut, static_cast<int>(i)});
      raw.back().cycle.name = names.next(take.source.style, cut.name);
    }
  }
  return raw;
}

// All takes stand on one floor: captures of other figures, or with a floor that is not
// level, stand elsewhere.
void stand_on_one_floor(const MotionSet& set, std::vector<RawCycle>& raw) {
  std::vector<double> levels;
  levels.reserve(raw.size());
  for (const RawCycle& one : raw) levels.push_back(toe_level(set, one.cycle));
  if (levels.empty()) return;
  const double common = floor_level(quantile(levels, 0.5));
  for (std::size_t i = 0; i < raw.size(); ++i) {
    raw[i].cycle.root.row(1).array() += common - levels[i];
  }
}

void finish(BuiltSet& built, RawCycle raw, const SetOptions& options) {
  MotionSet& set = built.set;
  Cycle& cycle = raw.cycle;
  CycleReport report;
  report.file = cycle.source;
  report.cycle = cycle.name;
  if (set.walk) {
    report.plant = plant_feet(set, cycle);
    report.slide_left_m = stance_slide_m(set, cycle, Side::left);
    report.slide_right_m = stance_slide_m(set, cycle, Side::right);
  }
  report.seam = seam(set, cycle);
  report.from_capture_m = distance_from_capture(set, cycle, *raw.cut);
  cycle.origin.moved_m = report.from_capture_m;
  report.take = options.keep_takes ? raw.number : -1;
  report.cut = raw.cut->in_take;
  const Eigen::Matrix3d turn = ahead(*raw.cut);
  const auto at = [&](double frame) {
    return centred(body_at(raw.cut->part, frame), turn, cycle.origin.scale);
  };
  report.first = at(raw.cut->cycle.first());
  report.last = at(raw.cut->cycle.keys.back());
  report.closed = centred(body_over_ground(set, cycle, 0), Eigen::Matrix3d::Identity(), 1);
  built.reports.push_back(std::move(report));
  set.cycles.push_back(std::move(cycle));
}

int model_of(const std::vector<LoadedTake>& takes, const SetOptions& options) {
  for (std::size_t i = 0; i < takes.size(); ++i) {
    if (!options.skeleton.empty() && takes[i].source.label == options.skeleton) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

void order_reports(BuiltSet& built) {
  std::stable_sort(built.reports.begin(), built.reports.end(),
                   [](const CycleReport& a, const CycleReport& b) { return a.file < b.file; });
}

std::vector<Problem> refusals(const BuiltSet& built) {
  std::vector<Problem> problems;
  for (const CycleReport& report : built.reports) {
    problems.push_back({report.file, 0, 0, report.refusal, Severity::error});
  }
  return problems;
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
  built.set.walk = options.walk;
  built.set.key_phases = options.key_phases;
  TakeLoader loader(options, built);
  for (const TakeSource& source : sources) {
    if (progress) progress(source);
    loader.load(source);
  }
  if (!loader.problems().empty()) throw InputError(loader.problems());
  if (sources.empty()) throw InputError(options.name, "there is no take to cut a cycle from");
  const SharedSkeleton shared =
      shared_skeleton(loader.skeletons(), model_of(loader.takes(), options));
  built.set.skeleton = shared.skeleton;
  built.set.body = shared.body;
  std::vector<RawCycle> raw = cut_cycles(loader.takes(), shared, built);
  if (raw.empty()) throw InputError(refusals(built));
  if (options.walk) stand_on_one_floor(built.set, raw);
  for (RawCycle& one : raw) finish(built, std::move(one), options);
  order_reports(built);
  return built;
}

}  // namespace promenade::motion
