#include "motion/bvh.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/bvh_hierarchy.h"

namespace promenade::motion {
namespace {

// "Frames:" or "Frames :".
void expect_label(Scanner& in, std::string_view label) {
  const std::string with_colon = std::string(label) + ":";
  if (in.take_start(with_colon) || (in.take(label) && in.take_start(":"))) return;
  in.refuse_next("expected '" + with_colon + "'");
}

std::size_t read_frame_count(Scanner& in) {
  expect_label(in, "Frames");
  const std::string_view word = in.next();
  const ScannedNumber number = to_number(word);
  const double count = number.value;
  if (number.trouble || count != std::floor(count) || count < 0 || count > 1e12) {
    in.refuse("Frames wants a whole number, found " + quoted(word));
  }
  if (count == 0) in.refuse("the file declares 0 frames: there is no motion in it");
  return static_cast<std::size_t>(count);
}

double read_frame_time(Scanner& in) {
  if (!in.take_start("FrameTime:")) {
    if (!in.take("Frame")) in.refuse_next("expected 'Frame Time:'");
    expect_label(in, "Time");
  }
  const ScannedNumber number = to_number(in.next());
  if (number.trouble) in.refuse(std::string("the frame time ") + number.trouble);
  if (number.value <= 0 || number.value > 1000) {
    in.refuse("the frame time must be above 0 (and below 1000 seconds)");
  }
  return number.value;
}

// The numbers below "Frame Time:". If the first line holds just one frame, every line
// must; otherwise values may be laid out in any way.
class ValueReader {
 public:
  ValueReader(Scanner& in, std::size_t rows, std::size_t frames)
      : in_(in),
        rows_(rows),
        wanted_(frames <= in.left() ? rows * frames : std::string_view::npos),
        declared_(frames) {
    assert(rows > 0 && "a hierarchy has channels");
    // A value takes at least a digit and a blank. A file that is too short for its
    // declaration is read for its errors alone.
    if (wanted_ <= in.left() / 2 + 1) {
      values_.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(frames));
    }
  }

  Eigen::MatrixXd read() {
    while (!in_.at_end() && !in_.full()) read_line();
    if (in_.failed()) in_.give_up();
    check_size();
    return std::move(values_);
  }

 private:
  void read_line() {
    const std::size_t start = in_.position(), rows = rows_;
    std::size_t found = take_values(rows);
    const bool longer = found == rows && !in_.at_line_end();
    const std::size_t surplus = in_.position();
    if (longer) found += take_values(std::string_view::npos);
    const bool first = count_ == found;
    if (first) {
      first_line_ = found;
      first_line_at_ = start;
    }
    const bool rest = count_ > wanted_ && found < rows;
    const bool wrong =
        first ? found > rows && found % rows != 0 : first_line_ == rows && found != rows && !rest;
    if (wrong) in_.error_at(longer ? surplus : in_.word_position(), line_trouble(found));
  }

  std::string line_trouble(std::size_t found) const {
    return "this line holds " + std::to_string(found) + " values, but the channels want " +
           std::to_string(rows_);
  }

  // Takes what is left of the line, at most so many.
  std::size_t take_values(std::size_t most) {
    std::size_t found = 0;
    while (found < most && !in_.at_line_end()) {
      double* const out = room() > 0 ? values_.data() + count_ : nullptr;
      std::size_t taken =
          in_.take_numbers(out, out ? std::min(most - found, room()) : most - found);
      if (taken == 0) {
        read_odd_value();
        taken = 1;
      }
      count_ += taken;
      found += taken;
    }
    return found;
  }

  std::size_t room() const {
    const auto size = static_cast<std::size_t>(values_.size());
    return count_ < size ? size - count_ : 0;
  }

  // What the fast way did not take: an unusual number, or none at all.
  void read_odd_value() {
    const std::string_view word = in_.next();
    const ScannedNumber number = to_number(word);
    if (number.trouble && !in_.full()) in_.error(quoted(word) + " " + number.trouble);
    if (room() > 0) values_.data()[count_] = number.value;
  }

  void check_size() {
    if (count_ < wanted_) refuse_short();
    if (count_ > wanted_) {
      const std::size_t extra = (count_ - wanted_ + rows_ - 1) / rows_;
      in_.warn_at(in_.word_position(), "the file declares " + std::to_string(declared_) +
                                           " frames but has " + std::to_string(declared_ + extra) +
                                           "; the declared ones are loaded");
    }
  }

  [[noreturn]] void refuse_short() {
    if (first_line_ > 0 && first_line_ < rows_ && count_ == first_line_ * declared_) {
      in_.error_at(first_line_at_, line_trouble(first_line_));
      in_.give_up();
    }
    if (count_ % rows_ == 0) {
      in_.refuse("the file declares " + std::to_string(declared_) + " frames but ends after " +
                 std::to_string(count_ / rows_));
    }
    in_.refuse("the file ends within frame " + std::to_string(count_ / rows_ + 1) + " of " +
               std::to_string(declared_));
  }

  Scanner& in_;
  std::size_t rows_, wanted_, declared_;
  std::size_t count_ = 0;       // values seen
  std::size_t first_line_ = 0;  // values on the first line
  std::size_t first_line_at_ = 0;
  Eigen::MatrixXd values_;  // C x T, or nothing
};

}  // namespace

Clip read_bvh(std::string_view text, const std::string& file) {
  Scanner in(text, file);
  if (in.at_end()) in.refuse("the file is empty");
  BvhHierarchy hierarchy = read_bvh_hierarchy(in);
  const std::size_t frames = read_frame_count(in);
  Clip clip;
  clip.frame_time = read_frame_time(in);
  const auto rows = static_cast<std::size_t>(hierarchy.rows);
  clip.values = ValueReader(in, rows, frames).read();
  keep_the_figure(hierarchy, in);
  clip.file = file;
  clip.format = "bvh";
  clip.skeleton = std::move(hierarchy.skeleton);
  clip.channels = std::move(hierarchy.channels);
  clip.warnings = in.warnings();
  return clip;
}

}  // namespace promenade::motion
