// [study] ratings: what people said about the motions of the set.
#include <algorithm>

#include "study/adjective_model_file.h"
#include "study/ratings_csv.h"
#include "study/study_parts.h"

namespace promenade::study {
namespace {

// A pair without a rating of every motion says nothing: all pairs would be lost.
bool refuse_unrated(const TomlTable& section, const RatingsTable& table) {
  bool all = true;
  for (std::size_t i = 0; i < table.motions.size(); ++i) {
    const bool rated =
        std::any_of(table.ratings.begin(), table.ratings.end(),
                    [i](const motion::Rating& one) { return one.motion == static_cast<int>(i); });
    if (!rated) section.error("ratings", "there is no rating of \"" + table.motions[i] + "\"");
    all = all && rated;
  }
  return !all;
}

void judge(const TomlTable& section, const RaterAgreement& agreement, bool frozen) {
  if (agreement.agrees()) return;
  if (frozen) return section.warning("ratings", describe(agreement));
  section.error("ratings", describe(agreement));
}

AdjectiveModel read_model(StudyFiles& files, const std::string& name,
                          const std::vector<std::string>& motions) {
  const std::string file = files.full_path(name);
  const std::string& text = files.read(name);
  if (is_adjective_model(name)) return read_adjective_model(file, text, motions);
  return make_adjective_model(read_ratings_csv(file, text, motions), name);
}

// Names of sliders that neither the model nor the program has in a language of the study.
void warn_of_languages(const TomlTable& section, const AdjectiveModel& model,
                       const StudyBundle& bundle) {
  for (const std::string& language : bundle.study.languages) {
    const Texts texts = texts_in(bundle.texts, language);
    for (const PrimaryWords& words : model.words) {
      const std::string& name = text_in(words.name, "en");
      if (words.name.count(language) > 0 || texts.find("cluster." + name) != nullptr) continue;
      section.warning("ratings", "the slider \"" + name + "\" has no name in \"" + language +
                                     "\"; \"" + name + "\" is shown");
    }
  }
}

}  // namespace

void read_ratings_file(const TomlTable& root, StudyFiles& files, StudyBundle& bundle) {
  const std::string& name = bundle.study.ratings_file;
  if (name.empty()) return;
  const TomlTable section = root.table("study").value_or(root);
  try {
    AdjectiveModel model = read_model(files, name, motion::names_of(bundle.space.set));
    const bool refused = refuse_unrated(section, model.table);
    warn_of_languages(section, model, bundle);
    if (!refused) judge(section, model.agreement, files.frozen());
    bundle.adjectives = std::make_shared<const AdjectiveModel>(std::move(model));
  } catch (const InputError& error) {
    add_file_problems(section, "ratings", "the ratings \"" + name + "\"", error);
  }
}

}  // namespace promenade::study
