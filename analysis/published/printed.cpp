#include "analysis/published/printed.h"

namespace promenade::analysis {

const PrintedStudy* printed_study(std::string_view name) {
  static const std::vector<PrintedStudy> all = [] {
    std::vector<PrintedStudy> studies = printed_by_oshita();
    for (PrintedStudy& one : printed_by_normoyle()) studies.push_back(std::move(one));
    return studies;
  }();
  for (const PrintedStudy& one : all) {
    if (one.name == name) return &one;
  }
  return nullptr;
}

}  // namespace promenade::analysis
