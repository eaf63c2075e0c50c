// The clusters behind the sliders of a run, held against the printed ones ([O] Tables 3 to 5).
#include <fmt/format.h>

#include "analysis/published/published.h"
#include "motion/models/control_maps.h"
#include "motion/models/rand_index.h"
#include "study/adjective_model.h"

namespace promenade::analysis {
namespace {

constexpr std::size_t set_b = 1;  // of motion::printed_clusters: Table 3

PublishedRow row_of(const std::string& what, const std::string& place,
                    const motion::PrintedComparison& found, const std::string& items) {
  PublishedRow row;
  row.kind = "clusters";
  row.what = what;
  row.place = place;
  row.printed_words = "4 clusters";
  row.run_words = fmt::format("adjusted Rand index {:.2f}, over {} {}", found.rand_index,
                              found.items.size(), items);
  row.note = "Adjusted Rand index: 1 the same clusters, 0 as alike as by chance.";
  return row;
}

bool has_interface(const study::Study& study, std::string_view type) {
  for (const study::InterfaceUse& use : study.interfaces) {
    if (use.type == type) return true;
  }
  return false;
}

}  // namespace

void add_printed_sliders(const study::StudyBundle* bundle, Published& published) {
  if (!bundle || published.study->name != "oshita-2018") return;
  if (has_interface(bundle->study, "adjectives") && bundle->adjectives) {
    const study::AdjectiveModel& model = *bundle->adjectives;
    published.rows.push_back(
        row_of("sliders of adjectives", "[O] Table 3",
               motion::compare_with_printed(model.quantification.cluster,
                                            motion::printed_clusters(model.kept_pairs)[set_b]),
               "pairs"));
  }
  if (has_interface(bundle->study, "features") && bundle->space.set.size() > 1) {
    published.rows.push_back(
        row_of("sliders of features", "[O] Tables 4 and 5",
               motion::compare_with_printed(motion::feature_sliders(bundle->space.set).cluster,
                                            motion::printed_feature_clusters()),
               "features"));
  }
}

}  // namespace promenade::analysis
