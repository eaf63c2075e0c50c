// A database as it may be published. Temporary views of the same names come before its
// tables, so that whoever reads `session` or `answer` afterwards sees people by new random
// codes and nothing that tells who, when or where; the file itself is not touched. What no
// view lists does not exist, so that a new column is private until it is let through.
#pragma once

#include <string>
#include <vector>

#include "analysis/export/export_demographics.h"
#include "analysis/export/export_parts.h"
#include "analysis/export/export_reviewed.h"

namespace promenade::analysis {

struct PublicData {
  std::vector<std::string> questions;  // of the cells
  std::vector<DemographicCell> cells;  // may be none
  int withheld_texts = 0;              // free answers that nobody reviewed
  int left_out_people = 0;             // who declined or withdrew
};

// Replaces uuids and codes in `source.log`, too. To be called once, before anything of the
// source was written; `source.selection` is to be made afterwards.
PublicData make_public(ExportSource& source, const ReviewedAnswers& reviewed);

}  // namespace promenade::analysis
