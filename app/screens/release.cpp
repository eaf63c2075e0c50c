// Practice is over when the experimenter says so: only that panel leads on.
#include "app/screens/screen.h"

namespace promenade::app {

void draw_release(const Screen& screen) {
  draw_text_column(screen, screen.texts("release.title"), screen.texts("release.text"));
}

}  // namespace promenade::app
