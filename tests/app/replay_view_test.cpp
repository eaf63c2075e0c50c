// A logged trial on its page, without a window.
#include "app/replay_view.h"

#include <gtest/gtest.h>

#include "app/registry.h"
#include "app/replay_window.h"
#include "tests/app/logged_trial.h"

namespace promenade::app {
namespace {

class ViewBench {
 public:
  explicit ViewBench(const std::string& interface, int width = 1280, int height = 720)
      : played(bench::played_trial(interface)),
        player(played.bundle, interfaces(), played.log, 0),
        gui(make_palette(false), replayed_words(played.bundle, played.log)),
        view(played.bundle, interfaces(), played.log, player, gui) {
    view.fit(width, height);
  }
  void show(std::int64_t t_us) {
    player.move_to(t_us);
    view.frame();
    view.frame();
  }

  bench::LoggedTrial played;
  TrialPlayer player;
  Gui gui;
  ReplayView view;
};

TEST(ReplayView, ShowsThePageOfTheTrialWithItsControls) {
  ViewBench bench("labels");
  bench.show(1'000'000);
  EXPECT_NE(bench.view.widgets().find("press", "done"), nullptr);
  EXPECT_NE(bench.view.widgets().find("pick", "proud"), nullptr);
}

TEST(ReplayView, NothingThatIsDoneToThePageReachesTheSession) {
  ViewBench bench("labels");
  bench.show(1'000'000);
  const Box row = bench.view.widgets().find("pick", "sad")->box;
  const Eigen::VectorXd before = bench.player.weights();
  ImGui::GetIO().MousePos = {row.middle_x(), row.middle_y()};
  for (const bool down : {true, false}) {
    ImGui::GetIO().MouseDown[0] = down;
    bench.view.frame();
  }
  bench.player.move_to(1'000'000);
  EXPECT_EQ(bench.player.weights(), before);
}

TEST(ReplayView, TheStripSaysWhoWhatWhenAndHowFar) {
  ViewBench bench("labels");
  bench.show(1'250'000);
  const std::string& strip = bench.view.strip();
  for (const char* part : {"P07", "trial 1: copy", "0:01.2 of 0:0", "D 0."}) {
    EXPECT_NE(strip.find(part), std::string::npos) << strip;
  }
}

TEST(ReplayView, TheStripLiesBeneathThePage) {
  for (const auto& [width, height] : {std::pair(1280, 720), std::pair(640, 376)}) {
    ViewBench bench("labels", width, height);
    bench.show(0);
    const Box done = bench.view.widgets().find("press", "done")->box;
    EXPECT_LE(done.bottom(), static_cast<float>(height - 16));
    EXPECT_LE(bench.gui.layout().stage().bottom(), static_cast<float>(height - 16));
  }
}

TEST(ReplayView, TheRingStandsWhereThePageWasPressedWhateverItsSize) {
  ViewBench bench("labels", 2560, 1488);
  bench.show(bench.player.length_us());
  ASSERT_TRUE(bench.player.pressed());
  ASSERT_TRUE(bench.view.ring());
  EXPECT_NEAR(bench.view.ring()->x(), 2 * bench.player.pressed()->x, 1);
  EXPECT_NEAR(bench.view.ring()->y(), 2 * bench.player.pressed()->y, 1);
}

TEST(ReplayView, ASessionWithoutAWindowHasNoRing) {
  bench::LoggedTrial played = bench::played_trial("labels");
  played.log.machine = "{}";
  TrialPlayer player(played.bundle, interfaces(), played.log, 0);
  Gui gui(make_palette(false), replayed_words(played.bundle, played.log));
  ReplayView view(played.bundle, interfaces(), played.log, player, gui);
  view.fit(1280, 720);
  player.move_to(player.length_us());
  EXPECT_TRUE(player.pressed());
  EXPECT_FALSE(view.ring());
}

TEST(ReplayPictures, ThereIsOneForEachStepAndOneOfTheEnd) {
  EXPECT_EQ(count_pictures(0, 30, 1), 1);
  EXPECT_EQ(count_pictures(2'000'000, 30, 1), 61);
  EXPECT_EQ(count_pictures(2'001'000, 30, 1), 62);
  EXPECT_EQ(count_pictures(2'000'000, 30, 2), 31);
}

}  // namespace
}  // namespace promenade::app
