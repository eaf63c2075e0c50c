#include "app/interfaces_page.h"

#include <fmt/format.h>

#include <cmath>

namespace promenade::app {
namespace {

using study::InterfaceType;
using study::ParameterSpec;

std::string value_text(const study::ParameterValue& value) {
  const bool quoted = std::holds_alternative<std::string>(value);
  return quoted ? "\"" + study::to_text(value) + "\"" : study::to_text(value);
}

std::string allowed_text(const ParameterSpec& spec) {
  if (std::holds_alternative<bool>(spec.standard)) return "true or false";
  if (std::holds_alternative<double>(spec.standard)) {
    std::string text = spec.whole ? "a whole number" : "a number";
    if (std::isfinite(spec.least)) text += fmt::format(" from {}", spec.least);
    return std::isfinite(spec.most) ? text + fmt::format(" to {}", spec.most) : text;
  }
  if (spec.choices.empty()) return "a text";
  std::string text;
  for (const std::string& choice : spec.choices) text += (text.empty() ? "" : ", ") + choice;
  return text;
}

std::string parameters_table(const InterfaceType& type) {
  if (type.parameters.empty()) return "It has no settings.\n";
  std::string text = "| setting | allowed | standard | meaning |\n| --- | --- | --- | --- |\n";
  for (const ParameterSpec& spec : type.parameters) {
    text += fmt::format("| `{}` | {} | `{}` | {} |\n", spec.name, allowed_text(spec),
                        value_text(spec.standard), spec.sentence);
  }
  return text;
}

}  // namespace

std::string interfaces_page(const study::InterfaceRegistry& registry, const study::Texts& texts) {
  std::string page =
      "# Interfaces\n\n"
      "What a study can compare. Each is one file, `app/interfaces/NAME.cpp`; this page is made\n"
      "from their declarations by `tools/docs`. A study names one in an `[[interface]]` and may\n"
      "change its settings there; it may list one several times, with different settings and\n"
      "names.\n\n"
      "Common to all: undo (Ctrl-Z) and redo (Ctrl-Y), \"Start over\", every control by keyboard\n"
      "(Tab, arrow keys, Enter), and a log of all that was done.\n";
  for (const InterfaceType& type : registry.all()) {
    const std::string key = "interface." + type.name;
    page += fmt::format("\n## {}\n\n{}\n\nParticipants read: \"{}\" - {}\n\n{}", type.name,
                        type.sentence, texts(key + ".title"), texts(key + ".hint"),
                        parameters_table(type));
  }
  return page;
}

}  // namespace promenade::app
