#include "motion/body_names.h"

#include <algorithm>
#include <cctype>

namespace promenade::motion {
namespace {

enum class Side { none, left, right };

// A name without what is said of its side: "UpperLeg_L" is {"upperleg", left}.
struct PlainName {
  std::string word;
  Side side = Side::none;
};

bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_letter(char c) { return is_upper(c) || (c >= 'a' && c <= 'z'); }
char to_lower(char c) { return is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c; }

// "mixamorig:LHipJoint_2" gives l, hip, joint: what a colon ends names the actor,
// and numbers only count.
std::vector<std::string> tokens_of(std::string_view name) {
  const std::size_t colon = name.rfind(':');
  if (colon != name.npos) name.remove_prefix(colon + 1);
  std::vector<std::string> tokens;
  bool open = false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (!is_letter(c)) {
      open = false;
      continue;
    }
    const bool starts =
        is_upper(c) && ((i > 0 && !is_upper(name[i - 1])) ||
                        (i + 1 < name.size() && is_letter(name[i + 1]) && !is_upper(name[i + 1])));
    if (!open || starts) tokens.emplace_back();
    open = true;
    tokens.back().push_back(to_lower(c));
  }
  return tokens;
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

Side side_of(std::string_view token) {
  if (is_one_of(token, {"l", "left", "lft"})) return Side::left;
  if (is_one_of(token, {"r", "right", "rgt"})) return Side::right;
  return Side::none;
}

bool is_prefix_token(std::string_view token) {
  return is_one_of(token, {"mixamorig", "bip", "j", "b", "jnt", "skeleton", "character", "ctrl"});
}

PlainName plain(std::string_view name) {
  PlainName result;
  for (const std::string& token : tokens_of(name)) {
    if (const Side side = side_of(token); side != Side::none) {
      result.side = side;
    } else if (!is_prefix_token(token) || !result.word.empty()) {
      result.word += token;
    }
  }
  return result;
}

// The part of a limb, as if on the left.
std::optional<BodyJoint> limb_part(std::string_view word) {
  if (is_one_of(word, {"upleg", "upperleg", "thigh", "femur", "hip"})) return left_hip;
  if (is_one_of(word,
                {"leg", "lowerleg", "loleg", "lowleg", "shin", "shank", "calf", "tibia", "knee"})) {
    return left_knee;
  }
  if (is_one_of(word, {"foot", "ankle"})) return left_ankle;
  if (is_one_of(word, {"toe", "toes", "toebase", "ball", "balltoe", "foottoe"})) return left_toe;
  if (is_one_of(word, {"collar", "clavicle", "collarbone"})) return left_clavicle;
  if (is_one_of(word, {"upperarm", "uparm", "uarm", "arm", "humerus"})) return left_shoulder;
  if (is_one_of(word, {"forearm", "farm", "lowerarm", "loarm", "lowarm", "radius", "elbow"})) {
    return left_elbow;
  }
  if (is_one_of(word, {"hand", "wrist"})) return left_wrist;
  return std::nullopt;
}

// "lfemur": the side is the first letter of a word that is a part without it.
void split_glued_side(PlainName& name) {
  if (name.side != Side::none || name.word.size() < 4) return;
  const Side side = side_of(name.word.substr(0, 1));
  const std::string rest = name.word.substr(1);
  if (side == Side::none || !(limb_part(rest) || rest == "shoulder")) return;
  name = {rest, side};
}

std::size_t on_side(BodyJoint left_part, Side side) {
  static_assert(right_clavicle - left_clavicle == 4 && right_hip - left_hip == 4);
  return static_cast<std::size_t>(left_part + (side == Side::right ? 4 : 0));
}

void set_first(NamedJoints& found, std::size_t part, int joint) {
  if (found[part] < 0) found[part] = joint;
}

// A "shoulder" is the upper arm, or the clavicle where the arm has a name of its own.
void place_shoulders(NamedJoints& found, const std::array<int, 3>& shoulders) {
  for (const Side side : {Side::left, Side::right}) {
    const int joint = shoulders[static_cast<std::size_t>(side)];
    if (joint < 0) continue;
    const std::size_t shoulder = on_side(left_shoulder, side);
    set_first(found, found[shoulder] < 0 ? shoulder : on_side(left_clavicle, side), joint);
  }
}

}  // namespace

bool names_the_hips(std::string_view name) {
  const PlainName own = plain(name);
  return own.side == Side::none && is_one_of(own.word, {"hips", "hip", "pelvis"});
}

NamedJoints joints_by_name(const Skeleton& skeleton) {
  NamedJoints found;
  found.fill(-1);
  std::array<int, 3> shoulders = {-1, -1, -1};
  for (int j = 0; j < skeleton.size(); ++j) {
    PlainName name = plain(skeleton.joints[static_cast<std::size_t>(j)].name);
    split_glued_side(name);
    if (name.side == Side::none) {
      if (name.word == "neck" || name.word == "lowerneck") set_first(found, neck, j);
      if (name.word == "head") set_first(found, head, j);
    } else if (name.word == "shoulder") {
      int& shoulder = shoulders[static_cast<std::size_t>(name.side)];
      if (shoulder < 0) shoulder = j;
    } else if (const std::optional<BodyJoint> part = limb_part(name.word)) {
      set_first(found, on_side(*part, name.side), j);
    }
  }
  place_shoulders(found, shoulders);
  return found;
}

}  // namespace promenade::motion
