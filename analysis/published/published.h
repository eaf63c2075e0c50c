// A run of a published study held against what the paper printed: one row for each printed number
// or statement. Start at printed.h for the papers' side.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/published/printed.h"
#include "analysis/published/published_pairs.h"
#include "study/study.h"

namespace promenade::analysis {

struct Results;

struct PublishedRow {
  std::string kind;                      // design, clusters, test, claim or preference
  std::string what;                      // "time, adjectives − features"
  std::string target;                    // "target 1", "all"; empty: not about targets
  std::string place;                     // in the source
  std::optional<double> printed, run;    // a count, or a p
  std::string printed_words, run_words;  // of claims and preferences, in place of bare numbers
  int n = 0;                             // what the run's value rests on; 0: no people
  // Of tests the exact p beside the one that is made as the paper made its own; for all targets
  // together of one value per participant.
  std::optional<double> p_exact;
  std::string direction;       // which interface had the smaller values
  std::optional<bool> agrees;  // counts equal; or both significant at .05, or neither, and the
                               // same direction where one is printed
  std::string note;
};

struct Published {
  const PrintedStudy* study = nullptr;  // null: the study repeats none that we know
  std::vector<PublishedRow> rows;
  std::optional<PublishedPairs> pairs;  // of questionnaires
};

// `bundle`: the newest version of the study, or null. Comparisons, questionnaires and preference of
// the results must be there.
Published published_of(const Results& results, const study::StudyBundle* bundle);

// The parts of it, in the order of the rows.
void add_printed_counts(const Results& results, const study::StudyBundle* bundle,
                        Published& published);
void add_printed_sliders(const study::StudyBundle* bundle, Published& published);
void add_printed_tests(const Results& results, Published& published);
void add_printed_claims(const Results& results, Published& published);
void add_printed_preference(const Results& results, Published& published);

// The interface of the data set that is of this type, the first of them; -1: none.
int interface_of_type(const Results& results, std::string_view type);

}  // namespace promenade::analysis
