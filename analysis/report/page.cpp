#include "analysis/report/page.h"

#include "analysis/report/page_parts.h"

namespace promenade::analysis {

namespace {

Html shown(const std::vector<Section>& sections) {
  Html html;
  for (const Section& section : sections) {
    if (section.title.empty()) continue;
    html += element("h2", {{"id", anchor_of(section.title)}}, text(section.title)) + section.html;
  }
  return html;
}

Html entry(const std::string& anchor, const std::string& title) {
  return element("li", element("a", {{"href", "#" + anchor}}, text(title))) + trusted("\n");
}

Html contents(const std::vector<Section>& sections) {
  Html list = entry("figures", "Figures");
  for (const Section& section : sections) {
    if (!section.title.empty()) list += entry(anchor_of(section.title), section.title);
  }
  list += entry("data", "Data") + entry("provenance", "Provenance");
  return element("nav", {{"class", "contents"}, {"aria-label", "Contents"}}, element("ol", list));
}

}  // namespace

std::string report_page(const Results& results, const std::vector<Section>& sections,
                        const std::vector<DrawnFigure>& figures) {
  Html head = trusted("<meta charset=\"utf-8\"/>\n") +
              empty_element("meta", {{"name", "viewport"},
                                     {"content", "width=device-width, initial-scale=1"}}) +
              element("title", results.log.study + " — Promenade report") +
              element("style", trusted(page_css()));
  Html body = stripe(results);
  body += element("main", headline(results) + flow_bar(results) + panels(results) +
                              sensitivity_links(results) + buttons() + contents(sections) +
                              figure_section(results, figures) + shown(sections) +
                              file_section(results, sections) + provenance_section(results));
  return "<!DOCTYPE html>\n" +
         element("html", {{"lang", "en"}}, element("head", head) + element("body", body)).code +
         "\n";
}

}  // namespace promenade::analysis
