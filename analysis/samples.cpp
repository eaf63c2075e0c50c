#include "analysis/samples.h"

#include <cstring>

#include "analysis/item.h"
#include "study/migrate.h"
#include "study/study.h"

namespace promenade::analysis {
namespace {

constexpr const char* set_query =
    "SELECT motion_set.sha256 FROM session JOIN study ON study.uuid = session.study "
    "JOIN motion_set ON motion_set.uuid = coalesce(study.motion_set, motion_set.uuid) "
    "WHERE session.uuid = ? LIMIT 1";

}  // namespace

SampleReader::SampleReader(const std::string& file, const study::StudyBundle& bundle)
    : bundle_(bundle),
      database_(study::open_log(file)),
      set_(database_, set_query),
      samples_(database_, "SELECT t_us, weights FROM sample WHERE trial = ? ORDER BY t_us, rowid"),
      weights_(bundle.space.set.size()) {}

bool SampleReader::has_same_set(const std::string& session) {
  if (session != session_) {
    session_ = session;
    set_.reset();
    same_ = set_.bind(1, session).step() && set_.text(0) == bundle_.set_sha256;
  }
  return same_;
}

void SampleReader::each(const std::string& trial, const Use& use) {
  const auto bytes = static_cast<std::size_t>(weights_.size()) * sizeof(double);
  samples_.reset();
  samples_.bind(1, trial);
  while (samples_.step()) {
    const std::string_view blob = samples_.blob(1);
    if (blob.size() != bytes) continue;
    std::memcpy(weights_.data(), blob.data(), bytes);
    use(samples_.integer(0), weights_);
  }
}

void for_each_trial(const Log& log, const Dataset& data, const study::StudyBundle& bundle,
                    const std::function<void(SampleReader& reader, int trial)>& use) {
  for (int file = 0; file < size_of(log.files); ++file) {
    SampleReader reader(item(log.files, file).file, bundle);
    for (int i = 0; i < size_of(data.trials); ++i) {
      const LoggedTrial& logged = item(log.trials, item(data.trials, i).logged);
      if (item(log.sessions, logged.session).file == file) use(reader, i);
    }
  }
}

std::vector<std::optional<Eigen::VectorXd>> final_weights(const Log& log, const Dataset& data,
                                                          const study::StudyBundle& bundle,
                                                          const std::vector<bool>& tasks) {
  std::vector<std::optional<Eigen::VectorXd>> finals(data.trials.size());
  for_each_trial(log, data, bundle, [&](SampleReader& reader, int trial) {
    if (!tasks[static_cast<std::size_t>(item(data.trials, trial).task)]) return;
    const LoggedTrial& logged = item(log.trials, item(data.trials, trial).logged);
    if (!reader.has_same_set(item(log.sessions, logged.session).uuid)) return;
    std::optional<Eigen::VectorXd>& last = item(finals, trial);
    reader.each(logged.uuid,
                [&last](std::int64_t, const Eigen::VectorXd& weights) { last = weights; });
    if (last && !last->allFinite()) last.reset();
  });
  return finals;
}

}  // namespace promenade::analysis
