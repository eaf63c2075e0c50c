#include "motion/load_clip.h"
#include "tests/motion/captures.h"
#include "tests/motion/graph/matching.h"

namespace promenade::motion {
namespace {

constexpr int window = 10;  // frames: a third of a second

// Two styles of one actor, 30 frames a second.
class CapturedStyles : public Captures {
 protected:
  void SetUp() override {
    Captures::SetUp();
    if (IsSkipped()) return;
    for (const char* style : {"normal", "happy"}) {
      const auto file = data_folder() / "bandai-namco-walk" /
                        ("dataset-1_walk_" + std::string(style) + "_001.bvh");
      if (!std::filesystem::exists(file)) GTEST_SKIP() << "There is no capture " << file << ".";
      const Clip clip = load_clip(file);
      takes_.push_back(make_take(clip, find_figure(clip)));
    }
  }

  // From every fifth frame of the one to where the other is most like it.
  std::vector<Transition> transitions() const {
    const Matchable a(takes_[0]), b(takes_[1]);
    std::vector<Transition> all;
    for (int i = 1; i + window <= takes_[0].frames(); i += 5) {
      const FoundMatch match = best_match(a, i, b, window - 1, takes_[1].frames() - 2, window);
      if (match.distance.rms() < 0.05) all.push_back(transition_of(a, b, match));
    }
    return all;
  }

 private:
  std::vector<Take> takes_;
};

TEST_F(CapturedStyles, ThatAreAlikePassIntoEachOtherMoreOftenThanNot) {
  const std::vector<Transition> all = transitions();
  const auto usable = std::count_if(all.begin(), all.end(), [](const Transition& transition) {
    return transition.refusal.empty();
  });
  EXPECT_GE(all.size(), 10U);
  EXPECT_GE(2 * static_cast<std::size_t>(usable), all.size());
}

TEST_F(CapturedStyles, PassIntoEachOtherOnFeetThatStand) {
  double raw = 0;
  for (const Transition& transition : transitions()) {
    raw = std::max(raw, transition.quality.slide_raw_m);
    if (!transition.refusal.empty()) continue;
    EXPECT_LT(transition.quality.slide_m, 0.005);
    EXPECT_LE(transition.quality.gap_m, transition.quality.inside_gap_m * (1 + 1e-9));
    EXPECT_LE(transition.quality.knee_gap, transition.quality.inside_knee_gap * (1 + 1e-9));
  }
  EXPECT_GT(raw, 0.02) << "there is something to keep";
}

}  // namespace
}  // namespace promenade::motion
