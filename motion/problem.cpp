#include "motion/problem.h"

namespace promenade {

std::string to_text(const Problem& problem) {
  std::string text = problem.file;
  if (problem.line > 0) text += ":" + std::to_string(problem.line);
  if (problem.line > 0 && problem.column > 0) text += ":" + std::to_string(problem.column);
  text += problem.severity == Severity::error ? ": error: " : ": warning: ";
  return text + problem.message;
}

bool has_error(const std::vector<Problem>& problems) {
  for (const Problem& problem : problems) {
    if (problem.severity == Severity::error) return true;
  }
  return false;
}

namespace {

std::string all_lines(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    if (!text.empty()) text += '\n';
    text += to_text(problem);
  }
  return text;
}

}  // namespace

InputError::InputError(std::vector<Problem> problems)
    : std::runtime_error(all_lines(problems)), problems_(std::move(problems)) {}

InputError::InputError(std::string file, std::string message)
    : InputError(std::vector<Problem>{{std::move(file), 0, 0, std::move(message), {}}}) {}

}  // namespace promenade
