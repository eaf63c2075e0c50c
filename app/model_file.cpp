#include "app/model_file.h"

#include "motion/problem.h"
#include "study/adjective_model_file.h"

namespace promenade::app {

std::string model_file(const study::AdjectiveModel& model) {
  std::string text = study::adjective_model_toml(model);
  try {
    study::read_adjective_model("model", text);
  } catch (const InputError& error) {
    throw InputError("names of sliders", error.problems().front().message);
  }
  return text;
}

}  // namespace promenade::app
