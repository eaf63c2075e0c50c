#include "tests/screenshots/album.h"

#include <fstream>
#include <map>

#include "motion/problem.h"

namespace promenade::app::screenshots {

Album::Album(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) {
    throw OutsideError("the folder " + folder_.string() + " cannot be made: " + error.message());
  }
}

void Album::add(const std::string& prefix, const std::string& what, const Photograph& photograph) {
  const std::string file = prefix + "-" + what + ".png";
  write_png(folder_ / file, photograph);
  pictures_.push_back({what, file});
}

void Album::write_contact_sheet() const {
  std::map<std::string, std::vector<std::string>> files;
  for (const Picture& picture : pictures_) files[picture.what].push_back(picture.file);
  std::ofstream page(folder_ / "index.html");
  page << "<!DOCTYPE html>\n<meta charset=\"utf-8\">\n<title>Promenade: every screen</title>\n"
          "<style>body{font:16px sans-serif;margin:24px;background:#fff;color:#26282c}"
          "figure{display:inline-block;margin:0 16px 16px 0}img{width:400px;border:1px solid "
          "#cfccc6}figcaption{font-size:13px}</style>\n";
  for (const auto& [what, names] : files) {
    page << "<h2>" << what << "</h2>\n";
    for (const std::string& name : names) {
      page << "<figure><a href=\"" << name << "\"><img loading=\"lazy\" src=\"" << name
           << "\" alt=\"" << name << "\"></a><figcaption>" << name << "</figcaption></figure>\n";
    }
  }
  page.flush();
  if (!page) throw OutsideError((folder_ / "index.html").string() + " cannot be written");
}

}  // namespace promenade::app::screenshots
