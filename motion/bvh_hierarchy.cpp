#include "motion/bvh_hierarchy.h"

#include <algorithm>
#include <deque>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "motion/body_names.h"

namespace promenade::motion {
namespace {

constexpr std::size_t longest_name = 1000;

// A block that is open: a joint, or the end site of one.
struct Open {
  int joint = 0;
  bool end_site = false;
  bool offset_seen = false;
  bool channels_seen = false;
};

class HierarchyReader {
 public:
  explicit HierarchyReader(Scanner& in) : in_(in) {}

  BvhHierarchy read() {
    if (!in_.take("HIERARCHY")) {
      in_.refuse_next("expected HIERARCHY: this is not a BVH file");
    }
    while (!in_.take("MOTION")) {
      if (!open_.empty()) {
        read_in_block();
      } else if (in_.take("ROOT")) {
        open_joint(-1);
      } else {
        in_.refuse_next("expected ROOT or MOTION", {"ROOT", "MOTION"});
      }
    }
    if (!open_.empty())
      in_.refuse("MOTION before the block of joint " + name_of(open_.back().joint) +
                 " was closed by '}'");
    if (result_.skeleton.joints.empty()) in_.refuse("no joint before MOTION");
    if (result_.rows == 0) in_.refuse("no joint has a channel: nothing can move");
    return std::move(result_);
  }

 private:
  void read_in_block() {
    const Open& block = open_.back();
    if (in_.take("OFFSET")) return read_offset();
    if (in_.take("}")) return close();
    if (block.end_site) in_.refuse_next("expected OFFSET or '}'", {"OFFSET"});
    if (in_.take("CHANNELS")) return read_channels();
    if (in_.take("JOINT")) return open_joint(block.joint);
    if (in_.take("End") || in_.take("EndSite")) return open_end_site();
    in_.refuse_next("expected OFFSET, CHANNELS, JOINT, End Site or '}'",
                    {"OFFSET", "CHANNELS", "JOINT", "End"});
  }

  std::string name_of(int joint) const {
    return quoted(result_.skeleton.joints[static_cast<std::size_t>(joint)].name);
  }

  void open_joint(int parent) {
    const std::size_t keyword = in_.word_position();
    const std::string_view name = in_.rest_of_line();
    if (name.empty() || name.size() > longest_name) {
      in_.error_at(keyword, name.empty() ? "a joint without a name"
                                         : "a joint with a name of more than 1000 letters");
      in_.give_up();
    }
    result_.skeleton.joints.push_back({unique_name(name), parent, Eigen::Vector3d::Zero()});
    result_.channels.push_back({{}, result_.rows});
    if (!in_.take("{")) in_.refuse_next("expected '{' after the name of a joint");
    open_.push_back({result_.skeleton.size() - 1, false, false, false});
  }

  std::string unique_name(std::string_view name) {
    if (names_.insert(name).second) return std::string(name);
    int& copies = copies_[name];
    if (copies == 0) copies = 1;
    do {
      made_names_.push_back(std::string(name) + "_" + std::to_string(++copies));
    } while (!names_.insert(made_names_.back()).second);
    in_.warn_at(in_.word_position(), "a second joint named " + quoted(name) + "; it is called '" +
                                         made_names_.back() + "' here");
    return made_names_.back();
  }

  void open_end_site() {
    in_.rest_of_line();
    if (!in_.take("{")) in_.refuse_next("expected '{' after End Site");
    const int joint = open_.back().joint;
    result_.skeleton.end_sites.push_back({joint, Eigen::Vector3d::Zero()});
    open_.push_back({joint, true, false, true});
  }

  void close() {
    const Open block = open_.back();
    if (!block.offset_seen) {
      in_.refuse((block.end_site ? "an end site of joint " : "joint ") + name_of(block.joint) +
                 " without an OFFSET");
    }
    open_.pop_back();
  }

  void read_offset() {
    Open& block = open_.back();
    if (block.offset_seen) in_.refuse("a second OFFSET in one block");
    block.offset_seen = true;
    Eigen::Vector3d& offset =
        block.end_site ? result_.skeleton.end_sites.back().offset
                       : result_.skeleton.joints[static_cast<std::size_t>(block.joint)].offset;
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view word = in_.next();
      const ScannedNumber number = to_number(word);
      if (number.trouble) in_.refuse(quoted(word) + " in OFFSET " + number.trouble);
      offset(axis) = number.value;
    }
  }

