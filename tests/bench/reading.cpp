// Reading captures: text to channels, and on to rotations. The texts are generated in the
// ways of public captures; real ones are read too where they are at hand (../shared/data,
// or the folder that $PROMENADE_DATA names). Run: build/release/tests/bench_reading
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "motion/amc.h"
#include "motion/bvh.h"
#include "motion/files.h"
#include "motion/load_clip.h"
#include "tests/motion/models/random.h"
#include "tests/source_dir.h"

namespace promenade::motion {
namespace {

namespace fs = std::filesystem;

std::string number_text(const char* format, double value) {
  char text[40];
  const int size = std::snprintf(text, sizeof text, format, value);
  return {text, static_cast<std::size_t>(size)};
}

// A chain of joints with six channels each, or three below the root.
std::string bvh_header(int joints, bool six) {
  std::string text = "HIERARCHY\n", end;
  for (int j = 0; j < joints; ++j) {
    text += (j == 0 ? "ROOT j" : "JOINT j") + std::to_string(j) + "\n{\nOFFSET 0 0.1 0\n";
    text += j == 0 || six ? "CHANNELS 6 Xposition Yposition Zposition" : "CHANNELS 3";
    text += " Zrotation Xrotation Yrotation\n";
    end += "}\n";
  }
  return text + end;
}

std::string bvh_of(int joints, bool six, int frames, const char* format, std::uint64_t seed) {
  Random random(seed);
  std::string text = bvh_header(joints, six);
  text += "MOTION\nFrames: " + std::to_string(frames) + "\nFrame Time: 0.0333333\n";
  const int channels = six ? 6 * joints : 3 + 3 * joints;
  for (int f = 0; f < frames; ++f) {
    for (int c = 0; c < channels; ++c) {
      text += number_text(format, 360 * random.uniform() - 180) + (c + 1 < channels ? " " : "\n");
    }
  }
  return text;
}

// 18.6 MB in 55 files of 22 joints with six channels.
const std::vector<std::string>& walks() {
  static const std::vector<std::string> texts = [] {
    std::vector<std::string> made;
    for (std::uint64_t i = 0; i < 55; ++i) made.push_back(bvh_of(22, true, 293, "%g", i + 1));
    return made;
  }();
  return texts;
}

std::int64_t bytes_of(const std::vector<std::string>& texts) {
  std::int64_t sum = 0;
  for (const std::string& text : texts) sum += static_cast<std::int64_t>(text.size());
  return sum;
}

void all_rotations(const Clip& clip, LocalPose& pose) {
  for (int f = 0; f < clip.frames(); ++f) {
    local_pose(clip, f, pose);
    benchmark::DoNotOptimize(pose.rotations.data());
  }
}

void text_to_channels(benchmark::State& state, const char* format) {
  const std::string text = bvh_of(31, false, 2000, format, 1);
  for (auto _ : state) benchmark::DoNotOptimize(read_bvh(text, "x").values.data());
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}
BENCHMARK_CAPTURE(text_to_channels, six_digits, "%g")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(text_to_channels, four_decimals, "%.4f")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(text_to_channels, six_decimals, "%.6f")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(text_to_channels, fifteen_digits, "%.15g")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(text_to_channels, seventeen_digits, "%.17g")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(text_to_channels, exponents, "%.6e")->Unit(benchmark::kMillisecond);

void walks_from_memory(benchmark::State& state) {
  walks();  // made before the clock runs
  LocalPose pose;
  for (auto _ : state) {
    for (const std::string& text : walks()) {
      const Clip clip = read_bvh(text, "x");
      if (state.range(0) == 1) all_rotations(clip, pose);
      benchmark::DoNotOptimize(clip.values.data());
    }
  }
  state.SetBytesProcessed(state.iterations() * bytes_of(walks()));
}
BENCHMARK(walks_from_memory)->ArgName("rotations")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

// A folder that goes away at the end.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("promenade_bench_" + std::to_string(::getpid()))) {
    for (std::size_t i = 0; i < walks().size(); ++i) {
      files_.push_back(path_ / (std::to_string(i) + ".bvh"));
      write_file(files_.back(), walks()[i]);
    }
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const std::vector<fs::path>& files() const { return files_; }

 private:
  fs::path path_;
  std::vector<fs::path> files_;
};

void load(benchmark::State& state, const std::vector<fs::path>& files) {
  LocalPose pose;
  std::int64_t bytes = 0;
  for (const fs::path& file : files) bytes += static_cast<std::int64_t>(fs::file_size(file));
  for (auto _ : state) {
    for (const fs::path& file : files) all_rotations(load_clip(file), pose);
  }
  state.SetBytesProcessed(state.iterations() * bytes);
}

void walks_from_disk_with_rotations(benchmark::State& state) { load(state, Folder().files()); }
BENCHMARK(walks_from_disk_with_rotations)->Unit(benchmark::kMillisecond);

void captures_from_disk_with_rotations(benchmark::State& state) {
  const char* named = std::getenv("PROMENADE_DATA");
  const fs::path folder =
      named && *named ? fs::path(named) : source_dir() / "../shared/data";
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const fs::path ending = entry->path().extension();
    if (ending == ".bvh" || ending == ".amc") files.push_back(entry->path());
  }
  if (files.empty()) return state.SkipWithError("there are no captures; set PROMENADE_DATA");
  load(state, files);
}
BENCHMARK(captures_from_disk_with_rotations)->Unit(benchmark::kMillisecond);

// 30 bones of three degrees of freedom below the root, as .asf and .amc.
void acclaim_to_channels(benchmark::State& state) {
  std::string asf = ":root\norder TX TY TZ RX RY RZ\n:bonedata\n", tree = ":hierarchy\nbegin\n";
  std::string amc = ":DEGREES\n";
  for (int b = 0; b < 30; ++b) {
    const std::string name = "bone" + std::to_string(b);
    asf += "begin name " + name + "\ndirection 0 1 0 length 1 axis 0 0 20 XYZ\ndof rx ry rz\nend\n";
    tree += (b == 0 ? "root" : "bone" + std::to_string(b - 1)) + " " + name + "\n";
  }
  Random random(1);
  for (int f = 1; f <= 2000; ++f) {
    amc += std::to_string(f) + "\nroot 1.5 2.5 3.5 0 0 0\n";
    for (int b = 0; b < 30; ++b) {
      amc += "bone" + std::to_string(b);
      for (int c = 0; c < 3; ++c) amc += " " + number_text("%g", 90 * random.uniform());
      amc += "\n";
    }
  }
  const AsfSkeleton skeleton = read_asf(asf + tree + "end\n", "x");
  for (auto _ : state) benchmark::DoNotOptimize(read_amc(amc, "y", skeleton).values.data());
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(amc.size()));
}
BENCHMARK(acclaim_to_channels)->Unit(benchmark::kMillisecond);

void channels_to_text(benchmark::State& state) {
  const Clip clip = read_bvh(bvh_of(31, false, 2000, "%.4f", 1), "x");
  std::int64_t bytes = 0;
  for (auto _ : state) bytes += static_cast<std::int64_t>(bvh_text(clip).size());
  state.SetBytesProcessed(bytes);
}
BENCHMARK(channels_to_text)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace promenade::motion
