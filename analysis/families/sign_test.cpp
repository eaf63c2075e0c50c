#include "analysis/statistics/sign_test.h"

#include "analysis/families/family.h"

namespace promenade::analysis::families {

Json sign_test(const Json& input) {
  const SignTest test =
      analysis::sign_test(whole_number(input, "n_pos"), whole_number(input, "n_neg"));
  return {{"n", test.n}, {"p_two", test.two}, {"p_greater", test.greater}, {"p_less", test.less}};
}

}  // namespace promenade::analysis::families
