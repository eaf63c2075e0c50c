// `promenade model raters`: what simulated raters say about a built-in set.
#include <memory>

#include "app/commands/model_parts.h"
#include "app/print.h"
#include "motion/builtin.h"
#include "motion/files.h"
#include "study/ratings_csv.h"
#include "study/simulated_raters.h"

namespace promenade::app {
namespace {

struct Arguments {
  std::string set, out;
  study::RaterOptions options;
};

void write(const Arguments& given) {
  const std::string name = motion::builtin_name(given.set).value_or(given.set);
  const auto table = study::simulated_ratings(name, given.options);
  if (!table) {
    throw InputError(given.set,
                     "is no built-in set; simulated raters only know how those were made. People "
                     "must rate this one, or `model adjectives ... --predict` guesses");
  }
  if (given.out.empty()) return print_text(study::ratings_csv(*table));
  write_file(given.out, study::ratings_csv(*table));
}

}  // namespace

void add_model_raters(Command model) {
  Command command = model.add_subcommand(
      "raters", "Ratings of a built-in set by simulated raters, as CSV rater,motion,pair,value");
  const auto given = std::make_shared<Arguments>();
  command.add_option("set", given->set, "builtin:A, or another built-in set").required();
  command.add_option("--seed", given->options.seed, "The same seed, the same ratings");
  command.add_option("--raters", given->options.raters, "How many, 1 to 10000").range(1, 10000);
  command.add_option("--out", given->out, "The file to write; stdout without it");
  command.callback([given] { write(*given); });
}

}  // namespace promenade::app
