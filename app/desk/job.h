// A command of this program that runs beside the desk, in a process of its own: it can fail, be
// stopped or be killed, and the desk goes on; the desk can die, and a participant's session goes
// on. What it prints goes to files without a name, so that neither waits for the other.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace promenade::app {

struct JobProgress {
  std::string doing;  // "simulated"; empty: nothing was told yet
  int done = 0, count = 0;
};

class Job {
 public:
  // Starts `program` with these words. Throws OutsideError when it cannot be started.
  Job(const std::string& program, const std::vector<std::string>& arguments);
  ~Job();  // lets it go on; see stop()
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  // Reads what is new; never waits.
  void look();
  // Asks it to end as Ctrl-C does; asked again, more firmly.
  void stop();

  bool running() const { return !exit_code_; }
  // Of a program that was killed: 128 and the signal's number.
  std::optional<int> exit_code() const { return exit_code_; }
  bool stopped() const { return stops_ > 0; }  // was asked to
  const JobProgress& progress() const { return progress_; }
  const std::string& output() const { return output_; }      // what it printed, so far
  const std::string& messages() const { return messages_; }  // to people, without progress
  pid_t process() const { return process_; }

 private:
  void read_output();
  void read_messages();

  std::string output_, messages_, unfinished_line_;
  pid_t process_ = 0;
  int output_file_ = -1, message_file_ = -1;
  std::size_t messages_read_ = 0;
  int stops_ = 0;
  std::optional<int> exit_code_;
  JobProgress progress_;
};

// The file of this very program.
std::string own_program();

}  // namespace promenade::app
