// The figures on the page.
#include <fmt/format.h>

#include "analysis/report/page_parts.h"

namespace promenade::analysis {

Html figure_section(const std::vector<DrawnFigure>& figures) {
  Html html;
  int number = 0;
  for (const DrawnFigure& drawn : figures) {
    const std::string source = "data:image/svg+xml;base64," + base64(drawn.svg);
    html += element(
        "figure",
        empty_element("img", {{"src", source}, {"alt", drawn.figure.caption}}) +
            element("figcaption", fmt::format("Figure {}. {}", ++number, drawn.figure.caption)));
  }
  return element("h2", "Figures") + element("div", {{"class", "figures"}}, html);
}

}  // namespace promenade::analysis
