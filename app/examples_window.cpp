#include "app/examples_window.h"

#include "app/screens/screen.h"
#include "app/session_view.h"

namespace promenade::app {

ExamplesWindow::ExamplesWindow(const study::StudyBundle& bundle, const WindowOptions& options)
    : bundle_(bundle),
      window_(options, nothing_),
      gui_(make_palette(bundle.study.display.paper_colours), shown_words(bundle)),
      mannequin_(make_mannequin(bundle.space.set)),
      figures_(bundle.bank, mannequin_),
      language_(bundle.study.languages.front()),
      captions_(captions_in(language_, bundle)),
      content_{bundle.space, captions_, &figures_} {}

ExamplesWindow::~ExamplesWindow() {
  window_.use();
  gui_.use();
}

void ExamplesWindow::speak(const std::string& language) {
  if (language == language_) return;
  language_ = language;
  captions_ = captions_in(language, bundle_);
}

void ExamplesWindow::draw_names() {
  ImGuiIO& io = ImGui::GetIO();
  io.DeltaTime = 1.0f / 60;
  ImGui::NewFrame();
  figures_.clear();
  widgets_.clear();
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(io.DisplaySize);
  ImGui::Begin("examples", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground);
  const Ui ui{gui_.look(), gui_.layout(), widgets_, focus_};
  draw_examples(ui, gui_.layout().box(24, 24, 1232, 672), content_, figures_, weights_);
  ImGui::End();
  ImGui::Render();
}

void ExamplesWindow::draw(double phase, bool hidden) {
  window_.use();
  gui_.use();
  if (gui_.fit(window_.width(), window_.height())) gui_renderer_.upload_fonts();
  const Palette& palette = gui_.look().palette;
  renderer_.begin(window_.width(), window_.height(), palette.background);
  if (hidden) return;
  draw_names();
  figures_.draw(renderer_, phase, start_yaw, palette.track);
  gui_renderer_.draw();
}

}  // namespace promenade::app
