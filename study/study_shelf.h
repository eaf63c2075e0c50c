// A folder of studies, as the desk lists them. Each has a folder of its own with its file,
// study.toml, what that names, and all that its sessions make:
//
//   SHELF/Walks of spring/study.toml       the study
//                         sessions.db      people and pilots
//                         rehearsal.db     simulated people
//                         report/ ...      made from these, and can be made again
//
// The folder's name is what people call the study; [study] name is what its databases call it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "study/file_stamp.h"

namespace promenade::study {

// Where all that belongs to one study lies.
struct StudyPlace {
  std::filesystem::path folder;

  std::filesystem::path file() const { return folder / "study.toml"; }
  std::filesystem::path sessions() const { return folder / "sessions.db"; }
  std::filesystem::path rehearsal() const { return folder / "rehearsal.db"; }
  // Of several stations, joined; made of sessions() and theirs.
  std::filesystem::path merged() const { return folder / "merged.db"; }
  std::filesystem::path roster() const { return folder / "roster.csv"; }
  std::filesystem::path exclusions() const { return folder / "exclusions.csv"; }
  std::filesystem::path report() const { return folder / "report"; }
  std::filesystem::path rehearsal_report() const { return folder / "rehearsal-report"; }
  std::filesystem::path data() const { return folder / "data"; }
  std::filesystem::path public_data() const { return folder / "public-data"; }
  std::string name() const { return folder.filename().string(); }
};

// Of the study's file and those beside it, by their names; not of databases.
std::map<std::string, FileStamp> stamps_of_files(const StudyPlace& place);

// draft: nobody has taken part; piloted: pilots only; running: people who count have begun;
// finished: as many as were planned are done.
enum class StudyState { draft, piloted, running, finished };
std::string_view to_text(StudyState state);

struct ShelvedStudy {
  StudyPlace place;
  StudyState state = StudyState::draft;
  int planned = 0;           // people; 0: not said
  int finished = 0;          // people who count
  int pilots = 0;            // sessions that were finished
  int open = 0;              // sessions that nobody has ended: they run, or can be resumed
  int live = 0;              // of these: a program of this machine runs them now
  std::string last_run_utc;  // when a session last began; empty: none did
  std::string problem;       // why its file or its sessions cannot be read; empty: they can
};

class StudyShelf {
 public:
  // Made when it is not there, with the first study.
  explicit StudyShelf(std::filesystem::path folder) : folder_(std::move(folder)) {}

  const std::filesystem::path& folder() const { return folder_; }
  // By name. Reads again only what has changed since it was asked last.
  const std::vector<ShelvedStudy>& look();

  // Each gives the study that came of it. A name that is taken or cannot be a folder's, and a
  // source that cannot be read, are InputError; a disk that refuses is OutsideError, and nothing
  // is half made.
  //
  // From a file of the program's, "demo.toml" or "studies/oshita-2018.toml", or of the disk; with
  // the files beside it that it names.
  StudyPlace add_template(std::string_view embedded, const std::string& name);
  StudyPlace add_file(const std::filesystem::path& file, const std::string& name);
  // All but what sessions have made.
  StudyPlace duplicate(const StudyPlace& place, const std::string& name);
  // [study] name follows as long as nobody has taken part. Not while a session of it runs.
  StudyPlace rename(const StudyPlace& place, const std::string& name);
  // "Walks 2": a name that is free.
  std::string free_name(const std::string& wanted) const;

 private:
  struct Process {
    std::int64_t number = 0;
    std::string start;
  };
  struct Known {
    std::map<std::string, FileStamp> files;  // when it was read
    DatabaseStamp sessions;
    ShelvedStudy study;
    std::vector<Process> processes;  // of the sessions that nobody has ended
  };
  static Known read(const StudyPlace& place);
  static int count_live(const std::vector<Process>& processes);
  std::filesystem::path place_for(const std::string& name) const;

  std::filesystem::path folder_;
  std::map<std::string, Known> known_;  // by folder
  std::vector<ShelvedStudy> studies_;
};

// Is there such a file or folder? What cannot be looked at is not there.
bool is_there(const std::filesystem::path& path);

// What a study can begin as: "demo.toml", "studies/normoyle-timed.toml", ...
std::vector<std::string> study_templates();

// The text with another [study] name; remarks and all else stay. A text without one is as it was.
std::string with_study_name(std::string text, const std::string& name);

}  // namespace promenade::study
