// Any bytes as an adjective model. One that is read has as many names as sliders, and is read
// again as it is written.
#include <cstdint>
#include <cstdlib>

#include "motion/problem.h"
#include "study/adjective_model_file.h"

namespace {

using namespace promenade;

void check(const study::AdjectiveModel& model) {
  const auto sliders = static_cast<std::size_t>(model.quantification.primary.rows());
  if (model.names.size() != sliders || model.words.size() != sliders) std::abort();
  if (!model.agreement.agrees()) return;
  const std::string text = study::adjective_model_toml(model);
  const study::AdjectiveModel again = study::read_adjective_model("again.toml", text);
  if (study::adjective_model_toml(again) != text) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    check(study::read_adjective_model("fuzz.toml", text));
  } catch (const InputError&) {
    // Refused with a place and a reason: that is what should happen.
  }
  return 0;
}
