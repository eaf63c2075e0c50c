// The Edit page in both sizes and languages: nothing lies on something else or outside.
#include "app/registry.h"
#include "tests/app/desk/edit/edit_bench.h"

namespace promenade::app {
namespace {

struct Look {
  int width, height;
  const char* language;
};

class EditLook : public bench::EditBench, public testing::WithParamInterface<Look> {
 protected:
  EditLook() : EditBench(long_study(), GetParam().width, GetParam().height, GetParam().language) {}

  // Names as long as they can be.
  static std::string long_study() {
    const std::string name(80, 'm');
    std::string text = bench::edit_study;
    text.replace(text.find("\"match\""), 7, "\"" + name + "\"");
    return text.replace(text.find("\"walks\""), 7, "\"" + name + "\"");
  }
};

TEST_P(EditLook, KeepsEverythingInTheWindow) {
  check();
  for (const EditSection& section : edit_sections()) {
    click("section", section.name);
    for (std::size_t i = 0; i < page_.widgets().size(); ++i) {
      const Widget& one = page_.widgets()[i];
      EXPECT_GE(one.box.x, 0) << one.kind << " " << one.target;
      EXPECT_LE(one.box.right(), static_cast<float>(GetParam().width)) << one.target;
      EXPECT_GE(one.box.height, 0) << one.target;
    }
  }
}

TEST_P(EditLook, LetsTheTabKeyStopAtEveryControl) {
  click("section", "tasks");
  press("item/task[0]");
  std::set<std::string> wanted;
  for (std::size_t i = 0; i < page_.widgets().size(); ++i) {
    const Widget& one = page_.widgets()[i];
    if (one.stop) wanted.insert(one.kind + " " + one.target);
  }
  const std::size_t once_around = page_.widgets().size();
  for (std::size_t k = 0; k < once_around && !wanted.empty(); ++k) {
    key(GLFW_KEY_TAB);
    std::erase_if(wanted, [this](const std::string& one) {
      const std::size_t gap = one.find(' ');
      return page_.focus().on(one.substr(0, gap), one.substr(gap + 1));
    });
  }
  EXPECT_TRUE(wanted.empty()) << *wanted.begin();
}

INSTANTIATE_TEST_SUITE_P(Looks, EditLook,
                         testing::Values(Look{1280, 720, "en"}, Look{2560, 1440, "ja"}));

}  // namespace
}  // namespace promenade::app
