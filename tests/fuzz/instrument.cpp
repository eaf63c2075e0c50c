// Any bytes as an instrument. One that is read keeps its promises: names are unique, scales
// end on a step, scores need items that are there and stay in their range.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <set>

#include "motion/problem.h"
#include "study/load_instrument.h"

namespace {

using namespace promenade;

study::ItemAnswer highest(const study::Item& item) {
  study::ItemAnswer answer;
  if (item.kind == study::ItemKind::choice) {
    answer.value = static_cast<double>(item.choices.size());
    if (!item.choices.empty()) answer.text = item.choices.back().name;
  } else if (item.kind == study::ItemKind::scale || item.kind == study::ItemKind::number) {
    answer.value = item.most;
  } else if (item.kind == study::ItemKind::agree) {
    answer.value = 1;
  } else if (item.kind == study::ItemKind::text) {
    answer.text = "a";
  } else {
    for (const study::Choice& choice : item.choices) {
      answer.text += (answer.text.empty() ? "" : "\n") + choice.name;
    }
  }
  return answer;
}

void check_scores(const study::Instrument& instrument,
                  const std::vector<study::ItemAnswer>& answers) {
  for (const study::Score& score : instrument.scores) {
    const auto value = study::score_of(instrument, score, answers);
    if (!value) continue;
    const study::ValueRange range = study::score_range(instrument, score);
    const double room = 1e-9 * (1 + std::abs(range.least) + std::abs(range.most));
    if (!(*value >= range.least - room && *value <= range.most + room)) std::abort();
  }
}

void check(const study::Instrument& instrument) {
  std::set<std::string> names;
  std::vector<study::ItemAnswer> answers;
  for (const study::Item& item : instrument.items) {
    if (!names.insert(item.name).second || item.name.empty()) std::abort();
    answers.push_back(highest(item));
    if (!item.interfaces && !study::allows(item, answers.back())) std::abort();
  }
  check_scores(instrument, answers);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    check(study::read_instrument("fuzz.toml", text).instrument);
  } catch (const InputError&) {
    // Refused with a place and a reason: that is what should happen.
  }
  return 0;
}
