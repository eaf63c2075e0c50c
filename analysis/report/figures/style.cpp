#include "analysis/report/figures/style.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/item.h"
#include "analysis/report/gnuplot.h"

namespace promenade::analysis {
namespace {

constexpr double em_mm = 8 * 25.4 / 72;  // of the type
constexpr double right_mm = 3;
constexpr double top_mm = 2.5;
constexpr double tics_mm = 6;  // for numbers or short names under the x axis
constexpr double legend_row_mm = 4.2;
constexpr double sample_mm = 5;    // of a series in the legend, with the gap behind it
constexpr double gap_mm = 3.5;     // between two names of the legend
constexpr double turned = 0.7071;  // names that have no room stand at 45 degrees

struct Look {
  const char* colour;
  int point;
  const char* dash;
};

const Look& look(int index) {
  static const std::array<Look, 8> all = {{{"#0072b2", 7, "1"},
                                           {"#e69f00", 5, "(10,4)"},
                                           {"#009e73", 9, "(3,3)"},
                                           {"#d55e00", 13, "(10,3,2,3)"},
                                           {"#cc79a7", 11, "(16,4)"},
                                           {"#56b4e9", 6, "(6,3,2,3,2,3)"},
                                           {"#000000", 4, "(1,3)"},
                                           {"#777777", 8, "(12,3,2,3,2,3)"}}};
  return all[static_cast<std::size_t>(index) % all.size()];
}

// The code point that begins at `at`, which moves behind it; a stray byte is a letter.
unsigned next_letter(const std::string& text, std::size_t& at) {
  const auto byte = static_cast<unsigned char>(text[at++]);
  if (byte < 0xc0u) return byte;
  unsigned code = byte & (byte < 0xe0u ? 0x1fu : byte < 0xf0u ? 0x0fu : 0x07u);
  while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0u) == 0x80u) {
    code = code << 6u | (static_cast<unsigned char>(text[at++]) & 0x3fu);
  }
  return code;
}

double letter_width(unsigned code) {
  if (code >= 0x1100u) return code >= 0x2000u && code < 0x2e80u ? 0.8 : 1;  // Japanese
  if (code == 'i' || code == 'l' || code == ' ' || code == '.' || code == ',') return 0.29;
  if (code == 'm' || code == 'w' || code == 'M' || code == 'W') return 0.93;
  return code >= 'A' && code <= 'Z' ? 0.66 : 0.58;
}

std::string legend_entry(const Frame& frame, int index, double x_mm, double y) {
  const double x = x_mm / frame.width_mm;
  const double end = (x_mm + sample_mm - 1) / frame.width_mm;
  std::string entry;
  if (frame.lines) {
    entry += fmt::format("set arrow from screen {:.4f},{:.4f} to screen {:.4f},{:.4f} nohead {}\n",
                         x, y, end, y, line_style(item(frame.looks, index)));
  } else {
    entry += fmt::format("set label '' at screen {:.4f},{:.4f} point {} front\n", (x + end) / 2, y,
                         point_style(item(frame.looks, index)));
  }
  return entry + fmt::format("set label {} at screen {:.4f},{:.4f} left\n",
                             gnuplot_text(item(frame.series, index)),
                             (x_mm + sample_mm) / frame.width_mm, y);
}

// Where the entries of a legend stand: row, and millimetres from the left.
struct Seat {
  int row = 0;
  double x_mm = 0;
};

std::vector<Seat> seats(const Frame& frame) {
  std::vector<Seat> result;
  Seat seat{0, 3};
  for (const std::string& name : frame.series) {
    const double width = sample_mm + text_mm(name) + gap_mm;
    if (seat.x_mm > 3 && seat.x_mm + width - gap_mm > frame.width_mm) seat = {seat.row + 1, 3};
    result.push_back(seat);
    seat.x_mm += width;
  }
  return result;
}

double slot_mm(const Frame& frame) {
  return (frame.width_mm - frame.left_mm - right_mm) / static_cast<double>(frame.columns.size());
}

bool is_crowded(const Frame& frame) {
  return std::any_of(frame.columns.begin(), frame.columns.end(),
                     [&](const std::string& name) { return text_mm(name) > slot_mm(frame) - 1.5; });
}

// Names that are turned reach to the left of their column; they must not leave the figure.
std::vector<std::string> column_names(const Frame& frame) {
  if (!is_crowded(frame)) return frame.columns;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < frame.columns.size(); ++i) {
    const double room = frame.left_mm + slot_mm(frame) * (static_cast<double>(i) + 0.5) - 2;
    names.push_back(fitted_mm(frame.columns[i], std::min(26.0, room / turned)));
  }
  return names;
}

