// Who is to come, where, and with which order: a table of codes that is dealt before the first
// session and kept while people are booked. No row ever goes away: who does not come is marked,
// and a replacement is a row of its own with the same order at the same station.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "study/assignment.h"

namespace promenade::study {

class Database;

enum class Attendance { booked, done, no_show, replaced };
std::string_view to_text(Attendance state);

struct RosterRow {
  std::string code;     // study/person_code.h
  std::string station;  // "1", "2", ...
  int sequence = 0;     // order of the plan, from 0
  Attendance state = Attendance::booked;
  std::string replaces;  // the code whose place this is; empty: none
};

// The station, from 0, of each of the sequences 0 to participants - 1. In turns: each station
// gets one of the next `stations` sequences, by that rotation which gives them what they had
// least. So at any time the total is what it is without stations, stations differ by one person
// at most, and each has its orders evenly.
std::vector<int> deal_stations(DesignRound round, int participants, int stations);

// Adds rows until `participants` places are dealt; those that are there stay. New codes follow
// from the seed of the study. Throws InputError at `file` when the rows there are of more
// places or of other stations.
void extend_roster(const std::string& file, const Study& study, int participants, int stations,
                   std::vector<RosterRow>& rows);

// Who was booked did not come. Throws InputError at `file` for a code that is not in the roster
// ("did you mean"), or that is no longer booked.
void mark_no_show(const std::string& file, const std::string& code, std::vector<RosterRow>& rows);

// Somebody else takes the place of one who was booked or did not come: the new row.
const RosterRow& replace_person(const std::string& file, const Study& study,
                                const std::string& code, std::vector<RosterRow>& rows);

// The row of a code as somebody typed it. Throws InputError at `what` ("--participant K7QX").
const RosterRow& find_person(const std::string& what, const std::string& typed,
                             const std::vector<RosterRow>& rows);

// CSV with the columns code, station, sequence, state and replaces, and back. Throws InputError
// with all problems at once.
std::vector<RosterRow> read_roster(const std::string& file, std::string_view text);
std::string roster_csv(const std::vector<RosterRow>& rows);

// Throws InputError at `what` when the database says that the person is done, or that somebody
// else finished with the order.
void refuse_taken_place(const std::string& what, Database& database, const RosterRow& row,
                        bool simulated);

// Marks as done whom the table `roster` of a database says to be done, and who finished a session
// there that is no pilot; how many were not before.
int mark_done(Database& database, std::vector<RosterRow>& rows);

// Puts the row into table `roster`, or what has changed of it.
void store_row(Database& database, const RosterRow& row, const std::string& changed_utc);

}  // namespace promenade::study
