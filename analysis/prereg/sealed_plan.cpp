#include "analysis/prereg/sealed_plan.h"

#include <algorithm>
#include <array>
#include <optional>

#include "motion/problem.h"
#include "study/identity.h"

namespace promenade::analysis {
namespace {

constexpr std::string_view shortest_fence = "~~~~";

std::optional<std::string_view> between(std::string_view text, std::string_view begin,
                                        std::string_view end) {
  const std::size_t last = text.rfind(end);
  if (last == std::string_view::npos) return std::nullopt;
  const std::size_t first = text.rfind(begin, last);
  if (first == std::string_view::npos || first + begin.size() > last) return std::nullopt;
  return text.substr(first + begin.size(), last - first - begin.size());
}

std::string unescaped(std::string_view html) {
  constexpr auto entities = std::to_array<std::pair<std::string_view, char>>(
      {{"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&#39;", '\''}, {"&amp;", '&'}});
  std::string text;
  while (!html.empty()) {
    const auto found = std::find_if(entities.begin(), entities.end(), [&](const auto& one) {
      return html.substr(0, one.first.size()) == one.first;
    });
    text += found == entities.end() ? html[0] : found->second;
    html.remove_prefix(found == entities.end() ? 1 : found->first.size());
  }
  return text;
}

// The block between the last two lines of tildes that are equally long.
std::optional<std::string> last_fenced(std::string_view document) {
  const std::size_t last = document.rfind("\n" + std::string(shortest_fence));
  if (last == std::string_view::npos) return std::nullopt;
  std::string fence(document.substr(last + 1));
  fence = fence.substr(0, fence.find_first_not_of('~'));
  const std::string begin = "\n" + fence + "\n";
  const std::size_t first = document.rfind(begin, last - 1);
  if (first == std::string_view::npos || first >= last) return std::nullopt;
  const std::size_t start = first + begin.size();
  return std::string(document.substr(start, last + 1 - start));
}

std::optional<std::string> plan_block(std::string_view document) {
  if (document.substr(0, 2) != "<!") return last_fenced(document);
  const auto block = between(document, "<pre>", "</pre>");
  return block ? std::optional(unescaped(*block)) : std::nullopt;
}

}  // namespace

std::string fence_for(std::string_view text) {
  std::string fence(shortest_fence);
  while (text.find(fence) != std::string_view::npos) fence += '~';
  return fence;
}

std::string plan_text_in(const std::string& file, std::string_view document) {
  const auto block = plan_block(document);
  if (!block) {
    throw InputError(file, "holds no plan; name a document that `promenade prereg` wrote");
  }
  // A plan whose last line had no end got one in the block.
  for (std::string plan : {*block, block->substr(0, block->empty() ? 0 : block->size() - 1)}) {
    if (document.find(study::sha256_hex(plan)) != std::string_view::npos) return plan;
  }
  throw InputError(file,
                   "was changed after `promenade prereg` wrote it: its plan has another hash");
}

}  // namespace promenade::analysis
