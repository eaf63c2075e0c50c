// Who is on the stage in a trial.
#pragma once

#include "app/stage.h"
#include "study/session.h"

namespace promenade::app {

// `made`: what the controls make of the walk, in rate tasks what is rated. Its rotations are
// only needed where the figures are posed. `now_us`: since the session began. All outlive the cast.
Cast trial_cast(const study::StudyBundle& bundle, const study::Session& session,
                const motion::Cycle& made, std::int64_t now_us);

}  // namespace promenade::app
