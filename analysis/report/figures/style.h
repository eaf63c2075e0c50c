// The look that all figures share: Noto Sans at 8 pt, the colours of Okabe and Ito (2008), and for
// each series a point and a dash of its own, so that grey print loses nothing. Figures are one or
// two columns of a paper wide; everything is measured in millimetres, and names get the room that
// they need or are cut.
#pragma once

#include <string>
#include <vector>

namespace promenade::analysis {

inline constexpr double one_column_mm = 85;
inline constexpr double two_columns_mm = 178;

// Room around the plot of a figure, and what stands there.
struct Frame {
  double width_mm = one_column_mm;
  double plot_mm = 45;  // height of the plot itself
  double left_mm = 14;  // for the scale and the name of the y axis, or for row names
  double below_mm = 0;  // more room under the x axis
  bool y_scale = true;  // a scale of numbers on the left
  std::string x_label, y_label;
  std::vector<std::string> columns;  // names under x = 1, 2, ...; empty: a scale of numbers
  std::vector<std::string> series;   // the legend; empty: none
  std::vector<int> looks;            // of each series: the number of its interface
  bool lines = false;                // whether series are lines; else points
};

struct FramedPlot {
  double height_mm = 0;  // of the whole figure
  double bottom_mm = 0;  // the x axis above the lower edge
  std::string commands;  // margins, axes and legend
};

FramedPlot framed(const Frame& frame);

// How gnuplot draws an interface, the same in every figure: "pt 7 ps 0.5 lw 1.2 lc rgb '#0072b2'".
std::string point_style(int index);  // colour and point
std::string line_style(int index);   // colour and dash
std::string fill_style(int index);   // colour, nearly transparent
std::string bar_style(int index);    // of error bars, whose points are drawn by themselves

// A round step, of which three to seven fill the range; range > 0.
double round_step(double range);

// How wide a text is, about: in units of the type size.
double text_width(const std::string& text);
// A text that is no wider than that, with "…" at its end where it was cut.
std::string fitted(const std::string& text, double width);
// Widths in millimetres of 8 pt type, both ways.
double text_mm(const std::string& text);
std::string fitted_mm(const std::string& text, double width_mm);

}  // namespace promenade::analysis
