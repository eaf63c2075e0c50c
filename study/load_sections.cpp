// [study], [display] and the texts of a study's own.
#include <algorithm>
#include <cmath>

#include "motion/did_you_mean.h"
#include "study/published.h"
#include "study/study_parts.h"
#include "study/utf8.h"

namespace promenade::study {
namespace {

constexpr std::int64_t largest_seed = INT64_MAX;
constexpr int longest_name = 80;

// Of ASCII, or U+0080 to U+009F, in UTF-8 C2 80 to C2 9F.
bool has_control(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte < 0x20 || byte == 0x7F) return true;
    if (byte == 0xC2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xA0) {
      return true;
    }
  }
  return false;
}

void warn_of_missing(const TomlTable& table, std::string_view key, const std::string& what,
                     const LocalText& text, const std::vector<std::string>& languages) {
  if (text.empty()) return;
  for (const std::string& language : languages) {
    if (text.count(language) > 0) continue;
    table.warning(key, what + " has no text in \"" + language + "\"; \"" + text_in(text, language) +
                           "\" is shown");
  }
}

LocalText texts_by_language(const TomlTable& table) {
  LocalText text;
  for (const std::string& language : known_languages()) {
    if (const auto words = table.text(language)) text[language] = *words;
  }
  return text;
}

std::vector<std::string> read_language_list(const TomlTable& table) {
  const std::vector<std::string> known = known_languages();
  std::vector<std::string> languages;
  for (const TomlText& entry : table.texts("languages")) {
    if (std::find(known.begin(), known.end(), entry.text) == known.end()) {
      table.reader().add(entry.place, "there are no texts in language \"" + entry.text +
                                          "\", only in " + quoted_list(known));
    } else if (std::find(languages.begin(), languages.end(), entry.text) != languages.end()) {
      table.reader().add(entry.place, "language \"" + entry.text + "\" is named twice");
    } else {
      languages.push_back(entry.text);
    }
  }
  if (table.is("languages", TomlValue::Kind::array) && languages.empty() && table.reader().ok()) {
    table.error("languages", "\"languages\" must name at least one language");
  }
  return languages;
}

Order order_of(const std::string& word) {
  if (word == "latin") return Order::latin;
  if (word == "random") return Order::random;
  if (word == "fixed") return Order::fixed;
  return Order::williams;
}

}  // namespace

void refuse_unsafe_name(const TomlTable& table, std::string_view key, const std::string& name) {
  const auto length = count_characters(name);
  if (name.find('/') == std::string::npos && name.rfind('.', 0) != 0 && !has_control(name) &&
      length <= longest_name) {
    return;
  }
  table.error(key, "\"" + std::string(key) +
                       "\" must have up to 80 characters, none of them \"/\" or a control "
                       "character, and not begin with a dot");
}

std::string read_name(const TomlTable& table) {
  std::string name = table.required_text("name");
  refuse_unsafe_name(table, "name", name);
  return name;
}

LocalText read_local_text(const TomlTable& table, std::string_view key, const Study& study) {
  return read_local_text(table, key, study.languages);
}

LocalText read_local_text(const TomlTable& table, std::string_view key,
                          const std::vector<std::string>& languages) {
  LocalText text;
  if (table.is(key, TomlValue::Kind::table)) {
    text = texts_by_language(*table.table(key));
  } else if (const auto words = table.text(key)) {
    text["en"] = *words;
  }
  warn_of_missing(table, key, "\"" + std::string(key) + "\"", text, languages);
  return text;
}

LocalText read_languages(const TomlTable& table, const std::string& name, const Study& study) {
  return read_languages(table, name, study.languages);
}

LocalText read_languages(const TomlTable& table, const std::string& name,
                         const std::vector<std::string>& languages) {
  LocalText text = texts_by_language(table);
  if (text.empty()) text["en"] = name;
  warn_of_missing(table, "", "\"" + name + "\"", text, languages);
  return text;
}

void read_study_section(const TomlTable& root, Study& study) {
  root.require("study");
  const TomlTable table = root.table("study").value_or(root.reader().empty());
  if (root.has("study")) study.name = read_name(table);
  study.version = table.text("version").value_or(study.version);
  study.set = table.text("set").value_or(study.set);
  study.ratings_file = table.text("ratings").value_or("");
  if (table.has("languages")) study.languages = read_language_list(table);
  study.seed = static_cast<std::uint64_t>(
      table.integer("seed", 0, largest_seed).value_or(static_cast<std::int64_t>(study.seed)));
  study.published = table.choice("published", published_studies()).value_or("");
  const auto order = table.choice("order", {"williams", "latin", "random", "fixed"});
  study.order = order_of(order.value_or("williams"));
  read_design(table, study);
  study.title = read_local_text(table, "title", study);
  study.consent = read_local_text(table, "consent", study);
}

void read_display(const TomlTable& root, Study& study) {
  const auto table = root.table("display");
  if (!table) return;
  Display& display = study.display;
  display.paper_colours = table->choice("colours", {"standard", "paper"}) == "paper";
  display.travels = table->choice("walk", {"ground", "spot"}) != "spot";
  display.screen = static_cast<int>(table->integer("screen", 1, 16).value_or(0));
  display.scale = table->number("scale", 0.5, 1).value_or(1);
  const auto examples = table->choice("examples", {"none", "panel", "screen"});
  if (examples == "panel") display.examples = ExamplesWall::panel;
  if (examples == "screen") display.examples = ExamplesWall::screen;
}

void refuse_doubles(const std::vector<TomlTable>& tables, const std::vector<std::string>& names,
                    const std::string& what) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool before = std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i),
                                  names[i]) != names.begin() + static_cast<std::ptrdiff_t>(i);
    if (before && !names[i].empty()) {
      tables[i].error("there is another " + what + " with the name \"" + names[i] + "\" before");
    }
  }
}

}  // namespace promenade::study
