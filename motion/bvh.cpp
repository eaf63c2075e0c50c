#include "motion/bvh.h"

#include <charconv>
#include <cmath>

#include "motion/bvh_hierarchy.h"

namespace promenade::motion {
namespace {

[[noreturn]] void refuse(Scanner& in, std::string message) {
  in.error(std::move(message));
  in.give_up();
}

// "Frames:" or "Frames :".
void expect_label(Scanner& in, std::string_view label) {
  const std::string with_colon = std::string(label) + ":";
  if (in.take(with_colon) || (in.take(label) && in.take(":"))) return;
  in.next();
  refuse(in, "expected '" + with_colon + "'");
}

std::size_t read_frame_count(Scanner& in) {
  expect_label(in, "Frames");
  const ScannedNumber number = to_number(in.next());
  const double count = number.value;
  if (number.trouble || count != std::floor(count) || count < 0 || count > 1e12) {
    refuse(in, "the number of frames is not a whole number");
  }
  if (count == 0) refuse(in, "the file declares 0 frames: there is no motion in it");
  return static_cast<std::size_t>(count);
}

double read_frame_time(Scanner& in) {
  if (!in.take("FrameTime:")) {
    if (!in.take("Frame")) {
      in.next();
      refuse(in, "expected 'Frame Time:'");
    }
    expect_label(in, "Time");
  }
  const ScannedNumber number = to_number(in.next());
  if (number.trouble) refuse(in, std::string("the frame time ") + number.trouble);
  if (number.value <= 0 || number.value > 1000) {
    refuse(in, "the frame time must be above 0 (and below 1000 seconds)");
  }
  return number.value;
}

// The numbers below "Frame Time:". If the first line holds one whole frame, every
// line must; otherwise values may be laid out in any way.
class ValueReader {
 public:
  ValueReader(Scanner& in, std::size_t rows, std::size_t frames)
      : in_(in), rows_(rows), declared_(frames) {}

  std::vector<double> read() {
    // A value takes at least a digit and a blank: no more room than the text can fill.
    values_.reserve(std::min(declared_ * rows_, in_.left() / 2 + 1));
    while (!in_.at_end() && !in_.full()) read_line();
    if (in_.failed()) in_.give_up();
    check_size();
    values_.resize(declared_ * rows_);
    return std::move(values_);
  }

 private:
  void read_line() {
    const std::size_t before = count_;
    const std::size_t start = in_.position();
    std::size_t surplus = 0;
    while (!in_.at_line_end()) {
      read_value();
      if (count_ - before == rows_ + 1) surplus = in_.word_position();
    }
    const std::size_t found = count_ - before;
    if (first_line_ == 0) {
      first_line_ = found;
      first_line_at_ = start;
    }
    const bool by_lines = first_line_ >= rows_;
    if (by_lines && found != rows_ && !(count_ > declared_ * rows_ && found < rows_)) {
      in_.error_at(surplus > 0 ? surplus : in_.word_position(), line_trouble(found));
    }
  }

  std::string line_trouble(std::size_t found) const {
    return "this line holds " + std::to_string(found) + " values, but the channels want " +
           std::to_string(rows_);
  }

  void read_value() {
    const std::string_view word = in_.next();
    const ScannedNumber number = to_number(word);
    if (number.trouble && !in_.full()) {
      in_.error("'" + std::string(word.substr(0, 40)) + "' " + number.trouble);
    }
    ++count_;
    if (values_.size() < declared_ * rows_) values_.push_back(number.value);
  }

  void check_size() {
    const std::size_t wanted = declared_ * rows_;
    if (count_ < wanted) refuse_short();
    if (count_ > wanted) {
      const std::size_t extra = (count_ - wanted + rows_ - 1) / rows_;
      in_.warn_at(in_.word_position(), "the file declares " + std::to_string(declared_) +
                                           " frames but has " + std::to_string(declared_ + extra) +
                                           "; the declared ones are loaded");
    }
  }

  [[noreturn]] void refuse_short() {
    if (first_line_ > 0 && first_line_ < rows_ && count_ == first_line_ * declared_) {
      in_.error_at(first_line_at_, line_trouble(first_line_));
    } else if (count_ % rows_ == 0) {
      in_.error("the file declares " + std::to_string(declared_) + " frames but ends after " +
                std::to_string(count_ / rows_));
    } else {
      in_.error("the file ends within frame " + std::to_string(count_ / rows_ + 1) + " of " +
                std::to_string(declared_));
    }
    in_.give_up();
  }

  Scanner& in_;
  std::size_t rows_, declared_;
  std::size_t count_ = 0;       // values seen
  std::size_t first_line_ = 0;  // values on the first line
  std::size_t first_line_at_ = 0;
  std::vector<double> values_;
};

}  // namespace

Clip read_bvh(std::string_view text, const std::string& file) {
  Scanner in(text, file);
  if (in.at_end()) refuse(in, "the file is empty");
  BvhHierarchy hierarchy = read_bvh_hierarchy(in);
  const std::size_t frames = read_frame_count(in);
  Clip clip;
  clip.frame_time = read_frame_time(in);
  const auto rows = static_cast<std::size_t>(hierarchy.rows);
  const std::vector<double> values = ValueReader(in, rows, frames).read();
  clip.values = Eigen::Map<const Eigen::MatrixXd>(values.data(), hierarchy.rows,
                                                  static_cast<Eigen::Index>(frames));
  keep_the_figure(hierarchy, in);
  clip.file = file;
  clip.format = "bvh";
  clip.skeleton = std::move(hierarchy.skeleton);
  clip.channels = std::move(hierarchy.channels);
  clip.warnings = in.warnings();
  return clip;
}

}  // namespace promenade::motion
