#include "motion/asf_sections.h"

#include <algorithm>

namespace promenade::motion {
namespace {

double read_number(Scanner& in, std::string_view what) {
  const std::string_view word = in.next();
  const ScannedNumber number = to_number(word);
  if (number.trouble) in.refuse(quoted(word) + " in " + std::string(what) + " " + number.trouble);
  return number.value;
}

Eigen::Vector3d read_vector(Scanner& in, std::string_view what) {
  Eigen::Vector3d vector;
  for (int i = 0; i < 3; ++i) vector(i) = read_number(in, what);
  return vector;
}

int axis_from(char letter) {
  const std::size_t axis = std::string_view("xyz").find(static_cast<char>(letter | 0x20));
  return axis == std::string_view::npos ? -1 : static_cast<int>(axis);
}

// "XYZ" in any order.
std::array<int, 3> read_axis_order(Scanner& in) {
  const std::string_view word = in.next();
  std::array<int, 3> order = {-1, -1, -1};
  bool good = word.size() == 3;
  for (std::size_t i = 0; good && i < 3; ++i) {
    order[i] = axis_from(word[i]);
    good = order[i] >= 0 && (i < 1 || order[i] != order[0]) && (i < 2 || order[i] != order[1]);
  }
  if (!good) in.refuse(quoted(word) + " is no order of axes such as XYZ");
  return order;
}

// "rx" or "TZ".
std::optional<Channel> channel_from(std::string_view word) {
  const int axis = word.size() == 2 ? axis_from(word[1]) : -1;
  if (axis < 0) return std::nullopt;
  if ((word[0] | 0x20) == 't') return static_cast<Channel>(axis);
  if ((word[0] | 0x20) == 'r') return static_cast<Channel>(axis + 3);
  return std::nullopt;
}

// Words up to the end of the line.
std::vector<Channel> read_channels(Scanner& in) {
  std::vector<Channel> channels;
  while (!in.at_line_end()) {
    const std::string_view word = in.next();
    const std::optional<Channel> channel = channel_from(word);
    if (!channel) {
      in.refuse("expected a degree of freedom such as rx, found " + quoted(word) +
                meant(word, {"tx", "ty", "tz", "rx", "ry", "rz"}));
    }
    for (const Channel other : channels) {
      if (other == *channel) in.refuse("degree of freedom " + quoted(word) + " twice");
    }
    channels.push_back(*channel);
  }
  return channels;
}

bool at_keyword(Scanner& in) {
  const std::string_view word = in.peek();
  return word.empty() || word.front() == ':';
}

void skip_section(Scanner& in) {
  while (!at_keyword(in)) in.skip_line();
}

class SectionReader {
 public:
  explicit SectionReader(Scanner& in) : in_(in) {}

  AsfSections read() {
    while (!in_.at_end()) {
      if (!at_keyword(in_)) in_.refuse_next("expected a keyword such as :bonedata");
      read_section(in_.next());
    }
    if (!root_seen_) in_.refuse("the file has no section :root");
    return std::move(result_);
  }

 private:
  void read_section(std::string_view keyword) {
    if (same_word(keyword, ":units")) return read_units();
    if (same_word(keyword, ":root")) return read_root();
    if (same_word(keyword, ":bonedata")) return read_bones();
    if (same_word(keyword, ":hierarchy")) return read_hierarchy();
    const bool known = same_word(keyword, ":version") || same_word(keyword, ":name") ||
                       same_word(keyword, ":documentation");
    if (!known) {
      const std::string suggestion = meant(keyword, {":units", ":root", ":bonedata", ":hierarchy"});
      in_.warn_at(in_.word_position(), "section " + quoted(keyword) + " is left out" + suggestion);
    }
    in_.skip_line();
    skip_section(in_);
  }

  void read_units() {
    while (!at_keyword(in_)) {
      if (in_.take("length")) {
        result_.length = read_number(in_, "length");
        if (!(result_.length > 0)) in_.refuse("the unit of length must be above 0");
      } else if (in_.take("angle")) {
        read_angle_unit();
      } else {
        skip_other({"length", "angle"}, {"mass"});
      }
    }
  }

