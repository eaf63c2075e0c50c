// How many people are needed to find a difference: a rehearsal of the study with simulated people,
// by `promenade power`.
#pragma once

#include <string>
#include <vector>

#include "app/desk/column.h"
#include "app/desk/open_study.h"
#include "app/desk/services.h"
#include "study/texts.h"

namespace promenade::app {

// The share of studies of this size that found the difference.
struct PowerRow {
  std::string task, measure, pair;
  std::vector<double> power;  // by the sizes of PowerTable
};
struct PowerTable {
  std::vector<int> people;
  std::vector<PowerRow> rows;
};
// From what `promenade power --json` printed; empty when that is none.
PowerTable read_power(const std::string& json);
// The smallest number of people from which on the power is at least `wanted`; 0: none was tried.
int needed_people(const PowerTable& table, const PowerRow& row, double wanted);

class PlanPower {
 public:
  PlanPower(DeskServices& services, OpenStudy& study) : services_(services), study_(study) {}
  // "press" "power".
  void draw(const Ui& ui, const study::Texts& words, Column& column, int people);

 private:
  void start(const study::Texts& words, int people);
  void draw_table(const Ui& ui, const study::Texts& words, Column& column) const;

  DeskServices& services_;
  OpenStudy& study_;
  PowerTable table_;
};

}  // namespace promenade::app
