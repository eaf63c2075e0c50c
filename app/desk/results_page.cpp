#include "app/desk/pages.h"

namespace promenade::app {
namespace {

class Page : public DeskPage {
 public:
  void draw(const Ui&, const study::Texts&, const Box&) override {}
};

}  // namespace

std::unique_ptr<DeskPage> make_results_page(DeskServices&, OpenStudy&) {
  return std::make_unique<Page>();
}

}  // namespace promenade::app
