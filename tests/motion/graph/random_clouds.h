// Clouds for tests of distances: points that wander, as bodies do.
#pragma once

#include "motion/graph/clouds.h"
#include "motion/graph/planar_move.h"
#include "tests/motion/models/random.h"

namespace promenade::motion {

// Points about a metre from a centre that walks some centimetres a frame, over a ground whose
// origin may be far away. Weights between 0.2 and 1.2.
inline Clouds random_clouds(std::uint64_t seed, int frames, int points, double far_away = 0) {
  Random random(seed);
  Clouds clouds;
  clouds.weights = random.uniforms(points, 1).array() + 0.2;
  clouds.points.resize(3, static_cast<Eigen::Index>(frames) * points);
  Eigen::Matrix3Xd body = 0.5 * random.normals(3, points);
  Eigen::Vector3d centre(far_away, 1, -far_away);
  for (int f = 0; f < frames; ++f) {
    body += 0.03 * random.normals(3, points);
    centre += 0.02 * random.normals(3, 1);
    clouds.points.middleCols(static_cast<Eigen::Index>(f) * points, points) =
        body.colwise() + centre;
  }
  return clouds;
}

inline Clouds moved(const PlanarMove& move, Clouds clouds) {
  for (Eigen::Index i = 0; i < clouds.points.cols(); ++i) {
    clouds.points.col(i) = moved(move, Eigen::Vector3d(clouds.points.col(i)));
  }
  return clouds;
}

// Frames from `from` on.
inline Clouds part(const Clouds& clouds, int from, int frames) {
  const Eigen::Index points = clouds.weights.size();
  return {clouds.points.middleCols(from * points, frames * points), clouds.weights};
}

inline std::vector<double> even_taper(int window) {
  return std::vector<double>(static_cast<std::size_t>(window), 1.0 / window);
}

inline std::vector<double> uneven_taper(int window) {
  std::vector<double> taper;
  for (int p = 0; p < window; ++p) taper.push_back(1 + std::sin(0.3 * p));
  return taper;
}

}  // namespace promenade::motion
