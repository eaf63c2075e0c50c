#include "app/desk/page.h"

namespace promenade::app {

void DeskPage::advance(std::int64_t) {}

void DeskPage::draw_figures(FigureRenderer&, const Gui&) {}

void DeskPage::dropped(const std::vector<std::string>&) {}

void DeskPage::save() {}

const std::vector<std::string>& DeskPage::shown_words() const {
  static const std::vector<std::string> none;
  return none;
}

}  // namespace promenade::app
