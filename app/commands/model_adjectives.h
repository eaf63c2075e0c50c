// `promenade model adjectives`: from people's ratings to primary adjective parameters.
#pragma once

#include <CLI/CLI.hpp>

namespace promenade::app {

void add_model_adjectives(CLI::App& model);

}  // namespace promenade::app
