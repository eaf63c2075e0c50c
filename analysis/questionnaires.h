// Questionnaires as they were filled in: which answers were given together, and what they
// score.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/log.h"
#include "analysis/selection.h"
#include "study/instrument.h"

namespace promenade::analysis {

// One instrument, filled in once; of what was answered twice the last counts.
struct FilledPage {
  int person = 0;  // index into Dataset::people
  std::string instrument, version;
  std::string asked;                    // start, trial, task, block or end; empty: not known
  std::string task, interface, target;  // what it is about; empty: none alone
  std::map<std::string, study::ItemAnswer> answers;  // by item; one place of a ranking
                                                     // is the item "NAME:CHOICE"
};

// Those of the sessions that count and were taken from this file of the log, which is open,
// without what is about practice or was done again; by person, each in the order of answers.
std::vector<FilledPage> filled_pages(study::Database& database, const Log& log,
                                     const Selection& selection, int file = 0);

// What people who count filled in, and the instruments of all versions of the study, each once.
struct Questionnaires {
  std::vector<FilledPage> pages;
  std::vector<study::Instrument> instruments;
};

// From all files of the log: opens each again, read-only. Throws InputError as read_log does.
Questionnaires read_questionnaires(const Log& log, const Selection& selection);

// Null: none of this name and version.
const study::Instrument* find_instrument(const std::vector<study::Instrument>& instruments,
                                         std::string_view name, std::string_view version);

// Nothing where an item that it needs is missing.
std::optional<double> score_of_page(const FilledPage& page, const study::Instrument& instrument,
                                    const study::Score& score);

}  // namespace promenade::analysis
