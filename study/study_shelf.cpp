#include "study/study_shelf.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <functional>
#include <set>

#include "motion/files.h"
#include "study/embedded.h"
#include "study/migrate.h"
#include "study/process.h"
#include "study/toml_edit.h"
#include "study/toml_parse.h"
#include "study/utf8.h"

namespace promenade::study {
namespace {

namespace fs = std::filesystem;

void read_planned(ShelvedStudy& study) {
  const std::string text = read_file(study.place.file());
  const TomlValue root = parse_toml(study.place.file(), text);
  const TomlValue* planned = value_at(root, {"study", "participants"});
  if (planned == nullptr || planned->kind != TomlValue::Kind::integer) return;
  study.planned = static_cast<int>(std::clamp<std::int64_t>(planned->integer, 0, 1'000'000));
}

void read_sessions(Database& database, ShelvedStudy& study) {
  Statement counts(database,
                   "SELECT count(*) FILTER (WHERE outcome = 'finished' AND NOT pilot), "
                   "count(*) FILTER (WHERE outcome = 'finished' AND pilot), "
                   "count(*) FILTER (WHERE outcome = 'running'), "
                   "count(*) FILTER (WHERE NOT pilot), count(*), coalesce(max(started_utc), '') "
                   "FROM session WHERE NOT simulated");
  counts.step();
  study.finished = static_cast<int>(counts.integer(0));
  study.pilots = static_cast<int>(counts.integer(1));
  study.open = static_cast<int>(counts.integer(2));
  const bool begun = counts.integer(3) > 0;
  study.last_run_utc = counts.text(5);
  const bool enough = study.planned > 0 && study.finished >= study.planned;
  study.state = enough                  ? StudyState::finished
                : begun                 ? StudyState::running
                : counts.integer(4) > 0 ? StudyState::piloted
                                        : StudyState::draft;
}

void attempt(ShelvedStudy& study, const std::function<void()>& read) {
  try {
    read();
  } catch (const InputError& error) {
    study.problem = to_text(error.problems().front());
  } catch (const std::exception& error) {
    study.problem = error.what();
  }
}

// Each folder or file in there, as far as it can be looked at.
template <typename Look>
void for_each_entry(const fs::path& folder, const Look& look) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    look(entry->path());
  }
}

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

// A file that a study is made of, and where it goes in its folder.
struct Piece {
  fs::path path;
  std::string content;
};

// Every text of the file that could name another one.
void collect_texts(const TomlValue& value, std::set<std::string>& texts) {
  if (value.kind == TomlValue::Kind::text) texts.insert(value.text);
  for (const TomlValue& element : value.elements) collect_texts(element, texts);
  for (const TomlValue::Entry& entry : value.entries) collect_texts(entry.value, texts);
}

std::set<std::string> texts_in_file(const std::string& file, std::string_view text) {
  std::set<std::string> texts;
  collect_texts(parse_lines_of_toml(file, text).root, texts);
  return texts;
}

// Could it be the name of a file within the folder?
bool stays_inside(const std::string& name) {
  if (name.empty() || name.size() > 200 || name.find_first_of("\n\"") != std::string::npos) {
    return false;
  }
  const fs::path path(name);
  return path.is_relative() && std::find(path.begin(), path.end(), "..") == path.end();
}

std::vector<Piece> pieces_of_template(std::string_view embedded) {
  const std::string path(embedded);
  const auto text = embedded_file(path);
  if (!text) throw InputError(path, "is no study of the program");
  std::vector<Piece> pieces{{"study.toml", std::string(*text)}};
  for (const std::string& name : texts_in_file("configs/" + path, *text)) {
    if (!stays_inside(name)) continue;
    const auto part = embedded_file((fs::path(path).parent_path() / name).string());
    if (part) pieces.push_back({name, std::string(*part)});
  }
  return pieces;
}

std::vector<Piece> pieces_of_file(const fs::path& file) {
  std::vector<Piece> pieces{{"study.toml", read_file(file)}};
  for (const std::string& name : texts_in_file(file, pieces.front().content)) {
    if (!stays_inside(name)) continue;
    const fs::path part = file.parent_path() / name;
    std::error_code error;
    if (fs::is_regular_file(part, error)) pieces.push_back({name, read_file(part)});
  }
  return pieces;
}

// A folder under a name of its own until it is whole.
void make_folder(const fs::path& folder, const std::vector<Piece>& pieces) {
  const fs::path unfinished =
      folder.parent_path() / fmt::format(".{}.{}", folder.filename().string(), ::getpid());
  std::error_code error;
  try {
    for (const Piece& piece : pieces) write_file(unfinished / piece.path, piece.content);
    fs::rename(unfinished, folder, error);
  } catch (...) {
    fs::remove_all(unfinished, error);
    throw;
  }
  if (!error) return;
  const std::string why = error.message();
  fs::remove_all(unfinished, error);
  throw OutsideError("cannot make " + folder.string() + ": " + why);
}

void name_study(std::vector<Piece>& pieces, const std::string& name) {
  pieces.front().content = with_study_name(std::move(pieces.front().content), name);
}

}  // namespace

