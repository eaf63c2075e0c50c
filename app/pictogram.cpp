#include "app/pictogram.h"

#include <array>
#include <cmath>

namespace promenade::app {
namespace {

using View = Pictogram::View;
using Arrow = Pictogram::Arrow;

struct Point {
  float x, y;  // 0 to 1 of the box
};

// A line of the figure, from the side and from behind.
struct Bone {
  unsigned part;
  Point side_from, side_to, back_from, back_to;
};

constexpr std::array<Bone, 11> bones = {{
    {Pictogram::right_upper_arm, {.50f, .29f}, {.36f, .42f}, {.64f, .29f}, {.72f, .43f}},
    {Pictogram::right_forearm, {.36f, .42f}, {.34f, .57f}, {.72f, .43f}, {.76f, .58f}},
    {Pictogram::left_thigh, {.48f, .56f}, {.42f, .74f}, {.43f, .56f}, {.40f, .75f}},
    {Pictogram::left_shin, {.42f, .74f}, {.28f, .89f}, {.40f, .75f}, {.39f, .93f}},
    {Pictogram::left_foot, {.28f, .89f}, {.35f, .97f}, {.39f, .93f}, {.31f, .97f}},
    {Pictogram::torso, {.48f, .56f}, {.50f, .26f}, {.50f, .56f}, {.50f, .26f}},
    {Pictogram::right_thigh, {.48f, .56f}, {.61f, .73f}, {.57f, .56f}, {.60f, .75f}},
    {Pictogram::right_shin, {.61f, .73f}, {.64f, .93f}, {.60f, .75f}, {.61f, .93f}},
    {Pictogram::right_foot, {.64f, .93f}, {.76f, .92f}, {.61f, .93f}, {.69f, .97f}},
    {Pictogram::left_upper_arm, {.50f, .29f}, {.60f, .43f}, {.36f, .29f}, {.28f, .43f}},
    {Pictogram::left_forearm, {.60f, .43f}, {.73f, .50f}, {.28f, .43f}, {.24f, .58f}},
}};

class Sketch {
 public:
  Sketch(const Box& box, const Pictogram& pictogram, const Palette& palette)
      : box_(box), pictogram_(pictogram), palette_(palette) {}

  void draw() const {
    if ((pictogram_.parts & Pictogram::clock) != 0) return draw_clock();
    for (const bool marked : {false, true}) draw_bones(marked);
    draw_head();
    if (pictogram_.view == View::back) draw_girdles();
    if ((pictogram_.parts & Pictogram::centre) != 0) {
      list_->AddCircleFilled(at({.49f, .5f}), length(.1f), ink(true), 16);
    }
    draw_arrow();
  }

 private:
  ImVec2 at(Point point) const {
    return {box_.x + point.x * box_.width, box_.y + point.y * box_.height};
  }
  float length(float share) const { return share * box_.width; }
  ImU32 ink(bool marked) const { return packed(marked ? palette_.created : palette_.quiet); }
  bool has(unsigned part) const { return (pictogram_.parts & part) != 0; }
  void line(Point from, Point to, bool marked) const {
    list_->AddLine(at(from), at(to), ink(marked), length(marked ? .1f : .04f));
  }

  void draw_bones(bool marked) const {
    for (const Bone& bone : bones) {
      if (has(bone.part) != marked) continue;
      const bool side = pictogram_.view == View::side;
      line(side ? bone.side_from : bone.back_from, side ? bone.side_to : bone.back_to, marked);
    }
  }
  void draw_girdles() const {
    line({.36f, .29f}, {.64f, .29f}, has(Pictogram::torso));
    line({.43f, .56f}, {.57f, .56f}, false);
  }
  void draw_head() const {
    const ImVec2 middle = at({.51f, .14f});
    if (has(Pictogram::head)) {
      list_->AddCircleFilled(middle, length(.11f), ink(true), 20);
    } else {
      list_->AddCircle(middle, length(.09f), ink(false), 20, length(.04f));
    }
  }
  void draw_clock() const {
    list_->AddCircle(at({.5f, .5f}), length(.38f), ink(true), 32, length(.07f));
    line({.5f, .5f}, {.5f, .24f}, true);
    line({.5f, .5f}, {.68f, .58f}, true);
  }

