// `promenade graph distance`: how unlike two windows of frames are.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "app/commands/graph_parts.h"
#include "app/print.h"
#include "motion/body_mapping.h"
#include "motion/did_you_mean.h"
#include "motion/graph/window_distance.h"
#include "motion/load_clip.h"

namespace promenade::app {
namespace {

using motion::Clip;

struct Arguments {
  std::string a, b;
  int window = 0;
  std::string at;
  motion::LoadOptions load;
  bool json = false;
};

// A capture, and what could be found out about its figure.
struct Capture {
  Clip clip;
  std::optional<double> unit_m;  // metres per unit of the file
  std::optional<bool> z_up;
};

struct At {
  int i = 0, j = 0;
};

Capture look_at(Clip clip) {
  Capture capture = {std::move(clip), std::nullopt, std::nullopt};
  try {
    const motion::Figure figure = motion::find_figure(capture.clip);
    capture.unit_m = figure.unit_m;
    capture.z_up = figure.z_up;
  } catch (const InputError&) {  // no walking body: joints can be compared all the same
    capture.unit_m = capture.clip.unit_m;
  }
  return capture;
}

std::vector<std::string> joint_names(const Clip& clip) {
  std::vector<std::string> names;
  for (const motion::Joint& joint : clip.skeleton.joints) names.push_back(joint.name);
  return names;
}

// Where a joint of B is in A, or what it may be called there.
std::string instead(const std::string& name, const std::vector<std::string>& wanted) {
  const auto found = std::find(wanted.begin(), wanted.end(), name);
  if (found == wanted.end()) return did_you_mean(name, wanted);
  return "; it is joint " + std::to_string(found - wanted.begin() + 1) + " there";
}

class Comparison {
 public:
  Comparison(const Capture& a, const Capture& b) : a_(a), b_(b) {
    compare_joints();
    if (a.unit_m && b.unit_m) compare_numbers("a unit of", *a.unit_m, *b.unit_m, "m", 1e-6);
    // Frame times are printed with few digits.
    compare_numbers("frames of", a.clip.frame_time, b.clip.frame_time, "s", 5e-4);
    if (a.z_up && b.z_up && *a.z_up != *b.z_up) {
      add("has " + axis(b) + " up, where " + a.clip.file + " has " + axis(a));
    }
  }

  std::vector<Problem> problems() const { return problems_; }

 private:
  static std::string axis(const Capture& capture) { return *capture.z_up ? "Z" : "Y"; }

  void add(std::string message) {
    problems_.push_back({b_.clip.file, 0, 0, std::move(message), Severity::error});
  }

  void compare_joints() {
    constexpr std::size_t most_named = 10;
    const std::vector<std::string> a = joint_names(a_.clip), b = joint_names(b_.clip);
    if (a.size() != b.size()) {
      add("has " + std::to_string(b.size()) + " joints, where " + a_.clip.file + " has " +
          std::to_string(a.size()) + "; both need the same joints in the same order");
    }
    std::size_t different = 0;
    for (std::size_t j = 0; j < std::min(a.size(), b.size()); ++j) {
      if (a[j] == b[j]) continue;
      if (++different > most_named) continue;
      add("joint " + std::to_string(j + 1) + " is \"" + b[j] + "\", where " + a_.clip.file +
          " has \"" + a[j] + "\"" + instead(b[j], a));
    }
    if (different > most_named) {
      add("has " + std::to_string(different - most_named) + " more joints that differ");
    }
  }

  void compare_numbers(const std::string& what, double a, double b, const std::string& unit,
                       double tolerance) {
    if (std::abs(a - b) <= tolerance * std::max(a, b)) return;
    add("has " + what + " " + Json(b).dump() + " " + unit + ", where " + a_.clip.file + " has " +
        Json(a).dump() + " " + unit);
  }

