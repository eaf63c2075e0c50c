#include "study/load_instrument.h"

#include <filesystem>
#include <utility>

#include "motion/did_you_mean.h"
#include "motion/files.h"
#include "study/embedded.h"
#include "study/instrument_parts.h"

namespace promenade::study {
namespace {

constexpr std::string_view ending = ".toml";

bool is_file_name(const std::string& name) {
  return name.size() > ending.size() &&
         name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

InstrumentFile read_own(const std::string& name, const std::string& folder,
                        const std::vector<std::string>& languages) {
  const std::string file = (std::filesystem::path(folder) / name).lexically_normal().string();
  return read_instrument(file, read_file(file), languages);
}

}  // namespace

InstrumentFile read_instrument(const std::string& file, std::string_view text,
                               const std::vector<std::string>& languages) {
  TomlReader reader(file, text);
  if (!reader.parsed()) reader.finish();
  const TomlTable root = reader.root();
  InstrumentFile read;
  Instrument& instrument = read.instrument;
  instrument.name = read_name(root);
  instrument.version = root.text("version").value_or(instrument.version);
  root.require("title");
  instrument.title = read_words(root, "title", languages);
  instrument.text = read_words(root, "text", languages);
  instrument.citation = root.text("citation").value_or("");
  instrument.terms = root.text("terms").value_or("");
  instrument.translations = root.text("translations").value_or("");
  instrument.shuffled = root.boolean("shuffled").value_or(false);
  instrument.items = read_items(root, languages);
  instrument.scores = read_scores(root, instrument);
  read.warnings = reader.finish();
  read.text = text;
  return read;
}

InstrumentFile load_instrument(const std::string& name, const std::string& folder,
                               const std::vector<std::string>& languages) {
  if (is_file_name(name)) return read_own(name, folder, languages);
  const auto text = embedded_instrument(name);
  if (text) return read_instrument("configs/instruments/" + name + ".toml", *text, languages);
  const std::vector<std::string> known = known_instruments();
  throw InputError("instrument \"" + name + "\"",
                   "there are " + quoted_list(known) + ", or a file of your own, which ends in " +
                       std::string(ending) + did_you_mean(name, known));
}

std::vector<std::string> known_instruments() { return embedded_names("instruments"); }

std::optional<std::string_view> embedded_instrument(std::string_view name) {
  return embedded_file("instruments/" + std::string(name) + std::string(ending));
}

}  // namespace promenade::study
