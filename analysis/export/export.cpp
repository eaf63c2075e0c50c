#include "analysis/export/export.h"

#include <algorithm>

#include "analysis/export/export_codebook.h"
#include "analysis/export/export_public.h"
#include "analysis/export/export_r.h"
#include "analysis/export/export_readme.h"
#include "analysis/export/export_tables.h"
#include "analysis/export/export_wide.h"
#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/workshop.h"
#include "motion/files.h"
#include "motion/problem.h"
#include "motion/set_file.h"
#include "study/stored_study.h"

namespace promenade::analysis {
namespace {

namespace fs = std::filesystem;
using study::Database;
using study::Statement;

constexpr const char* wide_file = "people_wide.csv";
constexpr const char* long_file = "data/description-peopleLong_data.csv";

// The instruments of every version of the study. One that this program cannot read any more
// keeps nobody from the rest.
std::vector<study::Instrument> stored_instruments(Database& database,
                                                  const study::InterfaceRegistry& registry,
                                                  ExportNotes& notes) {
  std::vector<study::Instrument> instruments;
  Statement row(database, "SELECT uuid FROM study ORDER BY created_utc, uuid");
  while (row.step()) {
    try {
      study::StudyBundle bundle = study::read_stored_study(database, row.text(0), registry);
      for (study::Instrument& one : bundle.study.instruments) {
        if (find_instrument(instruments, one.name, one.version)) continue;
        instruments.push_back(std::move(one));
      }
    } catch (const InputError& error) {
      notes.push_back(
          "its study cannot be read whole by this version, so its questionnaires are "
          "not in the codebook and have no scores: " +
          std::string(error.what()));
    }
  }
  return instruments;
}

std::string file_name(std::string name) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
  };
  std::replace_if(
      name.begin(), name.end(), [&](char c) { return !is_plain(c); }, '_');
  return name;
}

bool is_made_by_program(std::string_view content, const std::string& file) {
  const motion::MotionSet set = motion::from_bytes(content, file);
  return std::all_of(set.cycles.begin(), set.cycles.end(),
                     [](const motion::Cycle& cycle) { return cycle.source == "generated"; });
}

// The very motions that were shown, for `promenade set info` and `set export`.
void write_motions(const ExportOptions& options, Database& database, const fs::path& folder,
                   ExportNotes& notes) {
  Statement row(database, "SELECT name, sha256, content FROM main.motion_set ORDER BY sha256");
  while (row.step()) {
    const bool all = !options.is_public || options.with_motions;
    try {
      if (all || is_made_by_program(row.blob(2), database.file())) {
        const std::string name = file_name(row.text(0)) + "-" + row.text(1).substr(0, 8) + ".set";
        write_file(folder / "materials" / name, row.blob(2));
        continue;
      }
    } catch (const InputError&) {  // unreadable: nobody knows whose they are
    }
    notes.push_back("the motions of \"" + row.text(0) +
                    "\" come from captures and are left out; --with-motions adds them where their "
                    "licence allows it");
  }
}

void note_left_out(const ExportSource& source, ExportNotes& notes) {
  const auto note = [&](int count, const char* kind, const char* option) {
    if (count == 0) return;
    notes.push_back(count_of(count, std::string(kind) + " participant is",
                             std::string(kind) + " participants are") +
                    " not in people_wide.csv, add " + option);
  };
  note(source.selection.left_out_simulated, "simulated", "--include-simulated");
  note(source.selection.left_out_pilot, "pilot", "--include-pilot");
}

std::string words_of(const DemographicCell& cell, const std::vector<std::string>& questions) {
  std::string words;
  for (int i = 0; i < size_of(questions); ++i) {
    words += (i > 0 ? ", " : "") + item(questions, i) + " " + item(cell.values, i);
  }
  return words + ": " + count_of(size_of(cell.people), "person", "people");
}

void note_public(const PublicData& data, ExportNotes& notes) {
  for (const DemographicCell& cell : data.cells) {
    if (!cell.suppressed) continue;
    notes.push_back("warning: a small cell, its demographics are left out: " +
                    words_of(cell, data.questions));
  }
  if (data.withheld_texts > 0) {
    notes.push_back(count_of(data.withheld_texts, "free answer is", "free answers are") +
                    " left empty; --reviewed FILE.csv publishes those that somebody read");
  }
  if (data.left_out_people > 0) {
    notes.push_back(count_of(data.left_out_people, "person", "people") +
                    " who declined or withdrew left out");
  }
}

PublicData prepare_public(const ExportOptions& options, ExportSource& source, ExportNotes& notes) {
  ReviewedAnswers reviewed;
  if (!options.reviewed_file.empty()) {
    reviewed =
        parse_reviewed(options.reviewed_file, read_file(options.reviewed_file), source.database);
  }
  PublicData data = make_public(source, reviewed);
  note_public(data, notes);
  return data;
}

void write_words(const ExportSource& source, const std::vector<ExportColumn>& columns,
                 const PublicData& data, const fs::path& folder) {
  const Log& log = source.log;
  write_file(folder / "codebook.csv", codebook_csv(columns, source.instruments));
  write_file(folder / "codebook.html",
             codebook_html(log.study + " — codebook", columns, source.instruments));
  write_file(folder / "dataset_description.json",
             dataset_description(log.study, description_of(source), log.version, columns));
  if (!data.cells.empty()) {
    write_file(folder / "demographic_cells.csv", cells_csv(data.questions, data.cells));
  }
  write_file(folder / "README.md", readme_of(source, data));
}

void write_all(const ExportOptions& options, const ExportSource& source, const PublicData& data,
               const fs::path& folder, ExportNotes& notes) {
  fs::create_directories(folder / "data");
  std::vector<ExportColumn> columns = export_tables(source, folder, options.progress);
  const WideTable wide = make_wide(source);
  write_file(folder / wide_file, wide_csv(wide));
  write_file(folder / long_file, long_csv(wide));
  for (ExportColumn& column : wide_codebook(wide, wide_file, long_file)) {
    columns.push_back(std::move(column));
  }
  write_motions(options, source.database, folder, notes);
  if (!write_r_script(source, folder, options.progress)) {
    notes.emplace_back("no finished trial counts, so there is no analysis.R");
  }
  write_words(source, columns, data, folder);
}

ExportNotes export_database(const ExportOptions& options, Database& database,
                            const study::InterfaceRegistry& registry) {
  const fs::path folder = wanted_folder(options.folder);
  ExportNotes notes;
  database.exec("PRAGMA temp_store = MEMORY");
  database.exec("BEGIN");  // one state of the file, whoever writes to it
  ExportSource source{database, read_log(database), {}, {}, false};
  source.instruments = stored_instruments(database, registry, notes);
  PublicData data;
  if (options.is_public) data = prepare_public(options, source, notes);
  source.selection = select(source.log, options.selection);
  note_left_out(source, notes);
  const Workshop workshop(folder);
  try {
    write_all(options, source, data, workshop.path(), notes);
  } catch (const OutsideError& error) {
    if (dynamic_cast<const study::DatabaseError*>(&error)) throw;
    throw OutsideError(workshop.as_wanted(error.what()));
  }
  workshop.put_in_place("README.md");
  return notes;
}

}  // namespace

ExportNotes write_export(const ExportOptions& options, const study::InterfaceRegistry& registry) {
  try {
    Database database = open_database(options.database);
    return export_database(options, database, registry);
  } catch (const study::DatabaseError& error) {
    refuse_content(options.database, error);
  }
}

}  // namespace promenade::analysis
