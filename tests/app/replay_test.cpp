// The log alone leads to the same weights again, with every interface.
#include <gtest/gtest.h>

#include "app/registry.h"
#include "study/event_input.h"
#include "study/load_study.h"
#include "tests/app/odd_inputs.h"

namespace promenade::app {
namespace {

using study::Record;
using study::Sample;

study::StudyBundle bundle_with(const std::string& interface) {
  // Everything that can be allowed is.
  const bool sliders = interface == "adjectives" || interface == "features";
  const std::string more = sliders              ? "\nweights = 'draggable'"
                           : interface == "map" ? "\nswitch = true"
                                                : "";
  const std::string text = "[study]\nname = 'replay'\n[[interface]]\nname = '" + interface + "'" +
                           more +
                           "\n[[task]]\nname = 'copy'\nkind = 'match'\n"
                           "targets = [{example = 'proud'}]\n";
  return study::read_study("replay.toml", text, interfaces(), study::load_motion_set);
}

class Recorder {
 public:
  explicit Recorder(const study::StudyBundle& bundle)
      : session_(bundle, interfaces(), study::make_plan(bundle.study, 0), true) {}
  void step(const study::Input& input) {
    for (Record& record : session_.step(input)) records_.push_back(std::move(record));
  }
  void step(std::int64_t t_us, decltype(study::Input::action) action) {
    study::Input input;
    input.t_us = t_us;
    input.action = std::move(action);
    step(input);
  }
  const study::Session& session() const { return session_; }
  const std::vector<Record>& records() const { return records_; }

 private:
  study::Session session_;
  std::vector<Record> records_;
};

// What someone might do next in a trial.
decltype(study::Input::action) anything(const study::InterfaceType& type,
                                        const study::Session& session, study::Rng& rng) {
  if (session.paused()) return study::Resume{};
  switch (rng.below(14)) {
    case 0:
      return study::Undo{};
    case 1:
      return study::Redo{};
    case 2:
      return study::Press{};
    case 3:
      return rng.below(8) == 0 ? decltype(study::Input::action)(study::StartOver{})
                               : decltype(study::Input::action)(study::Undo{});
    case 4:
      return study::Pause{};
    case 5:
      return study::Tick{};
    default:
      break;
  }
  return study::Control{bench::any_input(type, *session.trial()->interface, rng)};
}

std::vector<Sample> samples_of(const Recorder& recorder) {
  std::vector<Sample> samples;
  for (const Record& record : recorder.records()) {
    if (const auto* sample = std::get_if<Sample>(&record)) samples.push_back(*sample);
  }
  return samples;
}

class Replay : public testing::TestWithParam<std::string> {};

TEST_P(Replay, OfTheLogShowsTheSameWeightsAtTheSameTimes) {
  const study::StudyBundle bundle = bundle_with(GetParam());
  const study::InterfaceType& type = *interfaces().find(GetParam());
  Recorder first(bundle);
  study::Rng rng(1, 2, "replay");
  std::int64_t t_us = 0;
  first.step(t_us += 1000, study::ChooseLanguage{"en"});
  while (first.session().trial() == nullptr) first.step(t_us += 1000, study::Continue{});
  for (int k = 0; k < 1500; ++k) {
    t_us += static_cast<std::int64_t>(rng.below(120'000));
    first.step(t_us, anything(type, first.session(), rng));
  }
  Recorder again(bundle);
  for (const Record& record : first.records()) {
    if (const auto* event = std::get_if<study::Event>(&record)) {
      if (const auto input = study::input_of(*event)) again.step(*input);
    } else if (const auto* sample = std::get_if<Sample>(&record)) {
      again.step(sample->t_us, study::Tick{});
    }
  }
  const std::vector<Sample> one = samples_of(first);
  const std::vector<Sample> two = samples_of(again);
  ASSERT_EQ(one.size(), two.size());
  ASSERT_GT(one.size(), 100U);
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ(one[i].t_us, two[i].t_us) << i;
    ASSERT_EQ(one[i].weights, two[i].weights) << i;
    ASSERT_EQ(one[i].d, two[i].d) << i;
  }
}

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const study::InterfaceType& type : interfaces().all()) names.push_back(type.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Registry, Replay, testing::ValuesIn(all_names()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace promenade::app
