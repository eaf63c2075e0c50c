#include <algorithm>
#include <charconv>

#include "motion/bvh.h"
#include "motion/plain_clip.h"

namespace promenade::motion {
namespace {

void append(std::string& text, double value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value == 0 ? 0.0 : value).ptr;
  text.append(digits, end);
}

std::string plain_name(std::string name) {
  for (char& c : name) {
    if (c == ' ' || c == '\t' || c == '{' || c == '}') c = '_';
  }
  return name;
}

// Children in the order of the skeleton.
std::vector<std::vector<int>> children_of(const Skeleton& skeleton) {
  std::vector<std::vector<int>> children(skeleton.joints.size());
  for (int j = 1; j < skeleton.size(); ++j) {
    const int parent = skeleton.joints[static_cast<std::size_t>(j)].parent;
    children[static_cast<std::size_t>(parent)].push_back(j);
  }
  return children;
}

class HierarchyWriter {
 public:
  explicit HierarchyWriter(const Clip& clip)
      : clip_(clip), children_(children_of(clip.skeleton)), sites_(children_.size()) {
    for (const EndSite& site : clip.skeleton.end_sites) {
      sites_[static_cast<std::size_t>(site.joint)].push_back(site.offset);
    }
  }

  // Depth first without recursion; notes the order in which values must be written.
  std::string write(std::vector<std::size_t>& order) {
    text_ = "HIERARCHY\n";
    std::vector<std::pair<std::size_t, std::size_t>> open;  // joint, next child
    enter(0, 0);
    order.push_back(0);
    open.emplace_back(0, 0);
    while (!open.empty()) {
      auto& [joint, child] = open.back();
      if (child == children_[joint].size()) {
        open.pop_back();
        leave(joint, open.size());
        continue;
      }
      const auto next = static_cast<std::size_t>(children_[joint][child++]);
      enter(next, open.size());
      order.push_back(next);
      open.emplace_back(next, 0);
    }
    return std::move(text_);
  }

 private:
  void line(std::size_t depth, const std::string& content) {
    // Indentation ends somewhere: a chain of joints must not grow by its square.
    text_.append(2 * std::min<std::size_t>(depth, 40), ' ').append(content).push_back('\n');
  }

  static std::string offset_text(const Eigen::Vector3d& offset) {
    std::string text = "OFFSET";
    for (int axis = 0; axis < 3; ++axis) {
      text += ' ';
      append(text, offset(axis));
    }
    return text;
  }

  void enter(std::size_t joint, std::size_t depth) {
    const Joint& own = clip_.skeleton.joints[joint];
    line(depth, (own.parent < 0 ? "ROOT " : "JOINT ") + plain_name(own.name));
    line(depth, "{");
    line(depth + 1, offset_text(own.offset));
    const std::vector<Channel>& channels = clip_.channels[joint].channels;
    std::string text = "CHANNELS " + std::to_string(channels.size());
    for (const Channel channel : channels) text.append(" ").append(channel_name(channel));
    line(depth + 1, text);
  }

  void leave(std::size_t joint, std::size_t depth) {
    for (const Eigen::Vector3d& offset : sites_[joint]) {
      line(depth + 1, "End Site");
      line(depth + 1, "{");
      line(depth + 2, offset_text(offset));
      line(depth + 1, "}");
    }
    line(depth, "}");
  }

  const Clip& clip_;
  std::vector<std::vector<int>> children_;
  std::vector<std::vector<Eigen::Vector3d>> sites_;
  std::string text_;
};

}  // namespace

std::string bvh_text(const Clip& clip) {
  if (!clip.axes.empty()) return bvh_text(plain_clip(clip));
  std::vector<std::size_t> order;
  std::string text = HierarchyWriter(clip).write(order);
  text += "MOTION\nFrames: " + std::to_string(clip.frames()) + "\nFrame Time: ";
  append(text, clip.frame_time);
  text += '\n';
  for (int f = 0; f < clip.frames(); ++f) {
    for (const std::size_t joint : order) {
      const JointChannels& own = clip.channels[joint];
      for (std::size_t c = 0; c < own.channels.size(); ++c) {
        append(text, clip.values(own.first_row + static_cast<int>(c), f));
        text += ' ';
      }
    }
    text.back() = '\n';
  }
  return text;
}

}  // namespace promenade::motion
