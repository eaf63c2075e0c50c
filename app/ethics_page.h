// A page for an ethics board: what a study asks, what is stored, where and how long, and how a
// person is taken out again. Made from the study and from table `dictionary`, so that nothing
// can be stored that it does not tell of.
#pragma once

#include <string>

#include "study/study.h"

namespace promenade::app {

enum class PageFormat { html, markdown };

// In English; the texts of the study in all of its languages.
std::string ethics_page(const study::StudyBundle& bundle, PageFormat format);

}  // namespace promenade::app
