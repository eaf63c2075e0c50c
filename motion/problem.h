// What can be wrong with input, said in one form everywhere: a place, a
// sentence, and a way out. Readers collect all problems of a file before they
// give up, so that one run names them all.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace promenade {

enum class Severity { error, warning };

struct Problem {
  std::string file;     // as the user named it
  int line = 0;         // from 1; 0: the file as a whole
  int column = 0;       // from 1; 0: the line as a whole
  std::string message;  // lower case, no full stop; may end in a way out
  Severity severity = Severity::error;
};

// "FILE:LINE:COLUMN: error: MESSAGE", without the parts that are 0.
std::string to_text(const Problem& problem);

bool has_error(const std::vector<Problem>& problems);

// The input is wrong or missing: exit code 2. Holds at least one problem.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Problem> problems);
  InputError(std::string file, std::string message);
  const std::vector<Problem>& problems() const { return problems_; }

 private:
  std::vector<Problem> problems_;
};

// The outside world refused (disk, display, database): exit code 1. The text is
// one sentence that says what and what to do.
class OutsideError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace promenade
