// What every column and every question means: the codebook of an export, for people and, as
// Psych-DS wants it, for programs.
#pragma once

#include <string>
#include <vector>

#include "analysis/export/export_parts.h"

namespace promenade::analysis {

// One row for each column of each file, then one for each item and each score of the
// questionnaires. A text in several languages stands as "en: ...; ja: ...".
std::string codebook_csv(const std::vector<ExportColumn>& columns,
                         const std::vector<study::Instrument>& instruments);
std::string codebook_html(const std::string& title, const std::vector<ExportColumn>& columns,
                          const std::vector<study::Instrument>& instruments);

// dataset_description.json of Psych-DS (https://psychds-docs.readthedocs.io): a Dataset of
// schema.org whose variableMeasured names each column of the files in data/ once.
std::string dataset_description(const std::string& name, const std::string& description,
                                const std::string& version,
                                const std::vector<ExportColumn>& columns);

}  // namespace promenade::analysis
