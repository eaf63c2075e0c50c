#include "app/photograph.h"

#include <epoxy/gl.h>
#include <png.h>

#include <string>

#include "motion/files.h"
#include "motion/problem.h"

namespace promenade::app {
namespace {

png_image header_of(const Photograph& photograph) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(photograph.width);
  image.height = static_cast<png_uint_32>(photograph.height);
  image.format = PNG_FORMAT_RGB;
  image.flags = PNG_IMAGE_FLAG_FAST;
  return image;
}

}  // namespace

Photograph photograph(int width, int height) {
  Photograph made{width, height, {}};
  made.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, made.pixels.data());
  return made;
}

void write_png(const std::filesystem::path& file, const Photograph& photograph) {
  png_image image = header_of(photograph);
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
  png_alloc_size_t size = bytes.size();
  // A negative step: the first row is the lowest.
  const int made = png_image_write_to_memory(
      &image, bytes.data(), &size, 0, photograph.pixels.data(), -3 * photograph.width, nullptr);
  if (made == 0) throw OutsideError(file.string() + ": " + image.message);
  bytes.resize(size);
  write_file(file, bytes);
}

}  // namespace promenade::app