  // Where the middle of what is marked is: the arrow goes beside it.
  float middle_height() const {
    float sum = has(Pictogram::head) ? .14f : 0;
    float count = has(Pictogram::head) ? 1 : 0;
    if (has(Pictogram::centre)) return .5f;
    for (const Bone& bone : bones) {
      if (!has(bone.part)) continue;
      sum += .5f * (bone.back_from.y + bone.back_to.y);
      ++count;
    }
    return count > 0 ? sum / count : .5f;
  }
  void draw_arrow() const {
    const float y = middle_height();
    if (pictogram_.arrow == Arrow::across) {
      half_arrow({.16f, y}, {0, y});
      half_arrow({.84f, y}, {1, y});
    } else if (pictogram_.arrow == Arrow::up) {
      half_arrow({.92f, y - .1f}, {.92f, y - .26f});
      half_arrow({.92f, y + .1f}, {.92f, y + .26f});
    }
  }
  // A short line with a head at its end.
  void half_arrow(Point from, Point to) const {
    const ImU32 colour = packed(palette_.text);
    const float thickness = length(.045f);
    list_->AddLine(at(from), at(to), colour, thickness);
    const float dx = to.x - from.x;
    const float dy = to.y - from.y;
    const float scale = .09f / std::hypot(dx, dy);
    const Point back{to.x - dx * scale, to.y - dy * scale};
    list_->AddLine(at({back.x - dy * scale, back.y + dx * scale}), at(to), colour, thickness);
    list_->AddLine(at({back.x + dy * scale, back.y - dx * scale}), at(to), colour, thickness);
  }

  const Box& box_;
  const Pictogram& pictogram_;
  const Palette& palette_;
  ImDrawList* list_ = ImGui::GetWindowDrawList();
};

struct PartName {
  std::string_view name;
  unsigned parts;
};
constexpr std::array<PartName, 16> part_names = {{
    {"torso", Pictogram::torso},
    {"head", Pictogram::head},
    {"left-upper-arm", Pictogram::left_upper_arm},
    {"right-upper-arm", Pictogram::right_upper_arm},
    {"left-forearm", Pictogram::left_forearm},
    {"right-forearm", Pictogram::right_forearm},
    {"left-thigh", Pictogram::left_thigh},
    {"right-thigh", Pictogram::right_thigh},
    {"left-shin", Pictogram::left_shin},
    {"right-shin", Pictogram::right_shin},
    {"left-foot", Pictogram::left_foot},
    {"right-foot", Pictogram::right_foot},
    {"com", Pictogram::centre},
    {"com-position", Pictogram::centre},
    {"com-velocity", Pictogram::centre},
    {"step-length", Pictogram::left_foot | Pictogram::right_foot},
}};

}  // namespace

Pictogram feature_pictogram(std::string_view feature) {
  // "sigma_left-foot_front-back": statistic, part, direction.
  const std::string_view rest = feature.substr(feature.find('_') + 1);
  const std::size_t bar = rest.find('_');
  if (bar == std::string_view::npos) return {.parts = Pictogram::clock};
  const std::string_view direction = rest.substr(bar + 1);
  Pictogram pictogram;
  pictogram.view = direction == "left-right" ? View::back : View::side;
  pictogram.arrow = direction == "vertical" ? Arrow::up : Arrow::across;
  for (const PartName& one : part_names) {
    if (one.name == rest.substr(0, bar)) pictogram.parts = one.parts;
  }
  return pictogram;
}

void draw_pictogram(const Box& box, const Pictogram& pictogram, const Palette& palette) {
  Sketch(box, pictogram, palette).draw();
}

}  // namespace promenade::app
