#include "study/published.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "study/embedded.h"
#include "toy.h"

namespace promenade::study {
namespace {

std::string study_with(const std::string& line) {
  std::string text = toy::study_text();
  const std::string old = "[study]\n";
  return text.replace(text.find(old), old.size(), old + line + "\n");
}

std::string problem_of(const std::string& line) {
  try {
    toy::bundle(study_with(line));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Published, NamesThePrintedStudy) {
  EXPECT_EQ(toy::bundle().study.published, "");
  EXPECT_EQ(toy::bundle(study_with("published = 'oshita-2018'")).study.published, "oshita-2018");
}

TEST(Published, MustBeKnown) {
  const std::string close = problem_of("published = 'oshita-2081'");
  EXPECT_NE(close.find("did you mean \"oshita-2018\"?"), std::string::npos) << close;
  EXPECT_NE(problem_of("published = 2018").find("published"), std::string::npos);
  EXPECT_NE(problem_of("published = ''").find("must be one of"), std::string::npos);
}

TEST(Published, HasAStudyFileOfEachName) {
  const std::vector<std::string> files = embedded_names("studies");
  for (const std::string& name : published_studies()) {
    EXPECT_EQ(std::count(files.begin(), files.end(), name), 1) << name;
  }
}

}  // namespace
}  // namespace promenade::study
