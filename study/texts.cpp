#include "study/texts.h"

#include <algorithm>

#include "motion/did_you_mean.h"
#include "study/embedded.h"
#include "study/toml_parse.h"

namespace promenade::study {
namespace {

using TextMap = std::map<std::string, std::string, std::less<>>;

void flatten(const TomlValue& table, const std::string& prefix, TextMap& texts) {
  for (const TomlValue::Entry& entry : table.entries) {
    if (entry.value.kind == TomlValue::Kind::text) texts[prefix + entry.key] = entry.value.text;
    flatten(entry.value, prefix + entry.key + ".", texts);
  }
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

TextMap program_texts(std::string_view language) {
  const std::string path = "languages/" + std::string(language) + ".toml";
  const auto content = embedded_file(path);
  if (!content) {
    const std::vector<std::string> known = known_languages();
    throw InputError("language \"" + std::string(language) + "\"",
                     "there are texts in " + quoted_list(known) + did_you_mean(language, known));
  }
  TextMap texts;
  flatten(parse_toml("configs/" + path, *content), "", texts);
  return texts;
}

}  // namespace

const std::string& text_in(const LocalText& text, std::string_view language) {
  static const std::string nothing;
  const auto own = text.find(language);
  if (own != text.end()) return own->second;
  const auto english = text.find("en");
  if (english != text.end()) return english->second;
  return text.empty() ? nothing : text.begin()->second;
}

Texts::Texts(TextMap texts) : texts_(std::move(texts)) {}

const std::string& Texts::operator()(std::string_view key) const {
  const auto found = texts_.find(key);
  if (found != texts_.end()) return found->second;
  return texts_.emplace(key, key).first->second;
}

const std::string* Texts::find(std::string_view key) const {
  const auto found = texts_.find(key);
  return found != texts_.end() && found->second != key ? &found->second : nullptr;
}

std::string Texts::with(std::string_view key,
                        const std::vector<std::pair<std::string, std::string>>& values) const {
  std::string text = (*this)(key);
  for (const auto& [name, value] : values) replace_all(text, "{" + name + "}", value);
  return text;
}

std::string Texts::style(std::string_view name) const {
  const auto found = texts_.find("style." + std::string(name));
  if (found != texts_.end()) return found->second;
  std::string plain(name);
  std::replace(plain.begin(), plain.end(), '_', ' ');
  return plain;
}

std::vector<std::string> Texts::keys() const {
  std::vector<std::string> keys;
  for (const auto& [key, text] : texts_) keys.push_back(key);
  return keys;
}

std::vector<std::string> known_languages() { return embedded_names("languages"); }

Texts load_texts(std::string_view language) { return Texts(program_texts(language)); }

Texts load_texts(std::string_view language, const std::string& file, std::string_view own) {
  TextMap texts = program_texts(language);
  flatten(parse_toml(file, own), "", texts);
  return Texts(std::move(texts));
}

Texts parse_texts(const std::vector<std::pair<std::string, std::string_view>>& files) {
  TextMap texts;
  for (const auto& [file, content] : files) flatten(parse_toml(file, content), "", texts);
  return Texts(std::move(texts));
}

Texts texts_in(const StudyTexts& texts, std::string_view language) {
  const auto found = texts.find(language);
  return found != texts.end() ? found->second : load_texts(language);
}

}  // namespace promenade::study