// The program makes databases and folders there, which are no part of the study.
std::map<std::string, FileStamp> stamps_of_files(const StudyPlace& place) {
  std::map<std::string, FileStamp> stamps;
  for_each_entry(place.folder, [&](const fs::path& path) {
    const std::string name = path.filename().string();
    if (name.find(".db") == std::string::npos && is_file(path)) stamps[name] = file_stamp(path);
  });
  return stamps;
}

std::string_view to_text(StudyState state) {
  switch (state) {
    case StudyState::draft:
      return "draft";
    case StudyState::piloted:
      return "piloted";
    case StudyState::running:
      return "running";
    case StudyState::finished:
      return "finished";
  }
  return "";
}

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

int StudyShelf::count_live(const std::vector<Process>& processes) {
  return static_cast<int>(std::count_if(processes.begin(), processes.end(), [](const Process& one) {
    return lives(one.number, one.start);
  }));
}

StudyShelf::Known StudyShelf::read(const StudyPlace& place) {
  Known known;
  known.files = stamps_of_files(place);
  known.sessions = database_stamp(place.sessions());
  known.study.place = place;
  attempt(known.study, [&] { read_planned(known.study); });
  attempt(known.study, [&] {
    if (!is_there(place.sessions())) return;
    Database database = open_log(place.sessions());
    read_sessions(database, known.study);
    Statement row(database,
                  "SELECT process, coalesce(process_start, '') FROM session "
                  "WHERE outcome = 'running' AND process IS NOT NULL");
    while (row.step()) known.processes.push_back({row.integer(0), row.text(1)});
  });
  return known;
}

const std::vector<ShelvedStudy>& StudyShelf::look() {
  studies_.clear();
  for_each_entry(folder_, [this](const fs::path& path) {
    const StudyPlace place{path};
    if (place.name().starts_with('.') || !is_file(place.file())) return;
    Known& known = known_[place.folder.string()];
    const bool same =
        known.files == stamps_of_files(place) && known.sessions == database_stamp(place.sessions());
    if (!same) known = read(place);
    known.study.live = count_live(known.processes);
    studies_.push_back(known.study);
  });
  std::sort(studies_.begin(), studies_.end(), [](const ShelvedStudy& a, const ShelvedStudy& b) {
    return a.place.name() < b.place.name();
  });
  return studies_;
}

fs::path StudyShelf::place_for(const std::string& name) const {
  const std::string what = "the name \"" + name + "\"";
  if (name.empty()) throw InputError("the name", "is missing; type one");
  if (name.starts_with('.') || name.find('/') != std::string::npos || name.ends_with(' ') ||
      name.starts_with(' ')) {
    throw InputError(what, "cannot be used: no \"/\", and no dot or space at its ends");
  }
  if (count_characters(name) > 60)
    throw InputError(what, "is too long; use 60 characters or fewer");
  if (is_there(folder_ / name)) throw InputError(what, "is taken; choose another one");
  return folder_ / name;
}

std::string StudyShelf::free_name(const std::string& wanted) const {
  std::string name = wanted;
  for (int k = 2; is_there(folder_ / name); ++k) name = fmt::format("{} {}", wanted, k);
  return name;
}

StudyPlace StudyShelf::add_template(std::string_view embedded, const std::string& name) {
  StudyPlace place{place_for(name)};
  std::vector<Piece> pieces = pieces_of_template(embedded);
  name_study(pieces, name);
  make_folder(place.folder, pieces);
  return place;
}

StudyPlace StudyShelf::add_file(const fs::path& file, const std::string& name) {
  StudyPlace place{place_for(name)};
  make_folder(place.folder, pieces_of_file(file));
  return place;
}

StudyPlace StudyShelf::duplicate(const StudyPlace& place, const std::string& name) {
  StudyPlace copy{place_for(name)};
  std::vector<Piece> pieces = pieces_of_file(place.file());
  name_study(pieces, name);
  make_folder(copy.folder, pieces);
  return copy;
}

StudyPlace StudyShelf::rename(const StudyPlace& place, const std::string& name) {
  StudyPlace renamed{place_for(name)};
  if (count_live(read(place).processes) > 0) {
    throw InputError(place.name(), "has a session that runs; rename it when that has ended");
  }
  const bool unused = !is_there(place.sessions()) && !is_there(place.rehearsal());
  if (unused) write_file(place.file(), with_study_name(read_file(place.file()), name));
  std::error_code error;
  fs::rename(place.folder, renamed.folder, error);
  if (error) throw OutsideError("cannot rename " + place.folder.string() + ": " + error.message());
  return renamed;
}

std::string with_study_name(std::string text, const std::string& name) {
  const TomlPath path{"study", "name"};
  if (value_at(parse_lines_of_toml("study", text).root, path) == nullptr) return text;
  try {
    return edited_toml("study", text, set_value(path, toml_text(name)));
  } catch (const InputError&) {
    return text;  // no TOML yet; whoever mends it can name it, too
  }
}

std::vector<std::string> study_templates() {
  std::vector<std::string> all{"demo.toml", "tour.toml"};
  for (const std::string& name : embedded_names("studies")) {
    all.push_back("studies/" + name + ".toml");
  }
  return all;
}

}  // namespace promenade::study
