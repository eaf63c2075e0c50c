#include "motion/did_you_mean.h"

#include <algorithm>

namespace promenade {

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<int> before_last(b.size() + 1);
  std::vector<int> last(b.size() + 1);
  std::vector<int> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

namespace {

// What files hold must not cost more than it is worth.
constexpr std::size_t longest_name = 80;
constexpr std::size_t most_candidates = 2000;

std::string lower(std::string_view word) {
  std::string text(word);
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

std::size_t common_beginning(std::string_view a, std::string_view b) {
  const std::size_t length = std::min(a.size(), b.size());
  return static_cast<std::size_t>(std::mismatch(a.begin(), a.begin() + length, b.begin()).first -
                                  a.begin());
}

}  // namespace

std::string closest_name(std::string_view name, const std::vector<std::string>& candidates) {
  std::string best;
  if (name.size() > longest_name) return best;
  int least = std::max(1, static_cast<int>(name.size()) / 3);
  const std::size_t count = std::min(candidates.size(), most_candidates);
  for (std::size_t c = 0; c < count; ++c) {
    const std::string& candidate = candidates[c];
    if (candidate.size() > longest_name) continue;
    const int distance = edit_distance(name, candidate);
    if (distance > least) continue;
    const bool equal = distance == least && !best.empty();
    if (equal && common_beginning(name, candidate) <= common_beginning(name, best)) continue;
    least = distance;
    best = candidate;
  }
  return best;
}

std::string closest_name_of_any_case(std::string_view name,
                                     const std::vector<std::string>& candidates) {
  std::vector<std::string> lower_candidates;
  for (const std::string& candidate : candidates) lower_candidates.push_back(lower(candidate));
  const std::string found = closest_name(lower(name), lower_candidates);
  const auto at = std::find(lower_candidates.begin(), lower_candidates.end(), found);
  if (found.empty() || at == lower_candidates.end()) return "";
  return candidates[static_cast<std::size_t>(at - lower_candidates.begin())];
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates) {
  const std::string best = closest_name(name, candidates);
  return best.empty() ? "" : "; did you mean \"" + best + "\"?";
}

std::string quoted_list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "\"" : ", \"") + name + "\"";
  return text;
}

}  // namespace promenade
