// The document to register before the first session: what will be run, measured, tested and left
// out, in words that a reviewer understands, and the hashes that tell whether it was so.
#pragma once

#include <string>

#include "analysis/prereg/plan.h"
#include "app/ethics_page.h"
#include "study/session_length.h"
#include "study/study.h"

namespace promenade::app {

struct Prereg {
  const study::StudyBundle& study;  // without its seal: study/prereg_seal.h
  const analysis::AnalysisPlan& plan;
  std::string plan_text;  // to the letter
  study::SessionLength minutes;
};

// In English. The same study and plan give the same bytes.
std::string prereg_page(const Prereg& prereg, PageFormat format);

}  // namespace promenade::app
