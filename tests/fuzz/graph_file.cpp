// Any bytes as a motion graph: refused, or a graph that can be written again and walked. A good
// checksum is put over the bytes, or the fuzzer would never get past it.
#include "motion/graph/graph_file.h"

#include <cstdint>
#include <cstdlib>
#include <string>

#include "motion/graph/graph_walk.h"
#include "motion/skeleton_bytes.h"

namespace {

using namespace promenade;

constexpr std::size_t head = 28;  // magic, version, size, checksum

std::string resealed(const std::string& bytes) {
  if (bytes.size() < head) return bytes;
  return motion::sealed("PROMGRAF", 1, bytes.substr(head));
}

void read(const std::string& bytes) {
  const motion::MotionGraph graph = motion::graph_from_bytes(bytes, "fuzz.graph");
  if (motion::to_bytes(graph) != bytes) std::abort();
  motion::edge_courses(graph);
  const auto edges = std::min<std::size_t>(graph.edges.size(), 20);
  for (std::size_t e = 0; e < edges; ++e) {
    const std::vector<int> walk = {static_cast<int>(e)};
    motion::walk_take(graph, {walk, motion::start_at_origin(graph, walk)});
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    read(resealed({reinterpret_cast<const char*>(data), size}));
  } catch (const InputError&) {
    // Refused with a place and a reason: that is what should happen.
  }
  return 0;
}
