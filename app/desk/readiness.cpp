#include "app/desk/readiness.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace promenade::app {
namespace {

Light light_of(const std::string& verdict) {
  if (verdict == "ok") return Light::green;
  return verdict == "warning" ? Light::amber : Light::red;
}

}  // namespace

std::string problem_words(const Problem& problem, const study::Texts& words) {
  if (problem.line == 0) return problem.message;
  return words.with("shell.at_line",
                    {{"line", std::to_string(problem.line)}, {"message", problem.message}});
}

std::vector<ReadyLine> lines_of_study(const StudyReading* reading, const study::Texts& words) {
  if (reading == nullptr) return {{Light::unknown, words("run.study"), words("run.reading")}};
  std::vector<ReadyLine> lines;
  if (!reading->bundle) {
    lines.push_back(
        {Light::red, words("run.study"), problem_words(reading->problems.front(), words)});
  } else if (reading->problems.empty()) {
    lines.push_back({Light::green, words("run.study"), words("run.study_ready")});
  }
  for (const Problem& problem : reading->problems) {
    if (reading->bundle)
      lines.push_back({Light::amber, words("run.study"), problem_words(problem, words)});
  }
  if (!reading->database_problem.empty()) {
    lines.push_back({Light::red, words("run.database"), reading->database_problem});
  } else if (reading->amendment_due) {
    lines.push_back({Light::red, words("run.database"), words("run.amendment_due")});
  }
  return lines;
}

std::vector<ReadyLine> read_doctor(const std::string& json) {
  std::vector<ReadyLine> lines;
  const nlohmann::json report = nlohmann::json::parse(json, nullptr, false);
  if (!report.is_object() || !report.contains("checks")) return lines;
  for (const nlohmann::json& check : report["checks"]) {
    lines.push_back({light_of(check.value("verdict", "failure")), check.value("name", ""),
                     check.value("says", "")});
  }
  return lines;
}

Light worst(const std::vector<ReadyLine>& lines) {
  Light worst = Light::green;
  for (const ReadyLine& line : lines) {
    if (line.light == Light::unknown) worst = std::max(worst, Light::amber);
    worst = std::max(worst, line.light);
  }
  return worst;
}

}  // namespace promenade::app
