// A. Normoyle: Experimental analysis of motion style, PhD dissertation, University of
// Pennsylvania, 2015, chapter 6.
#include "analysis/published/printed.h"

namespace promenade::analysis {
namespace {

constexpr std::string_view map = "map", labels = "labels";

PrintedStudy study(std::string_view name, std::string_view title) {
  PrintedStudy study;
  study.name = name;
  study.title = title;
  study.counts = {{Quantity::participants, 17, "[N] 6, who said what they prefer"},
                  {Quantity::walks, 55, "[N] 5"},
                  {Quantity::interfaces, 2, "[N] 6"}};
  // The test and the interval of 14 of 17 are derived; the dissertation prints the share.
  study.preference = {map, 14, 17, 0.0127, 0.566, 0.962, "[N] 6"};
  study.notes = {
      "That nothing differs significantly is what the source prints for “equal”; it is no proof "
      "that nothing differs."};
  return study;
}

// Creativity has no printed definition: ours is how far a result is from every example.
PrintedStudy untimed() {
  PrintedStudy one = study("normoyle-untimed", "Normoyle, the Untimed experiment");
  one.claims = {{"satisfaction with the result is equal", "[N] 6", Claim::equal, map, labels,
                 "result", "satisfaction"},
                {"satisfaction with the controls is equal", "[N] 6", Claim::equal, map, labels,
                 "controls", "satisfaction"},
                {"fewer clicks with the map", "[N] 6", Claim::a_less, map, labels, "clicks", ""},
                {"more creative results with the map", "[N] 6", Claim::a_more, map, labels,
                 "novelty_m", ""}};
  return one;
}

PrintedStudy timed() {
  PrintedStudy one = study("normoyle-timed", "Normoyle, the Timed experiment");
  one.counts.push_back({Quantity::limit_s, 45, "[N] 6"});
  one.claims = {
      {"equal at finding", "[N] 6", Claim::equal, map, labels, "asked_quality", "", ClaimedTask::find},
      {"labels come closer when matching", "[N] 6", Claim::a_more, map, labels, "d_final", "",
       ClaimedTask::match}};
  return one;
}

}  // namespace

std::vector<PrintedStudy> printed_by_normoyle() { return {untimed(), timed()}; }

}  // namespace promenade::analysis
