// [study] ratings: what people said about the motions of the set.
#include <algorithm>

#include "study/adjective_model.h"
#include "study/ratings_csv.h"
#include "study/study_parts.h"

namespace promenade::study {
namespace {

// A pair without a rating of every motion says nothing: all pairs would be lost.
void refuse_unrated(const TomlTable& section, const RatingsTable& table) {
  for (std::size_t i = 0; i < table.motions.size(); ++i) {
    const bool rated =
        std::any_of(table.ratings.begin(), table.ratings.end(),
                    [i](const motion::Rating& one) { return one.motion == static_cast<int>(i); });
    if (!rated) section.error("ratings", "there is no rating of \"" + table.motions[i] + "\"");
  }
}

}  // namespace

void read_ratings_file(const TomlTable& root, StudyFiles& files, StudyBundle& bundle) {
  const std::string& name = bundle.study.ratings_file;
  if (name.empty()) return;
  const TomlTable section = root.table("study").value_or(root);
  try {
    RatingsTable table = read_ratings_csv(files.full_path(name), files.read(name),
                                          motion::names_of(bundle.space.set));
    refuse_unrated(section, table);
    bundle.adjectives =
        std::make_shared<const AdjectiveModel>(make_adjective_model(std::move(table), name));
  } catch (const InputError& error) {
    for (const Problem& problem : error.problems()) {
      if (problem.line > 0) {
        root.reader().add({problem});
      } else {
        section.error("ratings", "cannot use the ratings \"" + name + "\": " + problem.message);
      }
    }
  }
}

}  // namespace promenade::study
