#include "study/published.h"

namespace promenade::study {

const std::vector<std::string>& published_studies() {
  static const std::vector<std::string> names = {
      "normoyle-timed", "normoyle-untimed",       "oshita-2016",
      "oshita-2018",    "oshita-questionnaire-a", "oshita-questionnaire-b"};
  return names;
}

}  // namespace promenade::study
