#include "analysis/natural_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace promenade::analysis {
namespace {

TEST(NaturalOrder, CountsNumbersInNames) {
  std::vector<std::string> names = {"P10", "P2", "P1",  "a",
                                    "P02", "",   "P1x", "P9999999999999999999999"};
  std::sort(names.begin(), names.end(), natural_less);
  EXPECT_EQ(names, (std::vector<std::string>{"", "P1", "P1x", "P02", "P2", "P10",
                                             "P9999999999999999999999", "a"}));
}

TEST(NaturalOrder, IsStrict) {
  for (const std::string a : {"", "1", "01", "a1", "a01", "b"}) {
    EXPECT_FALSE(natural_less(a, a));
    for (const std::string b : {"", "1", "01", "a1", "a01", "b"}) {
      EXPECT_FALSE(natural_less(a, b) && natural_less(b, a)) << a << " " << b;
      EXPECT_TRUE(a == b || natural_less(a, b) || natural_less(b, a)) << a << " " << b;
    }
  }
}

}  // namespace
}  // namespace promenade::analysis
