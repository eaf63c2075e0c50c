// What trials showed, out of table `sample` of the databases: weights over the motions of a study.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset.h"
#include "study/sqlite.h"

namespace promenade::study {
struct StudyBundle;
}  // namespace promenade::study

namespace promenade::analysis {

// The samples of one database. Opened read-only; InputError when it is gone.
class SampleReader {
 public:
  SampleReader(const std::string& file, const study::StudyBundle& bundle);

  // Did this session show the motions of the study? Another version may have had others.
  bool has_same_set(const std::string& session);

  // In the order shown; samples that are not N weights are passed over, others may be infinite.
  using Use = std::function<void(std::int64_t t_us, const Eigen::VectorXd& weights)>;
  void each(const std::string& trial, const Use& use);

 private:
  const study::StudyBundle& bundle_;
  study::Database database_;
  study::Statement set_, samples_;
  Eigen::VectorXd weights_;
  std::string session_;
  bool same_ = false;
};

// Every trial of the data with the reader of its file.
void for_each_trial(const Log& log, const Dataset& data, const study::StudyBundle& bundle,
                    const std::function<void(SampleReader& reader, int trial)>& use);

// What each trial of these tasks ended with, N finite weights, one entry for each trial of the
// data. Nothing where the motions were others or nothing was shown, and of other tasks.
std::vector<std::optional<Eigen::VectorXd>> final_weights(const Log& log, const Dataset& data,
                                                          const study::StudyBundle& bundle,
                                                          const std::vector<bool>& tasks);

}  // namespace promenade::analysis
