// What every page of the desk may ask of the desk.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/desk/job.h"
#include "app/desk/shelf_watch.h"
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
  bool failed() const;
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
  void tell(const std::string& trouble) { trouble_ = trouble; }
  void dismiss();  // what ended is seen
  const std::string& trouble() const { return trouble_; }

 private:
  std::string program_, trouble_;
  std::vector<DeskJob> jobs_;
};

struct DeskServices {
  DeskJobs& jobs;
  study::StudyShelf& shelf;           // to change it
  ShelfWatch& studies;                // to look at it
  std::vector<std::string> displays;  // "1: DP-1, 1920 x 1080", for the participant's window
  // Where participants' windows open: one of the displays; beyond them, in a window.
  std::size_t display = 0;
  std::function<void(const study::StudyPlace& study)> open;  // to work on it
  std::function<void(DeskPlace place)> go;
  // With the program of the system that is meant for it: a report in the browser.
  std::function<void(const std::string& path)> show;

  // Has the desk something open that a study's folder must stay for: changes that are not saved, a
  // command that runs?
  std::function<bool(const study::StudyPlace& study)> in_use;
  std::function<void(const study::StudyPlace& from, const study::StudyPlace& to)> renamed;

  // A session runs on this machine, whoever started it.
  bool session_runs() const { return jobs.session() || studies.session_lives(); }
  // Nothing runs that a session, or a window of its own, would be disturbed by.
  bool screen_is_free() const { return !session_runs() && !jobs.quiet() && !jobs.busy(); }
  // Work in the background may begin.
  bool may_work() const { return !jobs.busy() && !session_runs(); }

  // The options of a command for that display: "--screen" and its number, or "--windowed".
  std::vector<std::string> display_options() const;
};

}  // namespace promenade::app
