#include "tests/screenshots/album.h"

#include <epoxy/gl.h>
#include <png.h>

#include <fstream>
#include <map>

#include "motion/problem.h"

namespace promenade::app::screenshots {

Photograph photograph(int width, int height) {
  Photograph made{width, height, {}};
  made.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, made.pixels.data());
  return made;
}

Album::Album(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) {
    throw OutsideError("the folder " + folder_.string() + " cannot be made: " + error.message());
  }
}

void Album::add(const std::string& prefix, const std::string& what, const Photograph& photograph) {
  const std::string file = prefix + "-" + what + ".png";
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(photograph.width);
  image.height = static_cast<png_uint_32>(photograph.height);
  image.format = PNG_FORMAT_RGB;
  image.flags = PNG_IMAGE_FLAG_FAST;
  // A negative step: the first row is the lowest.
  const int written =
      png_image_write_to_file(&image, (folder_ / file).c_str(), 0, photograph.pixels.data(),
                              -3 * photograph.width, nullptr);
  if (written == 0) throw OutsideError((folder_ / file).string() + ": " + image.message);
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