  void read_channels() {
    Open& block = open_.back();
    if (block.channels_seen) in_.refuse("a second CHANNELS in one block");
    block.channels_seen = true;
    const std::string_view word = in_.next();
    const ScannedNumber count = to_number(word);
    if (count.trouble || count.value < 0 || count.value > 6 ||
        count.value != static_cast<int>(count.value)) {
      in_.refuse("CHANNELS wants a whole number from 0 to 6, found " + quoted(word));
    }
    JointChannels& list = result_.channels[static_cast<std::size_t>(block.joint)];
    list.first_row = result_.rows;
    for (int c = 0; c < static_cast<int>(count.value); ++c) read_channel(list, word);
    if (is_channel(in_.peek())) {
      in_.refuse_next("CHANNELS says " + std::string(word) + ", but there are more");
    }
    result_.rows += static_cast<int>(list.channels.size());
  }

  static std::optional<Channel> channel_from(std::string_view word) {
    for (int c = 0; c < 6; ++c) {
      if (same_word(word, channel_name(static_cast<Channel>(c)))) return static_cast<Channel>(c);
    }
    return std::nullopt;
  }

  static std::vector<std::string> channel_names() {
    std::vector<std::string> names;
    for (int c = 0; c < 6; ++c) names.emplace_back(channel_name(static_cast<Channel>(c)));
    return names;
  }

  static bool is_channel(std::string_view word) { return channel_from(word).has_value(); }

  void read_channel(JointChannels& list, std::string_view count) {
    const std::string_view word = in_.next();
    const std::optional<Channel> channel = channel_from(word);
    if (!channel) {
      in_.refuse("CHANNELS says " + std::string(count) +
                 "; expected a channel such as Xrotation, found " + quoted(word) +
                 meant(word, channel_names()));
    }
    for (const Channel other : list.channels) {
      if (other == *channel) in_.refuse("channel " + quoted(word) + " twice on one joint");
    }
    list.channels.push_back(*channel);
  }

  Scanner& in_;
  BvhHierarchy result_;
  std::vector<Open> open_;
  std::unordered_set<std::string_view> names_;  // in the text, or in made_names_
  std::deque<std::string> made_names_;
  std::unordered_map<std::string_view, int> copies_;
};

// The tree of every joint: the index of its root among the roots.
std::vector<int> trees(const Skeleton& skeleton, std::vector<int>& roots) {
  std::vector<int> tree;
  for (int j = 0; j < skeleton.size(); ++j) {
    const int parent = skeleton.joints[static_cast<std::size_t>(j)].parent;
    if (parent < 0) roots.push_back(j);
    tree.push_back(parent < 0 ? static_cast<int>(roots.size()) - 1
                              : tree[static_cast<std::size_t>(parent)]);
  }
  return tree;
}

int tree_of_the_figure(const Skeleton& skeleton, const std::vector<int>& tree, int count) {
  std::vector<int> score(static_cast<std::size_t>(count));
  const int more_than_any = skeleton.size() + 1;
  for (std::size_t j = 0; j < tree.size(); ++j) {
    int& own = score[static_cast<std::size_t>(tree[j])];
    own += 1;
    if (own < more_than_any && names_the_hips(skeleton.joints[j].name)) own += more_than_any;
  }
  return static_cast<int>(std::max_element(score.begin(), score.end()) - score.begin());
}

void keep_tree(BvhHierarchy& all, const std::vector<int>& tree, int kept) {
  BvhHierarchy one;
  one.rows = all.rows;
  std::vector<int> moved(tree.size(), -1);
  for (std::size_t j = 0; j < tree.size(); ++j) {
    if (tree[j] != kept) continue;
    moved[j] = one.skeleton.size();
    Joint joint = all.skeleton.joints[j];
    if (joint.parent >= 0) joint.parent = moved[static_cast<std::size_t>(joint.parent)];
    one.skeleton.joints.push_back(std::move(joint));
    one.channels.push_back(all.channels[j]);
  }
  for (EndSite site : all.skeleton.end_sites) {
    site.joint = moved[static_cast<std::size_t>(site.joint)];
    if (site.joint >= 0) one.skeleton.end_sites.push_back(site);
  }
  all = std::move(one);
}

}  // namespace

BvhHierarchy read_bvh_hierarchy(Scanner& in) { return HierarchyReader(in).read(); }

void keep_the_figure(BvhHierarchy& hierarchy, Scanner& in) {
  std::vector<int> roots;
  const std::vector<int> tree = trees(hierarchy.skeleton, roots);
  if (roots.size() == 1) return;
  const int kept = tree_of_the_figure(hierarchy.skeleton, tree, static_cast<int>(roots.size()));
  std::string others;
  for (std::size_t r = 0; r < roots.size(); ++r) {
    if (static_cast<int>(r) == kept) continue;
    if (others.size() > 200) {
      others += " and more";
      break;
    }
    others += " " + quoted(hierarchy.skeleton.joints[static_cast<std::size_t>(roots[r])].name);
  }
  keep_tree(hierarchy, tree, kept);
  in.warn_at(0, "several ROOTs; " + quoted(hierarchy.skeleton.joints.front().name) +
                    " is the figure, left out:" + others);
}

}  // namespace promenade::motion
