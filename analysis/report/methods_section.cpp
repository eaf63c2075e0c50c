// How it was computed: sentences for a paper, conventions, and works to cite.
#include "analysis/report/methods_draft.h"
#include "analysis/report/references.h"
#include "analysis/report/report_sections.h"

namespace promenade::analysis {
namespace {

constexpr const char* conventions[] = {
    ("Who counts. The first finished session of each participant. Practice trials, pilot and "
     "simulated sessions are left out unless asked for; people who declined, withdrew or did not "
     "finish are counted in the flow only. Trials that were skipped, aborted or cut off are "
     "missing."),
    ("Measures. D is the mean distance between the joints of the target and of the created walk "
     "over one cycle; D at the start, the smallest shown, and final, when the trial ended. Time "
     "runs from the start of a trial to its end and is restricted to the limit; a failure (time "
     "limit, or Done with D above the threshold) counts with the time at which it ended, that is, "
     "censored there. Ratings count only if the person set them."),
    ("Comparisons. Wilcoxon's signed-rank test on the differences a − b of each pair of "
     "interfaces, in the order of the study. Zeros are dropped, ties get midranks, and p comes "
     "from the exact conditional distribution given these ranks, two-sided by doubling. The normal "
     "p beside it is without continuity correction. Magnitudes that differ by less than 1e-9 "
     "of the largest value are ties. r is the matched-pairs rank-biserial correlation "
     "(W+ − W−)/(W+ + W−); its 95 % interval is the score interval under a normal shift, an "
     "approximation that also holds where r is 1."),
    ("Size. The difference is the Hodges-Lehmann estimate, the median of all Walsh averages of all "
     "differences, zeros included, with the interval that belongs to the test: its level is at "
     "least 95 %, and there is none for fewer than six. The intervals of medians are those of the "
     "sign test; of shares, that of Wilson and the exact one of Clopper and Pearson."),
    ("Many tests. Holm's adjustment is made over all pairs of interfaces for one measure at one "
     "place (task and target, or task). Measures are not adjusted for each other. McNemar's tests "
     "have the pairs of a target as "
     "their family, the log-rank tests those of a task, preferences all pairs."),
};

Html heading(const char* words) { return element("h3", words); }

Html reference_list(const std::vector<Reference>& references) {
  Html list;
  for (const Reference& one : references) {
    list += element("li", text(one.text + " ") + element("i", "For " + one.use + "."));
  }
  return element("ul", list);
}

}  // namespace

Section methods_section(const Results& results) {
  const std::vector<std::string> draft = methods_draft(results);
  const std::vector<Reference> references = references_of(results);
  Section section;
  section.title = "Method";
  section.html = heading("For a paper, to be edited");
  for (const std::string& paragraph : draft) section.html += element("p", paragraph);
  section.html += heading("Conventions of this report");
  for (const char* paragraph : conventions) section.html += element("p", paragraph);
  section.html += heading("Works to cite") + reference_list(references);
  section.json["methods"] = draft;
  if (const auto& adjectives = results.adjectives) {
    section.json["adjectives"] = {{"source", adjectives->source},
                                  {"raters", adjectives->raters},
                                  {"simulated", adjectives->simulated}};
  }
  section.json["references"] = nlohmann::json::array();
  for (const Reference& one : references) section.json["references"].push_back(one.text);
  return section;
}

}  // namespace promenade::analysis