  void read_angle_unit() {
    result_.radians = in_.take_start("rad");
    if (!result_.radians && !in_.take_start("deg")) in_.refuse_next("expected deg or rad");
    in_.skip_line();
  }

  void read_root() {
    root_seen_ = true;
    while (!at_keyword(in_)) {
      if (in_.take("order")) {
        result_.root_order = read_channels(in_);
      } else if (in_.take("axis")) {
        result_.root_orientation.axis = read_axis_order(in_);
      } else if (in_.take("position")) {
        result_.root_position = read_vector(in_, "position");
      } else if (in_.take("orientation")) {
        for (double& angle : result_.root_orientation.angle) {
          angle = read_number(in_, "orientation");
        }
      } else {
        in_.refuse_next("expected order, axis, position or orientation",
                        {"order", "axis", "position", "orientation"});
      }
    }
  }

  void read_bones() {
    while (!at_keyword(in_)) {
      if (!in_.take("begin")) in_.refuse_next("expected begin", {"begin"});
      AsfBone bone;
      while (!in_.take("end")) read_in_bone(bone);
      if (bone.name.empty()) in_.refuse("a bone without a name");
      result_.bones.push_back(std::move(bone));
    }
  }

  void read_in_bone(AsfBone& bone) {
    if (at_keyword(in_)) in_.refuse_next("expected end of the bone");
    if (in_.take("name")) {
      bone.name = in_.next();
      bone.place = in_.word_position();
    } else if (in_.take("direction")) {
      bone.direction = read_vector(in_, "direction");
    } else if (in_.take("length")) {
      bone.length = read_number(in_, "length");
    } else if (in_.take("axis")) {
      for (double& angle : bone.axis.angle) angle = read_number(in_, "axis");
      bone.axis.axis = read_axis_order(in_);
    } else if (in_.take("dof")) {
      read_freedom(bone);
    } else if (in_.take("limits")) {
      skip_limits();
    } else {
      skip_other({"name", "direction", "length", "axis", "dof", "limits", "end"},
                 {"id", "bodymass", "cofmass"});
    }
  }

  // A line that says nothing about places, with a word if it was probably meant to.
  void skip_other(const std::vector<std::string>& read, const std::vector<std::string>& known) {
    const std::string_view word = in_.next();
    const bool expected = std::any_of(known.begin(), known.end(), [word](const std::string& other) {
      return same_word(word, other);
    });
    const std::string suggestion = expected ? "" : meant(word, read);
    if (!suggestion.empty()) {
      in_.warn_at(in_.word_position(), quoted(word) + " is left out" + suggestion);
    }
    in_.skip_line();
  }

  void read_freedom(AsfBone& bone) {
    const std::size_t place = in_.word_position();
    bone.channels = read_channels(in_);
    for (const Channel channel : bone.channels) {
      if (is_rotation(channel)) continue;
      in_.error_at(place, "bone '" + bone.name + "' moves along its parent (" +
                              std::string(channel_name(channel)) +
                              "); only the root may, in what this program reads");
      in_.give_up();
    }
  }

  // "(-160.0 20.0)" and more such lines. Blanks hide the parentheses, so numbers tell.
  void skip_limits() {
    in_.skip_line();
    while (!in_.at_end()) {
      const std::string_view word = in_.peek();
      const ScannedNumber number = to_number(word);
      const bool infinite = same_word(word, "inf") || same_word(word, "-inf");
      if (number.trouble && !infinite) return;
      in_.skip_line();
    }
  }

  void read_hierarchy() {
    if (!in_.take("begin")) in_.refuse_next("expected begin");
    while (!in_.take("end")) {
      if (at_keyword(in_)) in_.refuse_next("expected end of the hierarchy");
      AsfFamily family;
      family.parent = in_.next();
      family.place = in_.word_position();
      while (!in_.at_line_end()) {
        family.children.push_back(in_.next());
        family.places.push_back(in_.word_position());
      }
      result_.families.push_back(std::move(family));
    }
  }

  Scanner& in_;
  AsfSections result_;
  bool root_seen_ = false;
};

}  // namespace

AsfSections read_asf_sections(Scanner& in) { return SectionReader(in).read(); }

}  // namespace promenade::motion
