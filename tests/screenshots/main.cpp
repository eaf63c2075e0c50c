// Photographs every screen and every interface: tools/screenshots runs it.
//
//     screenshots FOLDER [PART]     only pictures with PART in their name
//     screenshots --frames          no pictures: how long frames take
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cstdio>

#include "app/examples_window.h"
#include "app/print.h"
#include "tests/screenshots/films.h"
#include "tests/screenshots/frame_times.h"
#include "tests/screenshots/studies.h"

namespace promenade::app::screenshots {
namespace {

struct Size {
  int width, height;
};
constexpr std::array<Size, 2> sizes = {{{1280, 720}, {2560, 1440}}};
constexpr std::array<const char*, 2> languages = {"en", "ja"};

// The databases of the sessions, gone at the end.
class Scratch {
 public:
  Scratch()
      : folder_(std::filesystem::temp_directory_path() /
                ("promenade_screenshots_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

// The second window.
void photograph_examples(const Size& size, Album& album, const std::string& part) {
  for (const char* set : {"builtin:A", "builtin:N"}) {
    const study::StudyBundle bundle = make_study({.set = set, .interfaces = {"labels"}});
    const std::string prefix =
        fmt::format("en-{}x{}-{}", size.width, size.height, bundle.space.set.size());
    if ((prefix + "-examples").find(part) == std::string::npos) continue;
    ExamplesWindow examples(
        bundle, {.windowed = true, .shows_only = true, .width = size.width, .height = size.height});
    for (int k = 0; k < 3; ++k) examples.draw(0.2, false);
    album.add(prefix, "examples", photograph(size.width, size.height));
  }
}

void photograph_all(Album& album, const std::string& part) {
  const Scratch scratch;
  const std::vector<Film> films = all_films();
  for (const Size& size : sizes) {
    InputQueue queue;
    Window window(
        {.title = "screenshots", .windowed = true, .width = size.width, .height = size.height},
        queue);
    FigureRenderer renderer;
    Room room{window, renderer, queue, scratch.folder()};
    photograph_examples(size, album, part);
    room.window.use();
    for (const Film& film : films) {
      for (const char* language : languages) {
        const std::string prefix =
            fmt::format("{}-{}x{}-{}", language, size.width, size.height, film.styles());
        shoot_film(film, room, language, {album, prefix, part});
      }
    }
  }
  album.write_contact_sheet();
}

void measure() {
  const Scratch scratch;
  print_frame_times(scratch.folder());
}

}  // namespace
}  // namespace promenade::app::screenshots

int main(int count, char** arguments) {
  using namespace promenade::app::screenshots;
  if (count < 2 || count > 3) {
    std::fputs("usage: screenshots FOLDER [PART]\n", stderr);
    return 2;
  }
  try {
    if (std::string_view(arguments[1]) == "--frames") {
      measure();
      return 0;
    }
    Album album(arguments[1]);
    photograph_all(album, count == 3 ? arguments[2] : "");
    promenade::app::print_text(
        fmt::format("{} pictures; see {}/index.html\n", album.size(), arguments[1]));
    return 0;
  } catch (const std::exception& error) {
    std::fputs(fmt::format("error: {}\n", error.what()).c_str(), stderr);
    return 1;
  }
}
