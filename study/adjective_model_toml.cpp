// Writes the file that adjective_model_file.cpp reads.
#include <fmt/format.h>

#include "motion/problem.h"
#include "study/adjective_model_file.h"
#include "study/csv.h"
#include "study/ratings_csv.h"
#include "study/toml_text.h"

namespace promenade::study {
namespace {

std::string list(const std::vector<std::string>& names) {
  constexpr std::size_t most = 96;  // columns of a line
  std::string text = "[";
  std::size_t begin = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string one = toml_quoted(names[i]) + (i + 1 < names.size() ? "," : "");
    if (i > 0 && text.size() - begin + one.size() > most) {
      begin = text.size();
      text += "\n   ";
    }
    text += (i > 0 ? " " : "") + one;
  }
  return text + "]";
}

std::string words(const LocalText& text) {
  if (text.size() == 1 && text.begin()->first == "en") return toml_quoted(text.begin()->second);
  std::string result = "{";
  for (const auto& [language, content] : text) {
    result += (result.size() > 1 ? ", " : " ") + language + " = " + toml_quoted(content);
  }
  return result + " }";
}

// As lines of their own, if nothing in them ends such a text.
std::string block(const std::string& csv) {
  const bool plain = csv.find("'''") == std::string::npos && csv.find('\r') == std::string::npos &&
                     csv.find('\0') == std::string::npos;
  return plain ? "'''\n" + csv + "'''" : toml_quoted(csv);
}

std::string primary(const AdjectiveModel& model) {
  const std::vector<PrimaryWords> all = words_of(model);
  std::string text;
  for (std::size_t c = 0; c < all.size(); ++c) {
    text += "\n[[primary]]\nname = " + words(all[c].name) + "\n";
    if (!all[c].low.empty()) text += "low = " + words(all[c].low) + "\n";
    if (!all[c].high.empty()) text += "high = " + words(all[c].high) + "\n";
    text += "pairs = " + list(pairs_of(model, static_cast<int>(c))) + "\n";
  }
  return text;
}

}  // namespace

std::string adjective_model_toml(const AdjectiveModel& model) {
  if (!model.agreement.agrees()) throw InputError(model.source, describe(model.agreement));
  const motion::QuantificationOptions& options = model.options;
  return fmt::format(
             "# Sliders of adjectives made of ratings, for `ratings` in [study]. Names, and the\n"
             "# words at the ends of a slider (low, high), may be changed by hand; the rest by\n"
             "# `promenade model adjectives THIS.toml`.\n"
             "kind = \"adjective model\"\nversion = 1\nsource = {}\nsimulated = {}\n"
             "least_extreme = {}\nmost_deviation = {}\nclusters = {}\nflip = {}\nmotions = {}\n",
             toml_quoted(model.source), model.simulated(), csv_number(options.least_extreme),
             csv_number(options.most_deviation), options.clusters, options.flip,
             list(model.table.motions)) +
         primary(model) + "\n[ratings]\ntable = " + block(ratings_csv(model.table)) + "\n";
}

}  // namespace promenade::study
