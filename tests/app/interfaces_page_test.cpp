#include "app/interfaces_page.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "app/registry.h"
#include "tests/source_dir.h"

namespace promenade::app {
namespace {

const std::string file = (source_dir() / "docs/interfaces.md").string();

// tools/docs sets PROMENADE_WRITE_DOCS: then the page is written first.
TEST(InterfacesPage, IsWhatTheDeclarationsSay) {
  const std::string page = interfaces_page(interfaces(), study::load_texts("en"));
  if (std::getenv("PROMENADE_WRITE_DOCS") != nullptr) std::ofstream(file) << page;
  std::stringstream written;
  written << std::ifstream(file).rdbuf();
  EXPECT_EQ(written.str(), page) << "run tools/docs and commit docs/interfaces.md";
}

TEST(InterfacesPage, NamesEveryInterfaceAndSetting) {
  const std::string page = interfaces_page(interfaces(), study::load_texts("en"));
  for (const study::InterfaceType& type : interfaces().all()) {
    EXPECT_NE(page.find("\n## " + type.name + "\n"), std::string::npos);
    for (const study::ParameterSpec& spec : type.parameters) {
      EXPECT_NE(page.find("| `" + spec.name + "` |"), std::string::npos) << spec.name;
    }
  }
}

}  // namespace
}  // namespace promenade::app
