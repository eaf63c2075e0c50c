#include "app/path_drawing.h"

#include <algorithm>
#include <cassert>

namespace promenade::app {
namespace {

// Between the corners of a stroke. A step is three times as long: what is finer is the hand.
constexpr double stroke_step_m = 0.2;
constexpr double same_place_m = 0.01;

Eigen::Matrix2Xd points_of(const std::vector<DrawnCorner>& corners) {
  Eigen::Matrix2Xd points(2, static_cast<Eigen::Index>(corners.size()));
  for (std::size_t c = 0; c < corners.size(); ++c) {
    points.col(static_cast<Eigen::Index>(c)) = corners[c].at;
  }
  return points;
}

// Metres of the curve at each corner: it leads through all of them.
std::vector<double> reached(const std::vector<DrawnCorner>& corners,
                            const Eigen::Matrix2Xd& curve) {
  constexpr double rounding_m = 1e-6;
  std::vector<double> metres = {0};
  double way = 0;
  for (Eigen::Index i = 1; i < curve.cols() && metres.size() < corners.size(); ++i) {
    way += (curve.col(i) - curve.col(i - 1)).norm();
    if ((curve.col(i) - corners[metres.size()].at).norm() < rounding_m) metres.push_back(way);
  }
  metres.resize(corners.size(), way);
  return metres;
}

std::vector<motion::PathPart> parts_of(const std::vector<DrawnCorner>& corners,
                                       const std::vector<double>& metres) {
  std::vector<motion::PathPart> parts;
  for (std::size_t c = 1; c < corners.size(); ++c) {
    if (corners[c].label.empty()) continue;
    const bool goes_on = !parts.empty() && parts.back().to_m == metres[c - 1] &&
                         parts.back().label == corners[c].label;
    if (goes_on) {
      parts.back().to_m = metres[c];
    } else {
      parts.push_back({metres[c - 1], metres[c], corners[c].label});
    }
  }
  return parts;
}

}  // namespace

WantedPath path_through(const std::vector<DrawnCorner>& corners, WayThrough way) {
  assert(corners.size() >= 2 && "a path leads from somewhere to somewhere else");
  WantedPath path;
  path.points = points_of(corners);
  if (way == WayThrough::smooth) path.points = motion::smooth_path(path.points);
  const std::vector<double> metres = reached(corners, path.points);
  path.parts = parts_of(corners, metres);
  path.length = motion::GroundPath(path.points).length();
  return path;
}

PathDrawing::PathDrawing(const study::PathTable& table) {
  for (Eigen::Index p = 0; p < table.points.cols(); ++p) {
    // A label of the table is wanted from its point on.
    chosen_ = p > 0 ? table.labels[static_cast<std::size_t>(p) - 1] : std::string();
    add_corner(table.points.col(p));
  }
  chosen_.clear();
  end();
}

bool PathDrawing::is_last(const Eigen::Vector2d& at, double within_m) const {
  return !corners_.empty() && (corners_.back().at - at).norm() < within_m;
}

void PathDrawing::begin_stroke(const Eigen::Vector2d& at) {
  drawing_ = true;
  ++strokes_;
  if (!is_last(at, stroke_step_m)) corners_.push_back({at, chosen_, strokes_});
}

void PathDrawing::draw_to(const Eigen::Vector2d& at) {
  assert(drawing_ && "a stroke has begun");
  if (!is_last(at, stroke_step_m)) corners_.push_back({at, chosen_, strokes_});
}

void PathDrawing::end_stroke(const Eigen::Vector2d& at) {
  drawing_ = false;
  // It ends where the hand ended, without a short last leg.
  const std::size_t count = corners_.size();
  const bool short_leg = is_last(at, stroke_step_m / 2) && count >= 2 &&
                         corners_[count - 1].stroke == strokes_ &&
                         corners_[count - 2].stroke == strokes_;
  if (short_leg) {
    corners_.back().at = at;
  } else if (!is_last(at, same_place_m)) {
    corners_.push_back({at, chosen_, strokes_});
  }
  end();
}

void PathDrawing::add_corner(const Eigen::Vector2d& at) {
  if (!is_last(at, same_place_m)) corners_.push_back({at, chosen_, 0});
}

bool PathDrawing::end() {
  if (corners_.size() < 2) return false;
  if (open()) ++revision_;
  ended_ = corners_.size();
  return true;
}

void PathDrawing::take_back() {
  if (corners_.empty() || drawing_) return;
  const int stroke = corners_.back().stroke;
  do {
    corners_.pop_back();
  } while (stroke > 0 && !corners_.empty() && corners_.back().stroke == stroke);
  if (corners_.size() >= ended_) return;
  ended_ = corners_.size() < 2 ? 0 : corners_.size();
  ++revision_;
}

void PathDrawing::clear() {
  corners_.clear();
  ended_ = 0;
  drawing_ = false;
  ++revision_;
}

std::optional<WantedPath> PathDrawing::wanted() const {
  if (ended_ < 2) return {};
  return path_through({corners_.begin(), corners_.begin() + static_cast<std::ptrdiff_t>(ended_)});
}

}  // namespace promenade::app
