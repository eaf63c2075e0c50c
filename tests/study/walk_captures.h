// Captures of generated walkers, written as BVH into a folder of a test's own; some of them broken.
#pragma once

#include "motion/bvh.h"
#include "motion/files.h"
#include "motion/take_clip.h"
#include "study/workshop_recipe.h"
#include "tests/motion/walker.h"
#include "tests/test_folder.h"

namespace promenade::study {

inline motion::Take walk_of(std::size_t cycle, int repeats) {
  static const motion::MotionSet set = motion::builtin_set("A").value();
  return motion::walker_take(set, set.cycles[cycle], repeats);
}

inline std::string text_of(const motion::Take& take) {
  return motion::bvh_text(motion::take_clip(take));
}

// The same text with another word in one line, counted from 1.
inline std::string damaged(const std::string& text, int line) {
  std::size_t at = 0;
  for (int k = 1; k < line; ++k) at = text.find('\n', at) + 1;
  return text.substr(0, at) + "lost" + text.substr(text.find_first_of(" \n", at));
}

class WalkCaptures {
 public:
  void add(const std::string& name, const std::string& text) {
    write_file(folder_.file("captures/" + name), text);
  }
  void add_walks() {
    add("walk_happy_001.bvh", text_of(walk_of(0, 5)));
    add("walk_happy_002.bvh", text_of(walk_of(1, 5)));
    add("walk_sad_001.bvh", text_of(walk_of(2, 5)));
  }
  void add_broken() { add("walk_broken_001.bvh", damaged(text_of(walk_of(3, 3)), lost_line)); }
  void add_turning() {
    const motion::Take straight = walk_of(0, 6);
    add("walk_round_001.bvh", text_of(motion::turned(straight, [&](int frame) {
          return 1.2 * straight.frame_time * frame;
        })));
  }
  // Another skeleton: it has no left wrist.
  void add_misfit() {
    std::string text = text_of(walk_of(0, 5));
    for (std::size_t at = 0; (at = text.find("left_elbow", at)) != std::string::npos;) {
      text.replace(at, 10, "left_crook");
    }
    add("walk_stranger_001.bvh", text);
  }
  std::string folder() const { return folder_.file("captures"); }
  std::string file(const std::string& name) const { return folder_.file(name); }
  static constexpr int lost_line = 150;

 private:
  TestFolder folder_;
};

// As the desk does it in its threads.
inline void read_all(Workshop& workshop) {
  while (const auto source = workshop.unread()) {
    workshop.take_in(*source, read_capture(*source, workshop.options()));
  }
}

}  // namespace promenade::study