  const Capture& a_;
  const Capture& b_;
  std::vector<Problem> problems_;
};

std::vector<Capture> load_both(const Arguments& given) {
  std::vector<Capture> captures;
  std::vector<Problem> problems;
  for (const std::string& file : {given.a, given.b}) {
    try {
      captures.push_back(look_at(motion::load_clip(file, given.load)));
    } catch (const InputError& error) {
      problems.insert(problems.end(), error.problems().begin(), error.problems().end());
      if (given.a == given.b) break;
    }
  }
  if (!problems.empty()) throw InputError(problems);
  return captures;
}

bool read_whole(std::string_view word, int& number) {
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && stop == word.data() + word.size();
}

At read_at(const std::string& text) {
  At at;
  const std::size_t comma = text.find(',');
  const std::string_view words = text;
  if (comma == std::string::npos || !read_whole(words.substr(0, comma), at.i) ||
      !read_whole(words.substr(comma + 1), at.j)) {
    throw InputError("--at", "'" + text +
                                 "' is not two numbers of frames: i,j is wanted, the first frame "
                                 "of A's window and the last of B's, counted from 0, as in 0,39");
  }
  return at;
}

// What is wrong with a window that begins or ends at `frame` of a take, which must lie from
// `least` on.
void check_frame(const Clip& clip, int window, const char* name, int frame, int least,
                 std::vector<Problem>& problems) {
  const int most = least + clip.frames() - window;
  if (clip.frames() < window) {
    problems.push_back({clip.file, 0, 0,
                        "has " + std::to_string(clip.frames()) +
                            " frames, too few for a window of " + std::to_string(window),
                        Severity::error});
  } else if (frame < least || frame > most) {
    problems.push_back({clip.file, 0, 0,
                        std::string("has no window of ") + std::to_string(window) + " frames at " +
                            name + " = " + std::to_string(frame) + "; " + name + " can be " +
                            std::to_string(least) + " to " + std::to_string(most),
                        Severity::error});
  }
}

void check(const Capture& a, const Capture& b, int window, const At& at) {
  std::vector<Problem> problems = Comparison(a, b).problems();
  check_frame(a.clip, window, "i", at.i, 0, problems);
  check_frame(b.clip, window, "j", at.j, window - 1, problems);
  if (!problems.empty()) throw InputError(problems);
}

motion::WindowDistance measure(const Capture& a, const Capture& b, int window, const At& at) {
  const bool z_up = a.z_up.value_or(b.z_up.value_or(false));
  const motion::Clouds first = motion::joint_clouds(a.clip, z_up, at.i, window);
  const motion::Clouds second = motion::joint_clouds(b.clip, z_up, at.j - window + 1, window);
  const std::vector<double> taper(static_cast<std::size_t>(window), 1.0);
  const auto distance = motion::window_distance(first, 0, second, window - 1, taper);
  if (!std::isfinite(distance.sum)) {
    throw InputError(a.clip.file, "or " + b.clip.file + " has points too far away to measure");
  }
  return distance;
}

void show_distance(const Arguments& given) {
  const At at = read_at(given.at);
  const std::vector<Capture> captures = load_both(given);
  const Capture &a = captures[0], &b = captures[1];
  check(a, b, given.window, at);
  const motion::WindowDistance distance = measure(a, b, given.window, at);
  std::optional<double> rms_m;
  if (const auto unit = a.unit_m ? a.unit_m : b.unit_m) rms_m = distance.rms() * *unit;
  const motion::PlanarMove& move = distance.move;
  const int points = given.window * a.clip.skeleton.size();
  if (given.json) {
    return print_json({{"distance", distance.sum},
                       {"theta", move.theta},
                       {"x0", move.x0},
                       {"z0", move.z0},
                       {"rms_m", to_json(rms_m)},
                       {"points", points},
                       {"window", given.window}});
  }
  std::printf(
      "%s, %d points: turned by %.1f degrees and moved by (%.4g, %.4g), sum of squares %.6g\n",
      rms_m ? (Json(std::round(*rms_m * 1e5) / 1e2).dump() + " mm apart").c_str() : "unit unknown",
      points, move.theta * 180 / M_PI, move.x0, move.z0, distance.sum);
}

}  // namespace

void add_graph_distance(Command graph_command) {
  Command command = graph_command.add_subcommand(
      "distance", "How unlike two windows of frames are, one turned and moved onto the other");
  const auto given = std::make_shared<Arguments>();
  command.add_option("a", given->a, "A capture (.bvh, .amc)").required();
  command.add_option("b", given->b, "A capture with the same joints; it may be the same one")
      .required();
  command.add_option("--window", given->window, "Frames of a window").required().range(1, 1000000);
  command.add_option("--at", given->at, "i,j: the first frame of A's window, the last of B's")
      .required();
  command.add_option("--skeleton", given->load.skeleton,
                     "The .asf file of .amc files; looked for beside them if not given");
  command
      .add_option("--rate", given->load.rate,
                  "Frames a second of an .amc, which does not say it; 120 if not given")
      .range(1.0, 10000.0);
  command.add_flag("--json", given->json, "One JSON document on stdout");
  command.callback([given] { show_distance(*given); });
}

}  // namespace promenade::app
