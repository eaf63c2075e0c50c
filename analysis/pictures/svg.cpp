#include "analysis/pictures/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "analysis/report/html.h"

namespace promenade::analysis {

Svg::Svg(int width, int height)
    : text_(fmt::format(
          "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
          "height=\"{1}\" font-family=\"Noto Sans, sans-serif\" font-size=\"13\">\n"
          "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
          width, height)) {}

void Svg::rect(double x, double y, double width, double height, std::string_view fill) {
  text_ += fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"/>\n", x, y,
      std::max(width, 0.0), height, fill);
}

void Svg::line(double x1, double y1, double x2, double y2, std::string_view colour, double thick) {
  text_ += fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
      "stroke-width=\"{:.1f}\" stroke-linecap=\"round\"/>\n",
      x1, y1, x2, y2, colour, thick);
}

void Svg::words(double x, double y, std::string_view plain, std::string_view anchor,
                std::string_view colour, int size) {
  text_ += fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" fill=\"{}\" font-size=\"{}\">{}</text>\n",
      x, y, anchor, colour, size, text(plain).code);
}

void Svg::curve(const std::vector<Eigen::Vector2d>& points, std::string_view colour, double thick,
                std::string_view dashes) {
  std::string list;
  for (const Eigen::Vector2d& p : points) {
    fmt::format_to(std::back_inserter(list), "{:.1f},{:.1f} ", p.x(), p.y());
  }
  const std::string dashed =
      dashes.empty() ? std::string() : fmt::format(" stroke-dasharray=\"{}\"", dashes);
  text_ += fmt::format(
      "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.1f}\"{}/>\n", list,
      colour, thick, dashed);
}

void Svg::dot(double x, double y, double radius, std::string_view fill) {
  text_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\"/>\n", x, y,
                       radius, fill);
}

void Svg::area(std::string_view path, std::string_view fill) {
  text_ += fmt::format("<path d=\"{}\" fill=\"{}\"/>\n", path, fill);
}

void Svg::open_frame(double x, double y, double scale) {
  text_ += fmt::format(
      "<g transform=\"translate({:.2f} {:.2f}) scale({:.5f})\" shape-rendering=\"crispEdges\">\n",
      x, y, scale);
}

void Svg::close_frame() { text_ += "</g>\n"; }

void Svg::bow(const Eigen::Vector2d& from, const Eigen::Vector2d& pull, const Eigen::Vector2d& to,
              std::string_view colour, double opacity) {
  text_ += fmt::format(
      "<path d=\"M{:.1f} {:.1f}Q{:.1f} {:.1f} {:.1f} {:.1f}\" fill=\"none\" stroke=\"{}\" "
      "stroke-opacity=\"{:.2f}\"/>\n",
      from.x(), from.y(), pull.x(), pull.y(), to.x(), to.y(), colour, opacity);
}

}  // namespace promenade::analysis
