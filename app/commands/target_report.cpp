#include "app/commands/target_report.h"

#include <fmt/format.h>

#include <algorithm>

namespace promenade::app {
namespace {

using study::StudyBundle;

bool note_progress(const StudyBundle& bundle, std::size_t done, std::size_t count) {
  show_progress("targets checked:", static_cast<int>(done), static_cast<int>(count));
  if (!interrupted()) return true;
  throw OutsideError(fmt::format("stopped after {} of {} targets of {}", done, count, bundle.file));
}

std::string shown_name(const TargetReport& report) {
  if (!report.sequence) return report.target;
  return fmt::format("{} (order {})", report.target, *report.sequence);
}

}  // namespace

std::vector<TargetReport> report_targets(const StudyBundle& bundle) {
  return report_targets(bundle, [&](const std::vector<TargetReport>& done, std::size_t count) {
    return note_progress(bundle, done.size(), count);
  });
}

Json to_json(const TargetReport& report) {
  Json json = {{"task", report.task},
               {"target", report.target},
               {"practice", report.practice},
               {"sequence", report.sequence ? Json(*report.sequence) : Json(nullptr)},
               {"start", report.start},
               {"threshold_m", to_json(report.threshold_m)},
               {"judged_by_m", report.judged_by_m}};
  json["interfaces"] = Json::array();
  for (const auto& [interface, reach] : report.reaches) {
    json["interfaces"].push_back({{"name", interface},
                                  {"d_start", reach.start},
                                  {"d_best", reach.best},
                                  {"d_best_example", reach.best_example},
                                  {"share_below", reach.share_below},
                                  {"settings", reach.settings}});
  }
  return json;
}

namespace {

// Columns on a terminal, where a Japanese letter takes two: what {fmt} pads by.
std::size_t width_of(const std::string& name) {
  constexpr std::size_t plenty = 1000;
  return plenty - (fmt::format("{:<{}}", name, plenty).size() - name.size());
}

struct NameWidths {
  std::size_t task = 14, target = 14, interface = 14;
};

NameWidths widths_of(const std::vector<TargetReport>& reports) {
  NameWidths widths;
  for (const TargetReport& report : reports) {
    widths.task = std::max(widths.task, width_of(report.task));
    widths.target = std::max(widths.target, width_of(shown_name(report)));
    for (const auto& [interface, reach] : report.reaches) {
      widths.interface = std::max(widths.interface, width_of(interface));
    }
  }
  return widths;
}

std::string names_text(const NameWidths& widths, const std::string& task, const std::string& target,
                       const std::string& interface) {
  return fmt::format("  {:<{}}  {:<{}}  {:<{}}  ", task, widths.task, target, widths.target,
                     interface, widths.interface);
}

}  // namespace

std::string targets_text(const std::vector<TargetReport>& reports) {
  const NameWidths widths = widths_of(reports);
  std::string text = names_text(widths, "task", "target", "interface") +
                     fmt::format("{:>8}{:>10}{:>14}{:>15}\n", "D start", "D best", "best example",
                                 "won by chance");
  for (const TargetReport& report : reports) {
    for (const auto& [interface, reach] : report.reaches) {
      text +=
          names_text(widths, report.task, shown_name(report), interface) +
          fmt::format("{:>8.4f}{:>10.4f}{:>14.4f}", reach.start, reach.best, reach.best_example);
      text += report.threshold_m ? fmt::format("{:>13.1f} %\n", 100 * reach.share_below) : "\n";
    }
  }
  return text;
}

}  // namespace promenade::app
