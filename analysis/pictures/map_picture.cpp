#include "analysis/pictures/map_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "analysis/pictures/map_layout.h"
#include "analysis/pictures/map_picture_parts.h"
#include "analysis/report/gnuplot.h"
#include "motion/convex_hull.h"
#include "motion/files.h"
#include "motion/problem.h"

namespace promenade::analysis {
namespace {

using Eigen::Index;
using Eigen::Matrix2Xd;
using Eigen::Vector2d;

// Apart for colour-blind readers; the shapes differ, too.
constexpr std::array colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};
constexpr std::array shapes = {7, 9, 5, 13, 11, 15};
constexpr double letter = 6.6;  // pixels, of the small font

template <typename Array>
auto of_cluster(const Array& values, int cluster) {
  return values[static_cast<std::size_t>(cluster) % values.size()];
}

// The part of the plane that is seen, with room around the dots.
struct View {
  Vector2d low, high;
};

View view_of(const motion::Minimap& map, const Frame& frame) {
  const Vector2d low = map.examples.rowwise().minCoeff().cwiseMin(0.0);
  const Vector2d high = map.examples.rowwise().maxCoeff().cwiseMax(0.0);
  const Vector2d room(frame.right - frame.left, frame.top - frame.bottom);
  // One unit is as long either way.
  const double unit = 1.2 * ((high - low).cwiseQuotient(room)).maxCoeff();
  const Vector2d middle = 0.5 * (low + high);
  return {middle - 0.5 * unit * room, middle + 0.5 * unit * room};
}

std::string terminal(const std::string& ending, const Frame& frame) {
  constexpr const char* look = " noenhanced rounded background '#ffffff'\nset output 'picture";
  if (ending == ".svg") {
    return fmt::format("set terminal svg size {},{} font 'Noto Sans,12'{}.svg'\n", frame.width,
                       frame.height, look);
  }
  if (ending == ".png") {
    return fmt::format("set terminal pngcairo size {},{} font 'Noto Sans,9'{}.png'\n", frame.width,
                       frame.height, look);
  }
  return fmt::format("set terminal pdfcairo size {:.2f}cm,{:.2f}cm font 'Noto Sans,7'{}.pdf'\n",
                     frame.width * 0.02, frame.height * 0.02, look);
}

// A folder that goes when it is no longer needed.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "promenade.XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr)
      throw OutsideError("cannot make a folder in " +
                         std::filesystem::temp_directory_path().string());
    path_ = pattern;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::string clusters_data(const MapPicture& picture, int cluster) {
  std::vector<int> members;
  for (std::size_t i = 0; i < picture.clusters.size(); ++i) {
    if (picture.clusters[i] == cluster) members.push_back(static_cast<int>(i));
  }
  const auto rows = [&](const std::vector<int>& columns) {
    std::string text;
    for (const int c : columns) {
      text += fmt::format("{} {}\n", picture.map.examples(0, c), picture.map.examples(1, c));
    }
    return text;
  };
  std::vector<int> hull = motion::convex_hull(picture.map.examples, members);
  if (!hull.empty()) hull.push_back(hull.front());
  return fmt::format("$dots{0} << EOD\n{1}EOD\n$hull{0} << EOD\n{2}EOD\n", cluster, rows(members),
                     rows(hull));
}

std::string labels(const MapPicture& picture, const Frame& frame, const View& view) {
  const Vector2d pixel = Vector2d(frame.right - frame.left, frame.top - frame.bottom)
                             .cwiseQuotient(view.high - view.low);
  const Matrix2Xd dots = pixel.asDiagonal() * picture.map.examples;
  std::vector<double> widths;
  for (const std::string& name : picture.names) {
    widths.push_back(letter * static_cast<double>(name.size()));
  }
  const auto spots = place_labels(dots, widths, 12, 5,
                                  {pixel.cwiseProduct(view.low), pixel.cwiseProduct(view.high)});
  std::string text;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    const Vector2d at = spots[i].at.cwiseQuotient(pixel);
    text += fmt::format("set label {} {} at {},{} center front font ',10' tc rgb '#222222'\n",
                        i + 1, gnuplot_text(picture.names[i]), at.x(), at.y());
  }
  return text;
}

std::string share(const motion::Minimap& map, Index component) {
  return component < map.explained.size()
             ? fmt::format("{:.0f} % of the variance", 100 * map.explained(component))
             : "no variance";
}

}  // namespace

std::string place(const Frame& frame) {
  return fmt::format(
      "set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen {}\n"
      "set tmargin at screen {}\n",
      frame.left / frame.width, frame.right / frame.width, frame.bottom / frame.height,
      frame.top / frame.height);
}

std::string map_script(const MapPicture& picture, const Frame& frame, bool names) {
  const View view = view_of(picture.map, frame);
  std::string text = place(frame);
  text += "set encoding utf8\nset border 3 lc rgb '#888888'\nset key off\nunset label\n";
  text += "set tics nomirror scale 0.4 tc rgb '#444444' font ',10'\n";
  text += "set xzeroaxis lc rgb '#dddddd'\nset yzeroaxis lc rgb '#dddddd'\n";
  text += fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", view.low.x(), view.high.x(),
                      view.low.y(), view.high.y());
  text += "set xlabel " + gnuplot_text("first component, " + share(picture.map, 0)) +
          "\nset ylabel " + gnuplot_text("second component, " + share(picture.map, 1)) + "\n";
  if (names) text += labels(picture, frame, view);
  const int clusters = 1 + *std::max_element(picture.clusters.begin(), picture.clusters.end());
  std::string plot = "plot ";
  for (int c = 0; c < clusters; ++c) {
    text += clusters_data(picture, c);
    plot += fmt::format(
        "$hull{0} using 1:2 with filledcurves closed fs transparent solid 0.10 noborder lc rgb "
        "'{1}', $hull{0} using 1:2 with lines lw 0.8 lc rgb '{1}', "
        "$dots{0} using 1:2 with points pt {2} ps {3} lc rgb '{1}', ",
        c, of_cluster(colours, c), of_cluster(shapes, c), names ? 0.9 : 0.7);
  }
  text += "$average << EOD\n0 0\nEOD\n";
  return text + plot + "$average using 1:2 with points pt 1 ps 1.2 lw 1.5 lc rgb '#000000'";
}

void draw_script(const std::string& script, const Frame& frame, const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending != ".svg" && ending != ".png" && ending != ".pdf")
    throw InputError(file.string(), "a picture ends in .svg, .png or .pdf");
  const TemporaryFolder folder;
  run_gnuplot(terminal(ending, frame) + script + "\nset output\n", folder.path());
  std::string bytes = read_file(folder.path() / ("picture" + ending));
  if (ending == ".pdf") bytes = without_creation_date(std::move(bytes));
  write_file(file, bytes);
}

void draw_map(const MapPicture& picture, const std::filesystem::path& file) {
  const Frame frame{900, 760, 70, 885, 60, 720};
  const std::string title = "set title " + gnuplot_text(picture.title) + " tc rgb '#222222'\n";
  draw_script(title + map_script(picture, frame, true), frame, file);
}

}  // namespace promenade::analysis
