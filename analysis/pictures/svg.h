// A picture in SVG while it grows: x to the right and y down, in pixels.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace promenade::analysis {

class Svg {
 public:
  Svg(int width, int height);  // white

  void rect(double x, double y, double width, double height, std::string_view fill);
  void line(double x1, double y1, double x2, double y2, std::string_view colour, double thick = 1);
  // `anchor`: start, middle or end of the words is at x.
  void words(double x, double y, std::string_view plain, std::string_view anchor = "start",
             std::string_view colour = "#30343a", int size = 13);
  void curve(const std::vector<Eigen::Vector2d>& points, std::string_view colour,
             double thick = 1.6, std::string_view dashes = {});  // dashes: "6 4", or none
  void dot(double x, double y, double radius, std::string_view fill);
  // A path in SVG's own words, filled.
  void area(std::string_view path, std::string_view fill);
  // What is drawn until it is closed has its origin there, and is so much larger.
  void open_frame(double x, double y, double scale);
  void close_frame();
  // From one place to another over a third that pulls it, as faint as `opacity` says.
  void bow(const Eigen::Vector2d& from, const Eigen::Vector2d& pull, const Eigen::Vector2d& to,
           std::string_view colour, double opacity);

  std::string finish() const { return text_ + "</svg>\n"; }

 private:
  std::string text_;
};

}  // namespace promenade::analysis
