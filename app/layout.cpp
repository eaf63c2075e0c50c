#include "app/layout.h"

#include <algorithm>
#include <cmath>

namespace promenade::app {

Layout make_layout(int width, int height, double share) {
  Layout layout;
  layout.scale = std::min(static_cast<float>(width) / 1280, static_cast<float>(height) / 720);
  layout.scale *= static_cast<float>(share);
  // Below half size nothing can be read; the picture is cut instead.
  layout.scale = std::max(layout.scale, 0.5f);
  layout.left =
      std::max(0.0f, std::floor(0.5f * (static_cast<float>(width) - 1280 * layout.scale)));
  layout.top = std::max(0.0f, std::floor(0.5f * (static_cast<float>(height) - 720 * layout.scale)));
  return layout;
}

float Layout::size(float at_720) const { return std::round(at_720 * scale); }

Box Layout::box(float x, float y, float width, float height) const {
  const float right = size(x + width);
  const float bottom = size(y + height);
  return {left + size(x), top + size(y), right - size(x), bottom - size(y)};
}

StagePlan Layout::instructions_plan() const {
  return {box(104, 464, 640, 240), size(164), top + size(650), top + size(668), {}, {}};
}

StagePlan Layout::stage_plan(bool with_wall) const {
  const auto y = [this](float at) { return top + size(at); };
  if (!with_wall) return {stage(), size(400), y(540), y(624), box(16, 656, 816, 32), {}};
  return {box(16, 64, 816, 404), size(270), y(384), y(428), box(16, 472, 816, 36),
          box(16, 512, 816, 176)};
}

}  // namespace promenade::app
