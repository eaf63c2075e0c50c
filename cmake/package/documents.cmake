# While the program is installed: its changelogs and its manual page, made from CHANGELOG.md and from
# `promenade --help`, into ${INTO}. Takes PROGRAM, SOURCE, VERSION and CONTACT as well.
# SOURCE_DATE_EPOCH sets the day, for packages that are alike to the byte.

function(write_gzipped name text)
  file(WRITE ${INTO}/${name} "${text}")
  execute_process(COMMAND gzip -9nf ${INTO}/${name} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(READ ${SOURCE}/CHANGELOG.md changes)
write_gzipped(changelog "${changes}")

string(TIMESTAMP when "%a, %d %b %Y %H:%M:%S +0000" UTC)
write_gzipped(changelog.Debian "promenade (${VERSION}-1) bookworm; urgency=medium

  * What changed for users is in changelog.gz.

 -- ${CONTACT}  ${when}
")

# Of the help text the lines of commands, "  run     A participant's session".
execute_process(COMMAND ${PROGRAM} --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE ".*\nSubcommands:\n" "" commands "${help}")
string(REGEX REPLACE "\n *[a-z]+ +\\(not in this version yet\\)" "" commands "\n${commands}")
string(REPLACE "\\" "\\\\" commands "${commands}")
string(REPLACE "-" "\\-" commands "${commands}")
string(REGEX REPLACE "\n +([a-z]+) +([^\n]+)" "\n.TP\n.B \\1\n\\2" commands "${commands}")
string(STRIP "${commands}" commands)
string(TIMESTAMP day "%Y-%m-%d" UTC)
write_gzipped(promenade.1 ".TH PROMENADE 1 ${day} \"Promenade ${VERSION}\" \"User Commands\"
.SH NAME
promenade \\- run user studies of motion\\-style interfaces
.SH SYNOPSIS
.B promenade
.I COMMAND
[\\fIOPTIONS\\fR]
.SH DESCRIPTION
Participants see a walking figure that answers at once and work on short tasks with different
controls; what they do goes to one SQLite file, and the report comes from that file.
.B promenade
.I COMMAND
.B \\-\\-help
lists the options of a command.
.SH COMMANDS
${commands}
.SH EXIT STATUS
0: done; 1: it could not be done (disk, display, database); 2: the input or the command line is wrong.
.SH FILES
.TP
.I /usr/share/promenade/configs
the demo study, the published studies, instruments, recipes of motion sets: copy and change them
.TP
.I /usr/share/doc/promenade
the documents; begin with README.md
")
