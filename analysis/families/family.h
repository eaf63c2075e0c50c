// What the families of a vectors file share. A family is one function from the
// "input" of a case to the keys of its "expected"; a new one is a file here and
// a line in the table of vectors.cpp. What is not defined is null; an input that
// it cannot take is a thrown CaseError.
#pragma once

#include <Eigen/Dense>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/statistics/interval.h"
#include "analysis/statistics/kaplan_meier.h"

namespace promenade::analysis::families {

using Json = nlohmann::json;

// What is wrong with the input of one case, as a phrase: "input.x is missing".
class CaseError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

double number(const Json& input, const char* key);
int whole_number(const Json& input, const char* key);  // 0 or more
double level(const Json& input, const char* key);      // between 0 and 1, both excluded
std::string text(const Json& input, const char* key);
std::vector<double> numbers(const Json& input, const char* key);
std::vector<std::optional<double>> numbers_or_null(const Json& input, const char* key);
// Rows of equal length, at least one row and column.
std::vector<std::vector<double>> matrix(const Json& input, const char* key);
// Rows of equal length, or none.
std::vector<std::vector<std::optional<double>>> matrix_or_null(const Json& input, const char* key);
// The same for Eigen; the second: square, symmetric and not negative.
Eigen::MatrixXd table(const Json& input, const char* key);
Eigen::MatrixXd distance_table(const Json& input, const char* key);

// Numbers or texts that name groups, as their places in the order of the names.
struct Labels {
  int count = 0;
  std::vector<int> places;
};
Labels labels(const Json& input, const char* key);

// input.time, not negative, and input.event: 1 done, 0 stopped.
std::vector<Duration> durations_of(const Json& input);

Json to_json(const std::optional<double>& value);
Json to_json(const Interval& interval);
Json to_json(const std::optional<Interval>& interval);

Json wilcoxon(const Json& input);
Json hodges_lehmann(const Json& input);
Json wilson(const Json& input);
Json clopper_pearson(const Json& input);
Json p_adjust(const Json& input);
Json mcnemar(const Json& input);
Json sign_test(const Json& input);
Json cochran_q(const Json& input);
Json friedman(const Json& input);
Json kaplan_meier(const Json& input);
Json logrank(const Json& input);
Json cronbach_alpha(const Json& input);
Json icc(const Json& input);
Json krippendorff_alpha(const Json& input);
Json bootstrap_median_ideal(const Json& input);
Json bootstrap_ci_given_replicates(const Json& input);
Json power_signflip_exact(const Json& input);
Json power_simulated(const Json& input);
Json power_paired_t(const Json& input);
Json ward(const Json& input);
Json pca(const Json& input);
Json classical_mds(const Json& input);

}  // namespace promenade::analysis::families
