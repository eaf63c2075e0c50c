// Where a replay stands and whether it runs, by the keys: Space pauses and goes on, at the end
// it plays again; the arrows go a second back or ahead; Esc closes. Knows no clock.
#pragma once

#include <cstdint>
#include <string_view>

namespace promenade::app {

class Playhead {
 public:
  // `speed`: 1 as in life.
  Playhead(std::int64_t length_us, double speed) : length_us_(length_us), speed_(speed) {}

  void pass(std::int64_t passed_us);  // in front of the screen
  void press(int glfw_key);           // others do nothing

  std::int64_t t_us() const { return static_cast<std::int64_t>(t_us_); }
  bool playing() const { return playing_; }
  bool at_end() const { return t_us() >= length_us_; }
  bool closed() const { return closed_; }
  std::string_view hint() const;  // what the keys do now

 private:
  void go_to(double t_us);

  std::int64_t length_us_;
  double speed_;
  double t_us_ = 0;
  bool playing_ = true, closed_ = false;
};

}  // namespace promenade::app
