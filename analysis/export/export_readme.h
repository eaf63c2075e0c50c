// The page that says what each file of an export is and how it was made.
#pragma once

#include <string>

#include "analysis/export/export_parts.h"
#include "analysis/export/export_public.h"

namespace promenade::analysis {

std::string description_of(const ExportSource& source);  // one sentence
// `data`: of a public export. Names no date and no file of its own, so that two exports of
// the same database agree.
std::string readme_of(const ExportSource& source, const PublicData& data);

}  // namespace promenade::analysis