double names_height(const Frame& frame, const std::vector<std::string>& names) {
  if (!is_crowded(frame)) return tics_mm;
  double widest = 0;
  for (const std::string& name : names) widest = std::max(widest, text_mm(name));
  return widest * turned + 4;
}

std::string column_tics(const Frame& frame, const std::vector<std::string>& names) {
  std::string tics;
  for (std::size_t i = 0; i < names.size(); ++i) {
    tics += fmt::format("{}{} {}", i > 0 ? ", " : "", gnuplot_text(names[i]), i + 1);
  }
  return fmt::format("set xrange [0.5:{}.5]\nset xtics ({}) scale 0{} nomirror\n", names.size(),
                     tics, is_crowded(frame) ? " rotate by 45 right" : "");
}

}  // namespace

FramedPlot framed(const Frame& given) {
  Frame frame = given;
  for (std::string& name : frame.series) {
    name = fitted_mm(name, std::min(45.0, frame.width_mm - sample_mm - 6));
  }
  const std::vector<Seat> places = seats(frame);
  const std::vector<std::string> names = column_names(frame);
  const double legend = places.empty() ? 0 : legend_row_mm * (places.back().row + 1);
  FramedPlot plot;
  plot.bottom_mm = frame.below_mm + (frame.columns.empty() ? tics_mm : names_height(frame, names)) +
                   (frame.x_label.empty() ? 0 : 4);
  plot.height_mm = top_mm + legend + frame.plot_mm + plot.bottom_mm;
  const double height = plot.height_mm;
  plot.commands = fmt::format(
      "set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\n"
      "set bmargin at screen {:.4f}\nset tmargin at screen {:.4f}\n",
      frame.left_mm / frame.width_mm, 1 - right_mm / frame.width_mm, plot.bottom_mm / height,
      (plot.bottom_mm + frame.plot_mm) / height);
  plot.commands += frame.columns.empty() ? "set xtics nomirror scale 0.5 offset 0,0.3\n"
                                         : column_tics(frame, names);
  if (!frame.x_label.empty()) {
    plot.commands +=
        fmt::format("set label {} at screen {:.4f},{:.4f} center\n", gnuplot_text(frame.x_label),
                    (frame.left_mm + frame.width_mm - right_mm) / 2 / frame.width_mm,
                    (frame.below_mm + 2) / height);
  }
  if (!frame.y_label.empty()) {
    plot.commands +=
        fmt::format("set label {} at screen {:.4f},{:.4f} center rotate by 90\n",
                    gnuplot_text(fitted_mm(frame.y_label, frame.plot_mm + 4)), 2.5 / frame.width_mm,
                    (plot.bottom_mm + frame.plot_mm / 2) / height);
  }
  for (int i = 0; i < size_of(frame.series); ++i) {
    const double down = top_mm + legend_row_mm * (item(places, i).row + 0.35);
    plot.commands += legend_entry(frame, i, item(places, i).x_mm, 1 - down / height);
  }
  return plot;
}

std::string point_style(int index) {
  return fmt::format("pt {} ps 0.5 lw 1.2 lc rgb '{}'", look(index).point, look(index).colour);
}

std::string bar_style(int index) {
  return fmt::format("pt 0 lw 1.2 lc rgb '{}'", look(index).colour);
}

std::string line_style(int index) {
  return fmt::format("dt {} lw 2 lc rgb '{}'", look(index).dash, look(index).colour);
}

std::string fill_style(int index) {
  return fmt::format("fs transparent solid 0.13 noborder lc rgb '{}'", look(index).colour);
}

double round_step(double range) {
  const double rough = range / 6;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough) return factor * power;
  }
  return 10 * power;
}

double text_width(const std::string& text) {
  double width = 0;
  for (std::size_t at = 0; at < text.size();) width += letter_width(next_letter(text, at));
  return width;
}

std::string fitted(const std::string& text, double width) {
  if (text_width(text) <= width) return text;
  double used = 0.8;  // the dots
  std::size_t end = 0;
  for (std::size_t at = 0; at < text.size();) {
    used += letter_width(next_letter(text, at));
    if (used > width) break;
    end = at;
  }
  return text.substr(0, end) + "…";
}

double text_mm(const std::string& text) { return text_width(text) * em_mm; }

std::string fitted_mm(const std::string& text, double width_mm) {
  return fitted(text, width_mm / em_mm);
}

}  // namespace promenade::analysis
