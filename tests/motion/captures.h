// Real captures, where they are at hand: ../shared/data beside the tree, or the folder
// that $PROMENADE_DATA names. Nothing of them is part of Promenade.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "tests/source_dir.h"

namespace promenade::motion {

inline std::filesystem::path data_folder() {
  const char* named = std::getenv("PROMENADE_DATA");
  return named && *named ? std::filesystem::path(named) : source_dir() / "../shared/data";
}

class Captures : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::is_directory(data_folder())) {
      GTEST_SKIP() << "There are no captures in " << data_folder()
                   << "; name their folder in PROMENADE_DATA to run this test.";
    }
  }
};

}  // namespace promenade::motion
