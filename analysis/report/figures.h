// The figures of a report, drawn by gnuplot: one style, safe for colour-blind readers and in grey,
// as SVG for the page and PDF for papers. Beside NAME.svg and NAME.pdf stand the data, NAME.csv,
// and the script that draws them again, `gnuplot NAME.gp`.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/progress.h"
#include "analysis/report/section.h"
#include "analysis/report/tables.h"
#include "analysis/results.h"

namespace promenade::analysis {

struct Figure {
  int task = 0;         // -1: the whole study
  std::string name;     // of the files, without extension
  std::string title;    // a few words: "Final D per participant"
  std::string caption;  // what it shows, with n
  double width_mm = 85, height_mm = 60;
  // Figure::name.csv and, where there are more, files with the names of these tables. Numbers come
  // first in each row, text last; a row without cells is an empty line, where a curve is broken.
  std::vector<Table> data;
  std::string setup;  // gnuplot commands for axes and legend, and
  std::string plot;   // the one that draws
};

struct DrawnFigure {
  Figure figure;
  std::string svg;  // bytes of the file
};

// All that the data can show, by task; each kind is a file in figures/.
std::vector<Figure> figures_of(const Results& results);

// NAME.gp, which reads the data and writes NAME.svg and NAME.pdf.
std::string script_of(const Figure& figure);

// Draws into `folder`, which exists, on all cores. Throws OutsideError.
std::vector<DrawnFigure> draw(const std::vector<Figure>& figures,
                              const std::filesystem::path& folder, const Progress& progress = {});

// A section that shows nothing on the page: "figures" in report.json, with all data.
Section figure_numbers(const std::vector<Figure>& figures);

}  // namespace promenade::analysis
