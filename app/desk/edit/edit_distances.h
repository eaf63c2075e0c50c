// How near each interface can come to each target of the study: the table of `check`, made in a
// thread and made again when the study changes.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/desk/edit/edit_controls.h"
#include "app/desk/newest_work.h"
#include "app/target_reports.h"

namespace promenade::app {

class EditDistances {
 public:
  // Only while it is looked at: null or the same study starts nothing.
  void follow(const std::shared_ptr<const study::StudyBundle>& bundle);
  void advance();
  bool working() const { return work_.working(); }
  void draw(const FormPass& pass, const Box& box);
  const std::vector<TargetReport>& reports() const { return table_.reports; }

 private:
  struct Table {
    std::vector<TargetReport> reports;
    std::vector<Problem> warnings;
  };
  // Of the thread's, while it works.
  struct Progress {
    std::mutex mutex;
    std::vector<TargetReport> reports;
    std::size_t count = 0;  // of all targets
  };
  void show(std::vector<TargetReport> reports);
  float draw_rows(const FormPass& pass, const Box& box) const;
  void draw_row(const FormPass& pass, const TargetReport& report, const Box& row) const;
  Box cell(const Box& row, std::size_t column) const;

  std::shared_ptr<const study::StudyBundle> bundle_;  // of the table, or of the work
  std::vector<std::string> columns_;                  // names of interfaces
  Table table_;
  std::shared_ptr<Progress> progress_;
  std::size_t count_ = 0;  // of the targets that are searched for
  NewestWork<Table> work_;
};

}  // namespace promenade::app
