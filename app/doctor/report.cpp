#include "app/doctor/report.h"

#include <algorithm>

namespace promenade::app {

std::string_view to_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::ok:
      return "ok";
    case Verdict::warning:
      return "warning";
    case Verdict::failure:
      break;
  }
  return "failure";
}

bool DoctorReport::fit() const {
  return std::none_of(checks.begin(), checks.end(),
                      [](const Check& check) { return check.verdict == Verdict::failure; });
}

Json to_json(const DoctorReport& report) {
  Json checks = Json::array();
  for (const Check& check : report.checks) {
    checks.push_back({{"name", check.name},
                      {"verdict", to_text(check.verdict)},
                      {"says", check.says},
                      {"figures", check.figures}});
  }
  return {{"fit", report.fit()}, {"checks", checks}};
}

}  // namespace promenade::app
