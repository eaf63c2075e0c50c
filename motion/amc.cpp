#include "motion/amc.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

#include "motion/angles.h"
#include "motion/scanner.h"

namespace promenade::motion {
namespace {

struct Header {
  std::optional<bool> radians;
  double rate = 0;  // 0: not stated
};

double read_rate(Scanner& in) {
  const ScannedNumber number = to_number(in.next());
  if (number.trouble || !(number.value > 0) || number.value > 1e5) {
    in.refuse("the rate must be a number of frames a second, above 0");
  }
  return number.value;
}

// Keywords up to the first frame.
Header read_header(Scanner& in) {
  Header header;
  while (!in.peek().empty() && in.peek().front() == ':') {
    const std::string_view word = in.next();
    if (same_word(word, ":degrees")) {
      header.radians = false;
    } else if (same_word(word, ":radians")) {
      header.radians = true;
    } else if (same_word(word, ":samples-per-second")) {
      header.rate = read_rate(in);
    } else if (!same_word(word, ":fully-specified")) {
      const std::string suggestion =
          meant(word, {":degrees", ":radians", ":samples-per-second", ":fully-specified"});
      in.warn_at(in.word_position(), "keyword " + quoted(word) + " is left out" + suggestion);
    }
    in.skip_line();
  }
  return header;
}

// The frames of the file, one column each. Bones come in the order of the first frame,
// as a rule; the table of names is asked only where they do not.
class FrameReader {
 public:
  FrameReader(Scanner& in, const AsfSkeleton& skeleton) : in_(in), skeleton_(skeleton) {
    for (int j = 0; j < skeleton.skeleton.size(); ++j) {
      joints_.emplace(skeleton.skeleton.joints[static_cast<std::size_t>(j)].name, j);
      bones_ += channels(j).empty() ? 0 : 1;
    }
    seen_.assign(joints_.size(), 0);
    // A frame takes a line for its number and one for each bone, a value at least a
    // digit and a blank.
    const auto rows = static_cast<std::size_t>(skeleton.rows);
    room_ = std::min(in.lines() / (bones_ + 1) + 1, in.left() / 2 / rows + 1);
    values_.resize(skeleton.rows, static_cast<Eigen::Index>(room_));
  }

  Eigen::MatrixXd read() {
    while (!in_.at_end() && !full()) read_frame();
    say_complaints();
    if (in_.failed()) in_.give_up();
    if (frames_ == 0) in_.refuse("there is no frame in it");
    values_.conservativeResize(Eigen::NoChange, static_cast<Eigen::Index>(frames_));
    return std::move(values_);
  }

 private:
  const std::vector<Channel>& channels(int joint) const {
    return skeleton_.channels[static_cast<std::size_t>(joint)].channels;
  }

  // "17", alone on its line.
  void read_frame_number() {
    const ScannedNumber number = to_number(in_.next());
    if (number.trouble || number.value != std::floor(number.value)) {
      say_complaints();
      in_.refuse("expected the number of a frame");
    }
    if (frames_ > 0 && number.value != number_ + 1) {
      in_.error("frame " + whole(number.value) + " comes after frame " + whole(number_));
    }
    number_ = number.value;
    number_at_ = in_.word_position();
    if (in_.at_line_end()) return;
    say_complaints();
    in_.refuse_next("expected nothing behind the number of a frame");
  }

  static std::string whole(double number) {
    return std::abs(number) < 1e15 ? std::to_string(static_cast<long long>(number)) : "?";
  }

  static bool begins_number(std::string_view word) {
    const char c = word.empty() ? '0' : word.front();
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
  }

  void read_frame() {
    read_frame_number();
    ++frames_;
    std::size_t found = 0;
    for (std::size_t place = 0; !full(); ++place) {
      const std::string_view name = in_.peek();
      if (begins_number(name)) break;
      const int joint = find(name, place);
      in_.next();
      if (joint >= 0) {
        found += read_bone(joint) ? 1 : 0;
      } else {
        complain(in_.word_position(), quoted(name) + " is no bone of " + skeleton_.file, name);
        in_.skip_line();
      }
    }
    if (found < bones_ && !full()) name_the_missing();
  }

  int find(std::string_view name, std::size_t place) {
    if (place < order_.size() && name == *order_[place].first) return order_[place].second;
    const auto found = joints_.find(std::string(name));
    if (found == joints_.end()) return -1;
    if (frames_ == 1) order_.emplace_back(&found->first, found->second);
    return found->second;
  }

  // False: it was read before in this frame.
  bool read_bone(int joint) {
    const std::size_t name_at = in_.word_position();
    const std::size_t wanted = channels(joint).size();
    const int row = skeleton_.channels[static_cast<std::size_t>(joint)].first_row;
    const bool fits = frames_ <= room_ && wanted > 0;
    double* const out = fits ? &values_(row, static_cast<Eigen::Index>(frames_) - 1) : nullptr;
    std::size_t found = in_.take_numbers(out, wanted);
    for (; !in_.at_line_end() && !full(); ++found) {
      const double value = read_odd_value();
      if (out && found < wanted) out[found] = value;
    }
    if (found != wanted) complain(name_at, wrong_number(joint, found));
    std::size_t& seen = seen_[static_cast<std::size_t>(joint)];
    const bool again = std::exchange(seen, frames_) == frames_;
    if (again) complain(name_at, "bone " + name_of(joint) + " twice in one frame");
    return !again && wanted > 0;
  }

