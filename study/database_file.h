// A database as files of the disk: made for their owner only, and taken away whole. Inside
// study/ only.
#pragma once

#include <string>

namespace promenade::study {

// The file is there with rights for its owner only before SQLite opens it; its
// journal gets the same rights. One that is there is not opened: closing it would
// drop the locks that SQLite holds on it elsewhere in this process.
// True: it was made here. Throws OutsideError when it cannot be written.
bool make_private_file(const std::string& file);

// Throws OutsideError.
void require_writable(const std::string& file);

// With its journals.
void remove_database(const std::string& file);

// The new name is on the disk, with all that is in the file, over what had the name before.
// No connection may have the file open. Throws OutsideError, and leaves both as they were.
void rename_durably(const std::string& from, const std::string& to);

}  // namespace promenade::study
