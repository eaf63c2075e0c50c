// The cases of the statistics vectors, when they are there.
#pragma once

#include <Eigen/Dense>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/source_dir.h"

namespace promenade::motion {

inline nlohmann::json vector_cases(const std::string& family) {
  const char* data = std::getenv("PROMENADE_DATA");
  const std::filesystem::path folder =
      data ? data : source_dir() / "../shared/data";
  const std::filesystem::path path = folder / "../stats/vectors.json";
  if (!std::filesystem::exists(path)) return nlohmann::json::array();
  std::ifstream file(path);
  return nlohmann::json::parse(file)["families"][family];
}

inline Eigen::MatrixXd to_matrix(const nlohmann::json& rows) {
  Eigen::MatrixXd result(rows.size(), rows.empty() ? 0 : rows[0].size());
  for (Eigen::Index r = 0; r < result.rows(); ++r) {
    for (Eigen::Index c = 0; c < result.cols(); ++c) {
      result(r, c) = rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)].get<double>();
    }
  }
  return result;
}

inline Eigen::VectorXd to_vector(const nlohmann::json& values) {
  Eigen::VectorXd result(values.size());
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    result(i) = values[static_cast<std::size_t>(i)].get<double>();
  }
  return result;
}

}  // namespace promenade::motion
