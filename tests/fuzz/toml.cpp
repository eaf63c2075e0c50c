// Any bytes as a TOML file that is asked for everything, of every kind.
#include <cstdint>
#include <string_view>

#include "study/recipe.h"
#include "study/toml_reader.h"

namespace {

using namespace promenade;

void ask(const study::TomlTable& table) {
  for (const std::string& key : table.keys()) {
    if (table.scalar(key)) table.warning(key, "is here");
    table.number(key, -1, 1);
    table.integer(key, -1, 1);
    table.choice(key, {"a", "b"});
    table.required_text(key);
    table.texts(key);
    table.numbers(key);
    if (const auto inner = table.table(key)) ask(*inner);
    for (const study::TomlTable& element : table.tables(key)) ask(element);
  }
}

void read(std::string_view text) {
  study::TomlReader reader("fuzz.toml", text);
  ask(reader.root());
  reader.finish();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::size_t half = size / 2;
  study::style_of(std::string(text.substr(0, half)), std::string(text.substr(half)));
  try {
    read(text);
  } catch (const InputError&) {
    // Refused with a place and a reason: that is what should happen.
  }
  return 0;
}
