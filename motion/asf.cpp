#include "motion/asf.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "motion/angles.h"
#include "motion/asf_sections.h"
#include "motion/degrees.h"

namespace promenade::motion {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

std::string lower(std::string_view word) {
  std::string text(word);
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

Quaterniond rotation_of(const AsfTurns& turns, bool radians) {
  Quaterniond rotation = Quaterniond::Identity();
  for (std::size_t i = 0; i < 3; ++i) {
    const double degrees = radians ? turns.angle[i] * (180 / pi) : turns.angle[i];
    const SineCosine half = sine_cosine_of_degrees(0.5 * degrees);
    Quaterniond step(half.cosine, 0, 0, 0);
    step.vec()(turns.axis[i]) = half.sine;
    rotation = step * rotation;
  }
  return rotation;
}

// Bones as joints: the root, then every bone behind its parent.
class Assembler {
 public:
  Assembler(const AsfSections& sections, Scanner& in) : sections_(sections), in_(in) {}

  void assemble(AsfSkeleton& result) {
    name_bones();
    find_children();
    if (in_.failed()) in_.give_up();
    add_root(result);
    std::vector<std::pair<int, int>> open = next_of(0, 0);  // bone, joint of its parent
    while (!open.empty()) {
      const auto [bone, parent] = open.back();
      open.pop_back();
      const int joint = add_bone(bone, parent, result);
      const auto children = next_of(bone, joint);
      open.insert(open.end(), children.begin(), children.end());
    }
    name_the_loose();
    if (in_.failed()) in_.give_up();
  }

 private:
  // Bone 0 is the root, bone b stands at b - 1 in the file.
  const AsfBone& bone_at(int bone) const {
    return sections_.bones[static_cast<std::size_t>(bone) - 1];
  }

  void name_bones() {
    numbers_["root"] = 0;
    for (const AsfBone& bone : sections_.bones) {
      const int number = static_cast<int>(numbers_.size());
      if (!numbers_.emplace(lower(bone.name), number).second) {
        in_.error_at(bone.place, "a second bone named " + quoted(bone.name));
        if (in_.full()) break;
      }
    }
    if (in_.failed()) in_.give_up();
    children_.resize(sections_.bones.size() + 1);
    parent_.assign(sections_.bones.size() + 1, -1);
  }

  int find(std::string_view name, std::size_t place) {
    const auto found = numbers_.find(lower(name));
    if (found != numbers_.end()) return found->second;
    if (!in_.full())
      in_.error_at(place, quoted(name) + " is no bone of :bonedata" + meant(name, bone_names()));
    return -1;
  }

  std::vector<std::string> bone_names() const {
    std::vector<std::string> names = {"root"};
    for (const AsfBone& bone : sections_.bones) names.push_back(bone.name);
    return names;
  }

  void find_children() {
    for (const AsfFamily& family : sections_.families) {
      const int parent = find(family.parent, family.place);
      for (std::size_t c = 0; c < family.children.size(); ++c) {
        add_child(parent, find(family.children[c], family.places[c]), family.places[c]);
      }
    }
  }

  void add_child(int parent, int child, std::size_t place) {
    if (parent < 0 || child < 0 || in_.full()) return;
    if (child == 0) return in_.error_at(place, "the root cannot hang from a bone");
    const std::string name = quoted(bone_at(child).name);
    int& known = parent_[static_cast<std::size_t>(child)];
    if (known >= 0) return in_.error_at(place, "bone " + name + " has a second parent");
    known = parent;
    children_[static_cast<std::size_t>(parent)].push_back(child);
  }

  // The children of a bone, the first at the end.
  std::vector<std::pair<int, int>> next_of(int bone, int joint) const {
    std::vector<std::pair<int, int>> next;
    for (const int child : children_[static_cast<std::size_t>(bone)]) {
      next.emplace_back(child, joint);
    }
    std::reverse(next.begin(), next.end());
    return next;
  }

  // The motion turns about fixed axes what the orientation has turned before.
  void add_root(AsfSkeleton& result) const {
    result.root_position = sections_.root_position;
    result.skeleton.joints.push_back({"root", -1, sections_.root_position});
    result.axes.push_back(
        {Quaterniond::Identity(), rotation_of(sections_.root_orientation, sections_.radians)});
    add_channels(sections_.root_order, result);
    if (!sections_.root_position.isZero() || !result.axes[0].after.vec().isZero()) {
      in_.warn_at(0,
                  "the root has a position or orientation of its own, which comes before "
                  "the motion here; other programs may leave it out");
    }
  }

  static void add_channels(const std::vector<Channel>& channels, AsfSkeleton& result) {
    result.channels.push_back({channels, result.rows});
    result.rows += static_cast<int>(channels.size());
  }

  static Vector3d tip(const AsfBone& bone) { return bone.length * bone.direction; }

  int add_bone(int bone, int parent_joint, AsfSkeleton& result) {
    const AsfBone& own = bone_at(bone);
    const int parent = parent_[static_cast<std::size_t>(bone)];
    const int joint = result.skeleton.size();
    const Vector3d start = parent == 0 ? Vector3d::Zero() : tip(bone_at(parent));
    result.skeleton.joints.push_back({own.name, parent_joint, start});
    const Quaterniond axes = rotation_of(own.axis, sections_.radians);
    result.axes.push_back({axes, axes.conjugate()});
    add_channels(own.channels, result);
    if (children_[static_cast<std::size_t>(bone)].empty()) {
      result.skeleton.end_sites.push_back({joint, tip(own)});
    }
    reached_ += 1;
    return joint;
  }

  // Bones without a parent, or below one another in a ring.
  void name_the_loose() {
    if (reached_ == sections_.bones.size()) return;
    for (std::size_t b = 0; b < sections_.bones.size() && !in_.full(); ++b) {
      const AsfBone& bone = sections_.bones[b];
      if (parent_[b + 1] < 0) {
        in_.error_at(bone.place, "bone " + quoted(bone.name) + " hangs nowhere in :hierarchy");
      }
    }
    if (!in_.failed()) in_.error("bones of :hierarchy hang from one another in a ring");
  }

  const AsfSections& sections_;
  Scanner& in_;
  std::unordered_map<std::string, int> numbers_;  // by name in lower case
  std::vector<std::vector<int>> children_;
  std::vector<int> parent_;
  std::size_t reached_ = 0;
};

}  // namespace

AsfSkeleton read_asf(std::string_view text, const std::string& file) {
  Scanner in(text, file, Punctuation::acclaim);
  if (in.at_end()) in.refuse("the file is empty");
  const AsfSections sections = read_asf_sections(in);
  if (sections.bones.empty()) in.refuse("the file has no bones");
  AsfSkeleton result;
  result.file = file;
  result.radians = sections.radians;
  if (sections.length > 0) result.unit_m = 0.0254 / sections.length;
  Assembler(sections, in).assemble(result);
  if (result.rows == 0) in.refuse("no bone has a degree of freedom: nothing can move");
  result.warnings = in.warnings();
  return result;
}

}  // namespace promenade::motion
