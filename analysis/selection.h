// Who counts: from all sessions of a log to the people of the report, each with
// one disposition, so that the flow of participants adds up.
#pragma once

#include <string>
#include <vector>

#include "analysis/exclusions.h"
#include "analysis/log.h"

namespace promenade::analysis {

struct SelectionOptions {
  bool include_simulated = false;
  bool include_pilot = false;
  std::string exclude_file;  // CSV with the columns code and reason; empty: none
  // Databases of people who rated what was made in this study (analysis/outcomes.h).
  std::vector<std::string> rated_by = {};
};

// In the order in which the flow shows them.
enum class Disposition { declined, withdrawn, unfinished, excluded, analysed };

struct Person {
  std::string code;  // made unique where two people of different files share one
  Disposition disposition = Disposition::unfinished;
  int session = -1;  // the one analysed, index into Log::sessions
  bool simulated = false, pilot = false;
  std::string reason;  // of who is excluded; may be empty
};

struct Selection {
  std::vector<Person> people;         // by code, natural order
  std::vector<Exclusion> exclusions;  // as given
  int left_out_simulated = 0;         // people not selected, by kind
  int left_out_pilot = 0;
  std::vector<std::string> shared_codes;  // codes of more than one person

  int count(Disposition disposition) const;
  bool any_simulated() const;
  bool any_pilot() const;
};

// A person's first finished session counts; pilot sessions only of who has no real
// one, simulated ones only of who has neither.
// Throws InputError when the exclusion file is wrong or names a code that nobody
// has.
Selection select(const Log& log, const SelectionOptions& options);

}  // namespace promenade::analysis
