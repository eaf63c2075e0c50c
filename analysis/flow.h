// How many people came how far: from the places of a roster to those who are analysed.
#pragma once

#include "analysis/log.h"
#include "analysis/selection.h"

namespace promenade::analysis {

struct Flow {
  // From the roster; all 0 where there was none. A withdrawal that removes everything removes the
  // place, too.
  int booked = 0;    // places that were ever dealt
  int no_show = 0;   // did not come
  int replaced = 0;  // did not come, and somebody else got their order
  int expected = 0;  // still to come

  int began = 0;  // with those who withdrew and of whom nothing was kept
  int declined = 0;
  int withdrawn = 0;
  int removed = 0;  // of these, without any row left
  int unfinished = 0, excluded = 0, analysed = 0;
};

Flow flow_of(const Log& log, const Selection& selection);

}  // namespace promenade::analysis
