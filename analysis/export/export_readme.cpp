#include "analysis/export/export_readme.h"

#include "analysis/format.h"
#include "study/identity.h"

namespace promenade::analysis {
namespace {

constexpr const char* files_text =
    R"(
| file | what is in it |
| --- | --- |
| `people_wide.csv` | one row for each person who counts, one column for each measure, answer and score |
| `data/description-peopleLong_data.csv` | the same, one row for each value |
| `data/description-session_data.csv` | one row for each session |
| `data/description-trial_data.csv` | one row for each trial, practice and repeated ones included (`practice`, `superseded`) |
| `data/description-event_data.csv` | one row for each input and each thing that happened |
| `data/description-sample_data.csv` | one row for each change of what was shown, with the weight of each motion |
| `data/description-answer_data.csv` | one row for each answer |
| `data/description-frameHistogram_data.csv` | how long frames took |
| other files in `data/` | the other tables of the database |
| `codebook.csv`, `codebook.html` | what each column and each question means |
| `dataset_description.json` | the same for programs, as Psych-DS says |
| `analysis.R` | for `Rscript analysis.R`: repeats each test of the report, and fits mixed models to its trials |
| `tables/` | what it reads: the trials that count, the measures, and the tests as Promenade computed them |
| `materials/` | the motions that were shown, where they may be given away |

CSV is UTF-8 with commas, "." before decimals, LF at the end of lines and quotes where they are
needed (RFC 4180); an empty cell is no value. Cells are exactly what was logged: a text may
begin with "=", so tell a spreadsheet to import columns as text.

Times are microseconds since the session began, unless `codebook.csv` says otherwise. `counts` is 1
where `people_wide.csv` is made from a row: a finished session of a person who counts, and in it
trials that ended by themselves, without practice and without what was done again.
)";

constexpr const char* public_text =
    R"(
## For the public

People have new random codes, in random order; sessions and trials are named after them. There are no
dates, no stations, no machines, no seeds, no notes of experimenters and none of the files of the
study. Whoever declined or withdrew is not in it. Details of events hold numbers only. Ages are
groups of ten years. `demographic_cells.csv` counts people by their demographics; the demographics
of those in cells of fewer than five are left out, and with them the next larger cells until five
people are hidden.
)";

}  // namespace

std::string description_of(const ExportSource& source) {
  return "A study of interfaces for motion styles, \"" + source.log.study + "\", version " +
         source.log.version + ", as logged by Promenade";
}

std::string readme_of(const ExportSource& source, const PublicData& data) {
  std::string text = "# " + source.log.study + "\n\n" + description_of(source) + ".\n" + files_text;
  if (source.is_public) text += public_text;
  if (data.withheld_texts > 0) {
    text += "\n" + count_of(data.withheld_texts, "free answer was", "free answers were") +
            " left out: nobody has reviewed " + (data.withheld_texts == 1 ? "it" : "them") + ".\n";
  }
  text += "\n## How it was made\n\n`promenade export DB --out DIR";
  text += source.is_public ? " --public" : "";
  text += "`, Promenade " + std::string(study::program_version()) +
          "; the sessions ran on version " + source.log.files.front().program_version +
          ". Study: SHA-256 `" + source.log.sha256 + "`.";
  return text + "\n";
}

}  // namespace promenade::analysis
