#include "app/prereg_page.h"

#include <gtest/gtest.h>

#include "analysis/prereg/sealed_plan.h"
#include "app/registry.h"
#include "study/identity.h"
#include "study/prereg_seal.h"

namespace promenade::app {
namespace {

constexpr const char* plan_text =
    "# <our> plan & \"words\"\nhypotheses = [\"Labels are *faster*.\"]\nparticipants = 12\n"
    "stopping = \"At 12.\"\nfamily = \"all\"\n[exclusions]\nmin_trials = 3\n"
    "[[measure]]\nname = \"time_s\"\ntask = \"match\"\n"
    "[[measure]]\nname = \"satisfaction\"\ntask = \"find\"\n";

const study::StudyBundle& demo() {
  static const study::StudyBundle bundle =
      study::load_unsealed_study("configs/demo.toml", interfaces());
  return bundle;
}

std::string page(PageFormat format) {
  const auto plan = analysis::read_plan("plan.toml", plan_text, &demo().study);
  return prereg_page({demo(), plan, plan_text, {9.2, 8, 11}}, format);
}

TEST(PreregPage, HoldsThePlanToTheLetter) {
  for (const PageFormat format : {PageFormat::markdown, PageFormat::html}) {
    EXPECT_EQ(analysis::plan_text_in("p", page(format)), plan_text);
  }
}

TEST(PreregPage, StatesTheHashesOfStudyAndPlan) {
  const std::string text = page(PageFormat::markdown);
  for (const std::string& hash : {study::sha256_hex(demo().config_text), demo().sha256,
                                  demo().set_sha256, study::sha256_hex(plan_text)}) {
    EXPECT_NE(text.find(hash), std::string::npos);
  }
}

TEST(PreregPage, SaysWhatAReviewerAsksFor) {
  const std::string text = page(PageFormat::html);
  for (const char* words :
       {"Labels are *faster*.", "labels, weights", "Williams design",
        "12 participants are analysed", "about 10 minutes", "fewer than 3 trials",
        "over all these tests together", "at most 0.05", "restricted to the time limit",
        "all pairs of interfaces", "20260701", "limit 45 s"}) {
    EXPECT_NE(text.find(words), std::string::npos) << words;
  }
}

TEST(PreregPage, IsTheSameWhenMadeAgain) {
  EXPECT_EQ(page(PageFormat::html), page(PageFormat::html));
}

}  // namespace
}  // namespace promenade::app
