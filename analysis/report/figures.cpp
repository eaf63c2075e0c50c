#include "analysis/report/figures.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/gnuplot.h"
#include "motion/files.h"

namespace promenade::analysis {
namespace {

// Letters and digits of a name, for a file; others become '-'.
std::string slug(const std::string& name) {
  std::string result;
  for (const char letter : name) {
    const bool plain = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                       (letter >= '0' && letter <= '9') || letter == '_';
    result += plain ? letter : '-';
  }
  return result.substr(0, 40);
}

double largest_value(const std::vector<const Summary*>& summaries) {
  double largest = 0;
  for (const Summary* summary : summaries) {
    for (const auto& value : summary->values) largest = std::max(largest, value.value_or(0));
  }
  return largest;
}

// The line at the limit or threshold of a task, where it would not squeeze the dots;
// nothing: none.
std::optional<double> reference(const Results& results, const Figure& figure) {
  const Task& task = item(results.data.tasks, figure.task);
  const std::string& measure = item(results.data.measures, figure.measure).name;
  const auto line = measure == "time_s" ? task.limit_s : task.threshold_m;
  const double largest = largest_value(results.summaries_of(figure.measure, figure.task));
  return line && *line <= 1.5 * largest ? line : std::nullopt;
}

std::string caption_of(const Results& results, const Figure& figure) {
  const Measure& measure = item(results.data.measures, figure.measure);
  std::string caption = fmt::format(
      "{} in task {}. Each dot is one participant (mean over targets), grey lines join the same "
      "person; squares are medians with 95 % intervals",
      capitalised(measure.label), item(results.data.tasks, figure.task).name);
  std::string counts;
  for (const Summary* summary : results.summaries_of(figure.measure, figure.task)) {
    counts += fmt::format("{}{} n = {}", counts.empty() ? "" : ", ",
                          item(results.data.interfaces, summary->interface), summary->n);
  }
  caption += "; " + counts + ".";
  if (const auto line = reference(results, figure)) {
    caption += fmt::format(" The dashed line is the {}, {}.",
                           measure.name == "time_s" ? "time limit" : "threshold",
                           with_unit(measure, *line));
  }
  return caption;
}

// "x y" lines; a person's dots stand together, an empty line parts people.
std::string people_data(const std::vector<const Summary*>& summaries, const Measure& measure) {
  std::string data = "$people << EOD\n";
  for (std::size_t person = 0; person < summaries[0]->values.size(); ++person) {
    for (std::size_t i = 0; i < summaries.size(); ++i) {
      const auto& value = summaries[i]->values[person];
      if (value) data += fmt::format("{} {}\n", i + 1, *value * measure.scale);
    }
    data += "\n";
  }
  return data + "EOD\n";
}

std::string median_data(const std::vector<const Summary*>& summaries, const Measure& measure) {
  std::string data = "$medians << EOD\n";
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    const double median = *summaries[i]->median;
    const Interval ci = summaries[i]->median_ci.value_or(Interval{median, median});
    data += fmt::format("{} {} {} {}\n", static_cast<double>(i + 1) + 0.22, median * measure.scale,
                        ci.lower * measure.scale, ci.upper * measure.scale);
  }
  return data + "EOD\n";
}

// In centimetres; the height is 7.5.
double width_of(const std::vector<const Summary*>& summaries) {
  return 9.0 + 1.5 * std::max(0, size_of(summaries) - 3);
}

// Names longer than this would leave the picture.
std::string shortened(const std::string& name) {
  constexpr std::size_t most = 24;  // letters, not bytes
  std::string result;
  std::size_t letters = 0;
  for (const char byte : name) {
    const bool begins = (static_cast<unsigned char>(byte) & 0xc0u) != 0x80u;
    if (begins && ++letters == most) return result + "…";
    result += byte;
  }
  return result;
}

std::string axes(const Results& results, const std::vector<const Summary*>& summaries,
                 const Measure& measure, double top) {
  // Names that do not fit side by side are turned.
  std::string ticks;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    const std::string name = shortened(item(results.data.interfaces, summaries[i]->interface));
    longest = std::max(longest, name.size());
    ticks += fmt::format("{}{} {}", i > 0 ? ", " : "", gnuplot_text(name), i + 1);
  }
  const double room = 6 * width_of(summaries);  // letters that fit side by side
  const bool crowded = static_cast<double>((longest + 2) * summaries.size()) > room;
  return fmt::format(
      "set xrange [0.5:{}]\nset yrange [0:{}]\n"
      "set xtics ({}) scale 0{}\nset bmargin {}\nset ytics nomirror\nset ylabel {}\n",
      static_cast<double>(summaries.size()) + 0.6, top > 0 ? top * 1.06 : 1.0, ticks,
      crowded ? " rotate by -25" : "", crowded ? 2 + longest / 5 : 3,
      gnuplot_text(heading(measure)));
}

constexpr const char* style =
    "set encoding utf8\nset border 3 lc rgb '#444444'\nset key off\n"
    "set grid ytics lc rgb '#dddddd' lw 1\nset rmargin 6\n";

constexpr const char* plot =
    "plot $people using 1:2 with lines lc rgb '#bbbbbb' lw 1, \\\n"
    "  $people using 1:2 with points pt 7 ps 0.55 lc rgb '#0072b2', \\\n"
    "  $medians using 1:2:3:4 with yerrorbars pt 5 ps 0.9 lw 2.2 lc rgb '#000000'";

}  // namespace

std::vector<Figure> figures_of(const Results& results) {
  std::vector<Figure> figures;
  const bool several = results.data.tasks.size() > 1;
  for (const char* name : {"d_final", "time_s"}) {
    const int measure = results.data.measure(name);
    for (int task = 0; task < size_of(results.data.tasks); ++task) {
      if (results.summaries_of(measure, task).empty()) continue;
      Figure figure{name, "", measure, task};
      if (several) {
        figure.name += fmt::format("-{}-{}", task + 1, slug(item(results.data.tasks, task).name));
      }
      figure.caption = caption_of(results, figure);
      figures.push_back(figure);
    }
  }
  return figures;
}

std::string script_of(const Results& results, const Figure& figure) {
  const Measure& measure = item(results.data.measures, figure.measure);
  const auto summaries = results.summaries_of(figure.measure, figure.task);
  const auto line = reference(results, figure);
  const double top = std::max(largest_value(summaries), line.value_or(0)) * measure.scale;
  std::string body = style + axes(results, summaries, measure, top) +
                     people_data(summaries, measure) + median_data(summaries, measure);
  if (line) {
    body += fmt::format(
        "set arrow 1 from graph 0, first {0} to graph 1, first {0} nohead dt 2 lw 1.2 lc rgb "
        "'#444444'\n",
        *line * measure.scale);
  }
  const double width = width_of(summaries);
  return fmt::format(
      "{0}set terminal svg size {1:.0f},{2:.0f} font 'Noto Sans,13' noenhanced background "
      "'#ffffff'\nset output '{3}.svg'\n{4}\nset output\n"
      "set terminal pdfcairo size {5:.2f}cm,7.5cm font 'Noto Sans,9' noenhanced\n"
      "set output '{3}.pdf'\n{4}\nset output\n",
      body, width * 52, 7.5 * 52, figure.name, plot, width);
}

void draw(const Results& results, const Figure& figure, const std::filesystem::path& folder) {
  run_gnuplot(script_of(results, figure), folder);
  const std::filesystem::path pdf = folder / (figure.name + ".pdf");
  write_file(pdf, without_creation_date(read_file(pdf)));
}

}  // namespace promenade::analysis
