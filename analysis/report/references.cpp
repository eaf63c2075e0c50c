#include "analysis/report/references.h"

#include <algorithm>

#include "analysis/item.h"

namespace promenade::analysis {
namespace {

using References = std::vector<Reference>;

void add(References& list, const References& more) {
  list.insert(list.end(), more.begin(), more.end());
}

References of_pairs() {
  return {
      {"the signed-rank test",
       "F. Wilcoxon (1945). Individual comparisons by ranking methods. Biometrics Bulletin 1, "
       "80-83."},
      {"its rank-biserial correlation",
       "D. S. Kerby (2014). The simple difference formula: an approach to teaching nonparametric "
       "correlation. Comprehensive Psychology 3, 11.IT.3.1."},
      {"the interval of that correlation, after its idea",
       "R. G. Newcombe (2006). Confidence intervals for an effect size measure based on the "
       "Mann-Whitney statistic. Part 2: asymptotic methods and evaluation. Statistics in Medicine "
       "25, 559-573."},
      {"the estimate of the difference",
       "J. L. Hodges, E. L. Lehmann (1963). Estimates of location based on rank tests. Annals of "
       "Mathematical Statistics 34, 598-611."},
      {"its interval",
       "M. Hollander, D. A. Wolfe (1999). Nonparametric Statistical Methods, second edition. "
       "Wiley."},
      {"the adjustment for several tests",
       "S. Holm (1979). A simple sequentially rejective multiple test procedure. Scandinavian "
       "Journal of Statistics 6, 65-70."},
  };
}

References of_omnibus() {
  return {
      {"the test of all interfaces at once",
       "M. Friedman (1937). The use of ranks to avoid the assumption of normality implicit in the "
       "analysis of variance. Journal of the American Statistical Association 32, 675-701."},
      {"its F",
       "R. L. Iman, J. M. Davenport (1980). Approximations of the critical region of the Friedman "
       "statistic. Communications in Statistics A 9, 571-595."},
      {"its W",
       "M. G. Kendall, B. Babington Smith (1939). The problem of m rankings. Annals of "
       "Mathematical Statistics 10, 275-287."},
      {"the pairs after it",
       "P. B. Nemenyi (1963). Distribution-free multiple comparisons. PhD dissertation, Princeton "
       "University."},
  };
}

References of_proportions() {
  return {
      {"the score interval of a share",
       "E. B. Wilson (1927). Probable inference, the law of succession, and statistical "
       "inference. Journal of the American Statistical Association 22, 209-212."},
      {"the exact interval of a share",
       "C. J. Clopper, E. S. Pearson (1934). The use of confidence or fiducial limits illustrated "
       "in the case of the binomial. Biometrika 26, 404-413."},
  };
}

References of_failures() {
  return {
      {"failures with two interfaces",
       "Q. McNemar (1947). Note on the sampling error of the difference between correlated "
       "proportions or percentages. Psychometrika 12, 153-157."},
      {"failures with all interfaces",
       "W. G. Cochran (1950). The comparison of percentages in matched samples. Biometrika 37, "
       "256-266."},
  };
}

References of_times(bool pairs) {
  References list = {
      {"curves of censored times",
       "E. L. Kaplan, P. Meier (1958). Nonparametric estimation from incomplete observations. "
       "Journal of the American Statistical Association 53, 457-481."},
      {"the interval of their median",
       "R. Brookmeyer, J. Crowley (1982). A confidence interval for the median survival time. "
       "Biometrics 38, 29-41."},
  };
  if (pairs) {
    list.push_back(
        {"the log-rank test",
         "N. Mantel (1966). Evaluation of survival data and two new rank order statistics arising "
         "in its consideration. Cancer Chemotherapy Reports 50, 163-170."});
  }
  return list;
}

References of_ratings() {
  return {
      {"how far raters agree, with gaps",
       "K. Krippendorff (2011). Computing Krippendorff's alpha-reliability. Annenberg School for "
       "Communication, University of Pennsylvania."},
      {"the intraclass correlations of raters",
       "P. E. Shrout, J. L. Fleiss (1979). Intraclass correlations: uses in assessing rater "
       "reliability. Psychological Bulletin 86, 420-428."},
      {"their intervals",
       "K. O. McGraw, S. P. Wong (1996). Forming inferences about some intraclass correlation "
       "coefficients. Psychological Methods 1, 30-46."},
      {"the clusters of pairs of adjectives",
       "J. H. Ward (1963). Hierarchical grouping to optimize an objective function. Journal of the "
       "American Statistical Association 58, 236-244."},
  };
}

}  // namespace

bool tests_failures(const Results& results) {
  return results.data.interfaces.size() > 1 &&
         std::any_of(results.failures.begin(), results.failures.end(),
                     [](const FailureRatio& one) { return one.failed > 0; });
}

std::vector<Reference> references_of(const Results& results) {
  const bool pairs = results.data.interfaces.size() > 1;
  References list;
  if (!results.failures.empty() || results.preference.n > 0) list = of_proportions();
  list.push_back({"the interval of a median",
                  "W. R. Thompson (1936). On confidence ranges for the median and other "
                  "expectation distributions for populations of unknown distribution form. Annals "
                  "of Mathematical Statistics 7, 122-128."});
  if (pairs) add(list, of_pairs());
  if (!results.omnibus.empty()) add(list, of_omnibus());
  if (tests_failures(results)) add(list, of_failures());
  if (!results.times.empty()) add(list, of_times(pairs));
  if (results.rated_pairs && results.rated_pairs->problem.empty()) add(list, of_ratings());
  // By surname, which follows the first initials.
  const auto surname = [](const Reference& one) {
    const std::string names = one.text.substr(0, one.text.find_first_of(",("));
    std::size_t begin = 0;
    while (names.size() > begin + 2 && names[begin + 1] == '.') begin += 3;
    return names.substr(begin);
  };
  std::sort(list.begin(), list.end(),
            [&](const Reference& a, const Reference& b) { return surname(a) < surname(b); });
  return list;
}

}  // namespace promenade::analysis
