// The pages of the desk, each in a file of its own.
#pragma once

#include <memory>

#include "app/desk/open_study.h"
#include "app/desk/page.h"
#include "app/desk/services.h"

namespace promenade::app {

// `services` outlive them.
std::unique_ptr<DeskPage> make_studies_page(DeskServices& services);
std::unique_ptr<DeskPage> make_takes_page(DeskServices& services);
std::unique_ptr<DeskPage> make_plan_page(DeskServices& services, OpenStudy& study);
std::unique_ptr<DeskPage> make_rehearse_page(DeskServices& services, OpenStudy& study);
std::unique_ptr<DeskPage> make_run_page(DeskServices& services, OpenStudy& study);
std::unique_ptr<DeskPage> make_results_page(DeskServices& services, OpenStudy& study);

}  // namespace promenade::app
