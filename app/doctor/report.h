// Is this machine fit for a study, and why? A judgement is a pure function of what was
// measured.
#pragma once

#include <string>
#include <vector>

#include "app/doctor/findings.h"
#include "app/print.h"

namespace promenade::app {

enum class Verdict { ok, warning, failure };
std::string_view to_text(Verdict verdict);

struct Check {
  std::string name;
  Verdict verdict = Verdict::ok;
  std::string says = "";          // one sentence: what, and what to do
  Json figures = Json::object();  // what was measured; units in the names
};

struct DoctorReport {
  std::vector<Check> checks;
  bool fit() const;  // no check failed
};

DoctorReport judge(const Findings& findings);

// {"fit", "checks": [{"name", "verdict", "says", "figures"}]}
Json to_json(const DoctorReport& report);

// How long an event that comes at a random moment waits at most, in that share of all
// cases (0 to 1), microseconds.
double wait_quantile_us(const InputFinding& input, double share);

}  // namespace promenade::app
