#include "app/replay_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/session_view.h"

namespace promenade::app {
namespace {

constexpr float strip_height = 24;          // at 1280 x 720
constexpr std::int64_t flash_us = 400'000;  // of the ring after a press

// Nothing: the session had no window (a simulated one), so its presses have no place.
std::optional<Layout> layout_of(const study::LoggedSession& log, double share) {
  const auto machine = nlohmann::json::parse(log.machine, nullptr, false);
  if (!machine.is_object()) return std::nullopt;
  const auto number = [&machine](const char* name) {
    const auto found = machine.find(name);
    return found != machine.end() && found->is_number_integer() ? found->get<int>() : 0;
  };
  const int width = number("width");
  const int height = number("height");
  if (width <= 0 || height <= 0) return std::nullopt;
  return make_layout(width, height, share);
}

// "0:12.4"
std::string clock_text(std::int64_t t_us) {
  const std::int64_t tenths = t_us / 100'000;
  return fmt::format("{}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10);
}

std::string strip_text(const study::LoggedSession& log, const TrialPlayer& player) {
  const study::LoggedTrial& trial = player.trial();
  std::string text = fmt::format("{}   trial {}: {}", log.participant, trial.position, trial.task);
  for (const std::string& word : {trial.interface, trial.target}) {
    if (!word.empty()) text += ", " + word;
  }
  text += fmt::format("   {} of {}", clock_text(player.t_us()), clock_text(player.length_us()));
  if (player.d()) text += fmt::format("   D {:.4f} m", *player.d());
  return text;
}

void begin_cover(const char* name) {
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoFocusOnAppearing);
}

}  // namespace

std::vector<std::string> replayed_words(const study::StudyBundle& bundle,
                                        const study::LoggedSession& log) {
  std::vector<std::string> words = shown_words(bundle);
  words.push_back(log.participant);
  for (const study::LoggedTrial& trial : log.trials) {
    words.insert(words.end(), {trial.task, trial.interface, trial.target});
  }
  return words;
}

ReplayView::ReplayView(const study::StudyBundle& bundle, const study::InterfaceRegistry& registry,
                       const study::LoggedSession& log, TrialPlayer& player, Gui& gui)
    : bundle_(bundle),
      registry_(registry),
      log_(log),
      player_(player),
      gui_(gui),
      logged_layout_(layout_of(log, bundle.study.display.scale)),
      language_(log.language.empty() ? bundle.study.languages.front() : log.language),
      captions_(captions_in(language_, bundle)),
      content_{bundle.space, captions_, &player.stage().small_figures()} {}

bool ReplayView::fit(int width, int height) {
  const float scale =
      std::min(static_cast<float>(width) / 1280, static_cast<float>(height) / (720 + strip_height));
  const auto high = std::max(16, static_cast<int>(std::round(strip_height * scale)));
  strip_ = {0, static_cast<float>(height - high), static_cast<float>(width),
            static_cast<float>(high)};
  const bool fresh = gui_.fit(width, height - high, bundle_.study.display.scale);
  ImGui::GetIO().DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  return fresh;
}

StagePlan ReplayView::stage_plan() const {
  return gui_.layout().stage_plan(bundle_.study.display.examples == study::ExamplesWall::panel);
}

void ReplayView::frame(std::string_view hint) {
  ImGuiIO& io = ImGui::GetIO();
  io.DeltaTime = 1.0f / 60;
  ImGui::NewFrame();
  focus_.begin(widgets_);
  player_.stage().small_figures().clear();
  draw_page();
  begin_cover("replay");
  if (!player_.session().paused()) draw_ring();
  draw_strip(hint);
  ImGui::End();
  ImGui::Render();
}

void ReplayView::draw_page() {
  actions_.clear();
  changes_.clear();
  // The camera is the log's.
  const study::TrialState& trial = *player_.session().trial();
  memory_.camera_attempt = {trial.index, trial.attempt};
  memory_.told = player_.stage().orbit();
  draw_screen({.ui = {gui_.look(), gui_.layout(), widgets_, focus_},
               .bundle = bundle_,
               .session = player_.session(),
               .texts = captions_.texts,
               .registry = registry_,
               .content = content_,
               .language = language_,
               .participant = log_.participant,
               .languages = languages_,
               .now_us = player_.session_us(),
               .pilot = log_.pilot,
               .simulated = log_.simulated,
               .fresh = false,
               .chord = false,
               .failure = nullptr,
               .copy_problem = nullptr,
               .stage = player_.stage(),
               .stage_plan = stage_plan(),
               .memory = memory_,
               .actions = actions_,
               .orders = actions_,
               .changes = changes_});
}

void ReplayView::draw_figures(FigureRenderer& renderer) {
  const Palette& palette = gui_.look().palette;
  if (player_.session().paused()) return;
  player_.stage().draw(renderer, gui_.layout(), stage_plan(), palette);
  renderer.fill(gui_.layout().panel(), palette.panel);
  player_.stage().draw_small(renderer, palette);
}

std::optional<Eigen::Vector2f> ReplayView::ring() const {
  const std::optional<TrialPlayer::Pressed>& pressed = player_.pressed();
  if (!pressed || !logged_layout_) return std::nullopt;
  const Eigen::Vector2f then(static_cast<float>(pressed->x) - logged_layout_->left,
                             static_cast<float>(pressed->y) - logged_layout_->top);
  const Layout& now = gui_.layout();
  return Eigen::Vector2f(now.left, now.top) + then * (now.scale / logged_layout_->scale);
}

void ReplayView::draw_ring() const {
  const std::optional<Eigen::Vector2f> at = ring();
  if (!at) return;
  const Palette& palette = gui_.look().palette;
  const ImVec2 centre(at->x(), at->y());
  const float size = gui_.layout().scale;
  const auto since_us = static_cast<float>(player_.t_us() - player_.pressed()->t_us);
  const float flash = std::clamp(1 - since_us / static_cast<float>(flash_us), 0.0f, 1.0f);
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (flash > 0) {
    list->AddCircleFilled(centre, (13 + 9 * (1 - flash)) * size,
                          packed(palette.pilot, 0.7f * flash), 48);
  }
  list->AddCircle(centre, 13 * size, packed(palette.on_colour), 48, 5 * size);
  list->AddCircle(centre, 13 * size, packed(palette.text), 48, 2 * size);
}

void ReplayView::draw_strip(std::string_view hint) {
  const Look& look = gui_.look();
  const float gap = gui_.layout().size(16);
  fill(strip_, look.palette.text);
  Box rest{strip_.x + gap, strip_.y, strip_.width - 2 * gap, strip_.height};
  draw_text(look.fonts.bold, rest, look.palette.on_colour, "Replay");
  draw_text(look.fonts.text, rest, look.palette.line, hint, Align::right);
  const float shift = text_width(look.fonts.bold, "Replay") + gap;
  rest = {rest.x + shift, rest.y, rest.width - shift, rest.height};
  said_ = strip_text(log_, player_);
  rest.width -= text_width(look.fonts.text, hint);
  draw_line(look.fonts.text, rest, look.palette.on_colour, said_);
}

}  // namespace promenade::app
