// The subcommands of `promenade model`, one file each.
#pragma once

#include <CLI/CLI.hpp>

namespace promenade::app {

void add_model_map(CLI::App& model);
void add_model_features(CLI::App& model);
void add_model_adjectives(CLI::App& model);
void add_model_raters(CLI::App& model);
void add_model_targets(CLI::App& model);
void add_model_outcomes(CLI::App& model);

}  // namespace promenade::app
