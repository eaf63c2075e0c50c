// The subcommands of `promenade model`, one file each.
#pragma once

#include "app/command_line.h"

namespace promenade::app {

void add_model_map(Command model);
void add_model_features(Command model);
void add_model_adjectives(Command model);
void add_model_raters(Command model);
void add_model_targets(Command model);
void add_model_outcomes(Command model);

}  // namespace promenade::app
