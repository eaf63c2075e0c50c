// What every page of the desk may ask of the desk.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/desk/job.h"
#include "study/study_shelf.h"

namespace promenade::app {

// Where one can be: the first two without a study.
enum class DeskPlace { studies, takes, edit, plan, rehearse, run, watch, results };
inline constexpr std::size_t desk_places = 8;
std::string_view to_text(DeskPlace place);

// work: in the background; screen: in a window of its own, beside which the desk is quiet; session:
// a person's, likewise, and it outlives the desk.
enum class JobKind { work, screen, session };

// A command that runs, or ran, for somebody to see in the foot of the desk.
struct DeskJob {
  std::string name;  // "Simulating", for people
  std::unique_ptr<Job> job;
  // Called once, when it has ended.
  std::function<void(const Job& job)> ended;
  JobKind kind = JobKind::work;
  bool told = false;
};

class DeskJobs {
 public:
  explicit DeskJobs(std::string program = own_program()) : program_(std::move(program)) {}
  ~DeskJobs();  // stops what is no session

  // Starts it. One that cannot be started is told as one that failed.
  void start(const std::string& name, const std::vector<std::string>& arguments,
             std::function<void(const Job& job)> ended = {}, JobKind kind = JobKind::work);
  void look();
  // The one to be seen: what runs, else what ended last; null: none.
  const DeskJob* shown() const;
  bool busy() const;     // something runs that is no session
  bool session() const;  // a session runs
  bool quiet() const;    // something runs in a window of its own
  void stop_shown();
  void dismiss();  // what ended is seen
  const std::string& trouble() const { return trouble_; }

 private:
  std::string program_, trouble_;
  std::vector<DeskJob> jobs_;
};

struct DeskServices {
  DeskJobs& jobs;
  study::StudyShelf& shelf;
  std::vector<std::string> displays;  // "1: DP-1, 1920 x 1080", for the participant's window
  // Where participants' windows open: one of the displays; beyond them, in a window.
  std::size_t display = 0;
  std::function<void(const study::StudyPlace& study)> open;  // to work on it
  std::function<void(DeskPlace place)> go;
  // With the program of the system that is meant for it: a report in the browser.
  std::function<void(const std::string& path)> show;

  // The options of a command for that display: "--screen" and its number, or "--windowed".
  std::vector<std::string> display_options() const;
};

}  // namespace promenade::app
