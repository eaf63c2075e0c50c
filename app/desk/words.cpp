#include "app/desk/words.h"

#include "motion/problem.h"
#include "study/embedded.h"

namespace promenade::app {

std::vector<std::string> desk_languages() { return {"en", "ja"}; }

study::Texts desk_texts(std::string_view language) {
  const std::string ending = "." + std::string(language) + ".toml";
  std::vector<std::pair<std::string, std::string_view>> files;
  for (const study::EmbeddedFile& file : study::embedded_files()) {
    if (file.path.starts_with("desk/") && file.path.ends_with(ending)) {
      files.emplace_back("configs/" + std::string(file.path), file.content);
    }
  }
  if (files.empty())
    throw InputError("language \"" + std::string(language) + "\"", "the desk has no texts");
  return study::parse_texts(files);
}

std::vector<std::string> all_desk_words() {
  std::vector<std::string> words;
  for (const std::string& language : desk_languages()) {
    const study::Texts texts = desk_texts(language);
    for (const std::string& key : texts.keys()) words.push_back(texts(key));
  }
  return words;
}

}  // namespace promenade::app