  double read_odd_value() {
    const std::string_view word = in_.next();
    const ScannedNumber number = to_number(word);
    if (number.trouble) in_.error(quoted(word) + " " + number.trouble);
    return number.value;
  }

  std::string name_of(int joint) const {
    return quoted(skeleton_.skeleton.joints[static_cast<std::size_t>(joint)].name);
  }

  std::string wrong_number(int joint, std::size_t found) const {
    return "bone " + name_of(joint) + " has " + std::to_string(channels(joint).size()) +
           " degrees of freedom in " + skeleton_.file + ", but this line holds " +
           std::to_string(found) + " values";
  }

  void name_the_missing() {
    std::string names;
    for (int j = 0; j < skeleton_.skeleton.size() && names.size() < 100; ++j) {
      if (channels(j).empty() || seen_[static_cast<std::size_t>(j)] == frames_) continue;
      names += (names.empty() ? " " : ", ") + name_of(j);
    }
    if (!names.empty()) complain(number_at_, "the frame lacks" + names);
  }

  // What is wrong in one frame is wrong in most others: it is said once.
  struct Complaint {
    std::size_t at = 0;     // where it was met first
    int again = 0;          // how often later on
    std::string_view name;  // that is no bone
  };

  void complain(std::size_t at, const std::string& message, std::string_view name = {}) {
    const auto [known, fresh] = complaints_.try_emplace(message, Complaint{at, 0, name});
    if (!fresh) ++known->second.again;
  }

  std::vector<std::string> bones() const {
    std::vector<std::string> names;
    for (const Joint& joint : skeleton_.skeleton.joints) names.push_back(joint.name);
    return names;
  }

  bool full() const { return in_.full() || complaints_.size() >= 20; }

  void say_complaints() {
    for (const auto& [message, one] : complaints_) {
      const std::string times = one.again > 0 ? "; so " + std::to_string(one.again) +
                                                    (one.again == 1 ? " time" : " times") + " more"
                                              : "";
      in_.error_at(one.at, message + times + (one.name.empty() ? "" : meant(one.name, bones())));
    }
    complaints_.clear();
  }

  Scanner& in_;
  const AsfSkeleton& skeleton_;
  std::unordered_map<std::string, int> joints_;
  std::vector<std::pair<const std::string*, int>> order_;  // of the first frame
  std::vector<std::size_t> seen_;                          // J: last frame that named it
  std::size_t bones_ = 0;                                  // that move
  std::size_t room_ = 0;                                   // frames
  std::size_t frames_ = 0;
  std::map<std::string, Complaint> complaints_;
  double number_ = 0;  // of the last frame
  std::size_t number_at_ = 0;
  Eigen::MatrixXd values_;  // C x T
};

// Degrees, and the root from the origin.
void settle(Eigen::MatrixXd& values, const AsfSkeleton& skeleton, bool radians) {
  for (const JointChannels& own : skeleton.channels) {
    int row = own.first_row;
    for (const Channel channel : own.channels) {
      if (!is_rotation(channel)) {
        const double start = skeleton.root_position(static_cast<int>(channel));
        if (start != 0) values.row(row).array() += start;
      } else if (radians) {
        values.row(row) *= 180 / pi;
      }
      ++row;
    }
  }
}

double frame_time(Scanner& in, const Header& header, std::optional<double> rate) {
  if (rate) return 1 / *rate;
  if (header.rate > 0) return 1 / header.rate;
  in.warn_at(0, "the file does not say its frame rate; 120 frames a second are assumed");
  return 1 / usual_amc_rate;
}

}  // namespace

Clip read_amc(std::string_view text, const std::string& file, const AsfSkeleton& skeleton,
              std::optional<double> rate) {
  Scanner in(text, file, Punctuation::acclaim);
  if (in.at_end()) in.refuse("the file is empty");
  const Header header = read_header(in);
  Clip clip;
  clip.file = file;
  clip.format = "asf/amc";
  clip.skeleton = skeleton.skeleton;
  clip.channels = skeleton.channels;
  clip.axes = skeleton.axes;
  clip.unit_m = skeleton.unit_m;
  clip.values = FrameReader(in, skeleton).read();
  settle(clip.values, skeleton, header.radians.value_or(skeleton.radians));
  clip.frame_time = frame_time(in, header, rate);
  clip.warnings = skeleton.warnings;
  const std::vector<Problem> own = in.warnings();
  clip.warnings.insert(clip.warnings.end(), own.begin(), own.end());
  return clip;
}

}  // namespace promenade::motion
