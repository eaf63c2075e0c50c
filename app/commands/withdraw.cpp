// `promenade withdraw`: removes a person as the consent says.
#include "study/withdraw.h"

#include <fmt/format.h>

#include "app/commands.h"
#include "app/print.h"

namespace promenade::app {
namespace {

struct Options {
  std::string database, code, forget;
  bool json = false;
};

Json json_of(const Options& options, const study::Withdrawn& withdrawn) {
  Json json = {{"db", options.database}, {"removed", Json::object()}};
  for (const auto& [table, rows] : withdrawn.removed) json["removed"][table] = rows;
  json["unlinked_sessions"] = withdrawn.unlinked;
  json["backups"] = Json::array();
  for (const study::ReachedBackup& backup : withdrawn.backups) {
    json["backups"].push_back(
        {{"path", backup.path}, {"done", backup.problem.empty()}, {"problem", backup.problem}});
  }
  return json;
}

std::string text_of(const Options& options, const study::Withdrawn& withdrawn) {
  std::string text;
  for (const auto& [table, rows] : withdrawn.removed) {
    if (rows > 0) text += fmt::format("removed {} of {}\n", rows, table);
  }
  if (withdrawn.unlinked > 0) {
    text += fmt::format("{} sessions stay without what tells whose they are\n", withdrawn.unlinked);
  }
  for (const study::ReachedBackup& backup : withdrawn.backups) {
    if (backup.problem.empty()) text += "removed from the backup " + backup.path + "\n";
  }
  return text + options.database + ": nothing else is left to do in this file\n";
}

// Exit code 1: the withdrawal is done but for these.
void report_unreached(const Options& options, const study::Withdrawn& withdrawn) {
  std::string unreached;
  for (const study::ReachedBackup& backup : withdrawn.backups) {
    if (!backup.problem.empty()) unreached += "\n  " + backup.path + ": " + backup.problem;
  }
  if (unreached.empty()) return;
  throw OutsideError(
      "these backups may still hold a person who withdrew; see to it and call "
      "`promenade withdraw " +
      options.database + "`:" + unreached);
}

void run(const Options& options) {
  if (!options.forget.empty()) {
    study::forget_backup(options.database, options.forget);
    return options.json ? print_json({{"db", options.database}, {"forgotten", options.forget}})
                        : print_text(options.forget + " is off the list\n");
  }
  const study::Withdrawn withdrawn = options.code.empty()
                                         ? study::finish_withdrawals(options.database)
                                         : study::withdraw(options.database, options.code);
  if (options.json) {
    print_json(json_of(options, withdrawn));
  } else {
    print_text(text_of(options, withdrawn));
  }
  report_unreached(options, withdrawn);
}

}  // namespace

void add_withdraw_command(Command program) {
  auto options = std::make_shared<Options>();
  Command command = program.add_subcommand("withdraw", "Removes a person as the consent text says");
  command.add_option("DB", options->database, "the database").required();
  Option code = command.add_option(
      "CODE", options->code, "of the person; without it, what earlier withdrawals had to leave");
  command
      .add_option("--forget", options->forget,
                  "a backup that is gone for good: nothing waits to be done in it any more")
      .excludes(code);
  command.add_flag("--json", options->json, "one JSON document on stdout");
  command.callback([options, code] {
    // An empty code would mean something else than was typed.
    if (code.given() && options->code.empty()) throw InputError("CODE", "is empty");
    run(*options);
  });
}

}  // namespace promenade::app
