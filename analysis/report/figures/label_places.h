// Where the names of dots have room in a drawing. All is in millimetres, up is positive.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace promenade::analysis {

struct Dot {
  double x_mm = 0, y_mm = 0;
  std::string name;
};

struct LabelPlace {
  double left_mm = 0, middle_mm = 0;  // of the text: its left end, half its height
};

// Places names of `points` pt beside their dots, in order: right, left, above, below or aslant,
// within 0 to `width_mm` and `height_mm`, over no dot and no other name. Nothing where none of
// these is free.
std::vector<std::optional<LabelPlace>> label_places(const std::vector<Dot>& dots, double width_mm,
                                                    double height_mm, double points);

}  // namespace promenade::analysis
