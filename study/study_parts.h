// The sections of a study file, each read by one function. Inside study/ only.
#pragma once

#include "study/load_instrument.h"
#include "study/load_study.h"
#include "study/toml_reader.h"

namespace promenade::study {

// The files that a study names, each read once and kept, since they are part of the study.
class StudyFiles {
 public:
  StudyFiles(std::string folder, FileLoader load, bool frozen = false)
      : folder_(std::move(folder)), load_(std::move(load)), frozen_(frozen) {}
  // `path` as the study says it, from its folder. Throws InputError or OutsideError.
  const std::string& read(const std::string& path);
  // One that comes with the program, "instruments/sus.toml": it is part of the study, too,
  // under the path "builtin:instruments/sus.toml"; of a frozen study it is the frozen one.
  const std::string& read_builtin(const std::string& path) { return read(builtin_path(path)); }
  std::string full_path(const std::string& path) const;  // for messages
  std::vector<StudyPart> parts() const;                  // by path
  bool frozen() const { return frozen_; }                // as they were when people took part

 private:
  std::string folder_;
  FileLoader load_;
  bool frozen_ = false;
  std::map<std::string, std::string> contents_;
};

// The instruments that a study names, each read once into Study::instruments.
class InstrumentShelf {
 public:
  InstrumentShelf(StudyFiles& files, Study& study, const StudyTexts& texts)
      : files_(files), study_(study), texts_(texts) {}
  // The one that `key` of the table names: one of the program's, or a file of the study,
  // "mine.toml". Its index; -1 after a problem.
  int find(const TomlTable& table, std::string_view key);

 private:
  int add(Instrument instrument);
  InstrumentFile read_own(const std::string& name);
  InstrumentFile read_builtin(const std::string& name);
  StudyFiles& files_;
  Study& study_;
  const StudyTexts& texts_;
  std::map<std::string, int> known_;
};

// What the sections need to know of each other.
struct StudyContext {
  const InterfaceRegistry& registry;
  const Study& study;                // what has been read so far
  const motion::MotionSpace* space;  // null: the set could not be read
  InstrumentShelf& instruments;
  const StudyTexts& texts;
  StudyFiles& files;
  const motion::PoseBank* bank;  // of the space
  // Made when first asked for; null: nobody has rated the motions of this set.
  std::function<std::shared_ptr<const AdjectiveModel>()> adjectives;
};

// What targets that are made by lot need to know of their task.
struct TargetRules {
  std::string task;  // its name
  motion::DistanceTimes times = motion::DistanceTimes::time;
  // D at the start, metres; nothing: as target_draw.h says.
  std::optional<double> least_start_m;
  bool stimuli = false;  // motions that are no blends may stand among them
};

// The "name" of a table, which goes into names of files and tables of results: up to 80
// characters, no control character, no "/", not beginning with a dot.
std::string read_name(const TomlTable& table);
// A problem at `key`, from where `name` comes, unless it is such a name.
void refuse_unsafe_name(const TomlTable& table, std::string_view key, const std::string& name);

// What is wrong with a file that the study names: at its places in that file, else at the key, as
// "cannot use FILE: ...". `file`: what it is, and its name.
void add_file_problems(const TomlTable& table, std::string_view key, const std::string& file,
                       const InputError& error);

// A text of the study's own: key = "words", or key = {en = "words", ja = "言葉"}. Warns
// about languages of the study that are missing.
LocalText read_local_text(const TomlTable& table, std::string_view key, const Study& study);
LocalText read_local_text(const TomlTable& table, std::string_view key,
                          const std::vector<std::string>& languages);
// The same where the languages are keys of the table itself; without any, its name
// stands for English.
LocalText read_languages(const TomlTable& table, const std::string& name, const Study& study);
LocalText read_languages(const TomlTable& table, const std::string& name,
                         const std::vector<std::string>& languages);

void read_study_section(const TomlTable& root, Study& study);
// The design keys of [study]: orders, nesting, how many people, how long.
void read_design(const TomlTable& section, Study& study);
// After the tasks: a planned number of people that leaves orders or lists uneven.
void warn_of_numbers(const TomlTable& root, const Study& study);
void read_display(const TomlTable& root, Study& study);
void read_breaks(const TomlTable& root, Study& study);
void read_practice(const TomlTable& root, Study& study);
void read_safety(const TomlTable& root, Study& study);
// `resources` is null when the motion set could not be read.
std::vector<InterfaceUse> read_interfaces(const TomlTable& root, const InterfaceRegistry& registry,
                                          const InterfaceResources* resources);
// The file of ratings, if the study names one: Study::ratings_file, of `bundle.space`.
void read_ratings_file(const TomlTable& root, StudyFiles& files, StudyBundle& bundle);
// The document that [study] prereg names becomes a part of the study; warns when it was written
// for another one. `config_text` is the text behind `root`.
void read_prereg_file(const TomlTable& root, std::string_view config_text, StudyFiles& files);
// [[stimulus]]: before the tasks, whose targets name them. After a problem some show nothing.
std::vector<std::shared_ptr<const Stimulus>> read_stimuli(const TomlTable& root,
                                                          const StudyContext& context);
// After the tasks: a stimulus that none shows, and one whose figure differs from others of its
// task.
void warn_of_stimuli(const TomlTable& root, const motion::MotionSet& set, const Study& study);
// { stimulus = NAME } in a list of targets.
Target read_stimulus_target(const TomlTable& table, const StudyContext& context);
// The keys that only a task of kind "rate" has.
void read_rate(const TomlTable& table, const StudyContext& context, Task& task);
std::vector<Task> read_tasks(const TomlTable& root, const StudyContext& context);
std::vector<Target> read_targets(const TomlTable& task, std::string_view key,
                                 const StudyContext& context, const TargetRules& rules);
// One entry of `targets`, or of `practice`, that stands for several.
std::vector<Target> read_random_targets(const TomlTable& table, std::string_view key,
                                        const StudyContext& context, const TargetRules& task);
std::vector<Target> read_target_file(const TomlTable& table, const StudyContext& context);
std::vector<Target> read_all_examples(const TomlTable& table, const StudyContext& context);
// What { random = ..., kept_in = FILE } drew once, `count` targets; nothing where it is to be
// drawn: there is no such key, or the file is about another set.
std::optional<std::vector<Target>> read_kept_targets(const TomlTable& table, int count, bool each,
                                                     const StudyContext& context);
std::vector<Target> read_qualities(const TomlTable& task, std::string_view key,
                                   const StudyContext& context);
// [[rating]] and [[questionnaire]]: after the tasks, of which they speak.
void read_questionnaires(const TomlTable& root, InstrumentShelf& instruments, Study& study);

// A problem for every table whose `key` was used before.
void refuse_doubles(const std::vector<TomlTable>& tables, const std::vector<std::string>& names,
                    const std::string& what);

}  // namespace promenade::study
