#include "tests/screenshots/frame_times.h"

#include <fmt/format.h>

#include "app/print.h"
#include "app/registry.h"
#include "app/window/frame_loop.h"
#include "tests/screenshots/films.h"
#include "tests/screenshots/studies.h"

namespace promenade::app::screenshots {
namespace {

void print_times(const std::string& name, const Scene& scene, Room& room, int frames) {
  const study::StudyBundle bundle = make_study(scene);
  Studio studio(room, bundle, ViewOptions());
  to_trial(studio);
  for (int k = 0; k < 30; ++k) studio.time_frame();  // the first ones compile shaders
  std::vector<std::int64_t> times;
  for (int k = 0; k < frames; ++k) times.push_back(studio.time_frame());
  print_text(fmt::format("{:<24}{:>8.1f}{:>8.1f}\n", name, quantile_ms(times, 0.5),
                         quantile_ms(times, 0.99)));
}

}  // namespace

void print_frame_times(const std::filesystem::path& folder, int frames) {
  InputQueue queue;
  Window window({.title = "frames", .windowed = true}, queue);
  FigureRenderer renderer;
  Room room{window, renderer, queue, folder};
  print_text(fmt::format("{:<24}{:>8}{:>8}\n", "55 styles, ms", "median", "p99"));
  for (const study::InterfaceType& type : interfaces().all()) {
    const Scene scene{.set = "builtin:N", .interfaces = {type.name}};
    print_times(type.name, scene, room, frames);
    if (type.name != "weights") continue;
    Scene wall = scene;
    wall.display = "examples = \"panel\"";
    print_times("weights, 55 examples", wall, room, frames);
  }
}

}  // namespace promenade::app::screenshots
