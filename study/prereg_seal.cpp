#include "study/prereg_seal.h"

#include "study/identity.h"
#include "study/sqlite.h"
#include "study/toml_parse.h"

namespace promenade::study {
namespace {

const TomlValue* find(const TomlValue& table, std::string_view key) {
  for (const TomlValue::Entry& entry : table.entries) {
    if (entry.key == key) return &entry.value;
  }
  return nullptr;
}

struct Named {
  std::string file;
  int line = 0;  // from 1; 0: it is not named
};

Named named_in(std::string_view config_text) {
  try {
    const TomlValue root = parse_toml("", config_text);
    const TomlValue* section = find(root, "study");
    const TomlValue* name = section ? find(*section, "prereg") : nullptr;
    if (name && name->kind == TomlValue::Kind::text) return {name->text, name->place.line};
  } catch (const InputError&) {  // who reads the study says what is wrong
  }
  return {};
}

}  // namespace

std::string prereg_file_in(std::string_view config_text) { return named_in(config_text).file; }

std::string without_seal(std::string_view config_text) {
  const int line = named_in(config_text).line;
  if (line == 0) return std::string(config_text);
  std::size_t begin = 0;
  for (int i = 1; i < line; ++i) begin = config_text.find('\n', begin) + 1;
  const std::size_t end = config_text.find('\n', begin);
  std::string text(config_text.substr(0, begin));
  if (end != std::string_view::npos) text += config_text.substr(end + 1);
  return text;
}

std::optional<Seal> seal_in(Database& database, const std::string& study_uuid,
                            std::string_view config_text) {
  const std::string file = prereg_file_in(config_text);
  if (file.empty()) return std::nullopt;
  Statement row(database, "SELECT content FROM study_part WHERE study = ? AND path = ?");
  if (!row.bind(1, study_uuid).bind(2, file).step()) return std::nullopt;
  return Seal{file, sha256_hex(row.blob(0))};
}

}  // namespace promenade::study
