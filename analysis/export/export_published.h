// Which answers a public export shows, and how coarsely: fills temp.public_answer and marks
// the people in temp.public_person whose demographics are hidden (export_public.h).
#pragma once

#include <string>
#include <vector>

#include "analysis/export/export_demographics.h"
#include "analysis/export/export_reviewed.h"
#include "study/instrument.h"

namespace promenade::analysis {

struct PublishedAnswers {
  std::vector<std::string> questions;  // the first is `simulated`: people are told apart by it
  std::vector<DemographicCell> cells;
  int withheld_texts = 0;
};

// Demographics are the choices and numbers of what is asked at the start and of every
// instrument named "demographics", and the language where there are several. Numbers among
// them become groups of ten. Of a questionnaire that this program cannot read, words and
// what was asked at the start are left out.
PublishedAnswers publish_answers(study::Database& database,
                                 const std::vector<study::Instrument>& instruments,
                                 const ReviewedAnswers& reviewed);

}  // namespace promenade::analysis
