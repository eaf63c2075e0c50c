# Reproduces every Wilcoxon test of the report with R, and fits mixed models to its trials.
#
#   Rscript analysis.R
#
# It reads trials.csv, comparisons.csv and measures.csv, in tables/ of the folder in which it lies.
# The tests need base R alone; it stops with an error where a number of the report differs from
# R's by more than 1e-9 (relative). The models need lme4 and ordinal.

options(width = 150, warn = 1)
tolerance <- 1e-9

# ---- tables ----------------------------------------------------------------------------------

own_folder <- function() {
  file <- sub("^--file=", "", grep("^--file=", commandArgs(FALSE), value = TRUE))
  if (length(file) == 1) dirname(gsub("~+~", " ", file, fixed = TRUE)) else "."
}

# All as text first: R would take an interface with the name "T" for a truth value.
read_table <- function(name) {
  read.csv(file.path(own_folder(), "tables", paste0(name, ".csv")), colClasses = "character",
           na.strings = "", check.names = FALSE, encoding = "UTF-8", strip.white = FALSE)
}

comparisons <- read_table("comparisons")
trials <- read_table("trials")
measures <- read_table("measures")
named <- c("measure", "unit", "task", "target", "pooling", "a", "b", "p_holm_from")
for (column in setdiff(names(comparisons), named)) {
  comparisons[[column]] <- as.numeric(comparisons[[column]])
}
for (column in c("position", "failed", measures$measure)) {
  trials[[column]] <- as.numeric(trials[[column]])
}

# ---- Wilcoxon's signed-rank test -------------------------------------------------------------

# One value per person (pooled: per person and target), the mean over trials.
values_of <- function(row, interface) {
  wanted <- trials$task == row$task & trials$interface == interface & !is.na(trials[[row$measure]])
  if (row$pooling == "none") wanted <- wanted & trials$target == row$target
  some <- trials[wanted, ]
  unit <- if (row$pooling == "trials") paste(some$participant, some$target, sep = "\r")
          else some$participant
  vapply(split(some[[row$measure]], unit), mean, 0)
}

# Differences of pairs, in which magnitudes that differ by rounding alone are made equal: those
# closer than 1e-9 of the largest value; and zero, where they are that small.
differences_of <- function(x, y) {
  both <- intersect(names(x), names(y))
  x <- x[both]
  y <- y[both]
  d <- unname(x - y)
  by_size <- order(abs(d))
  shared <- 0
  before <- 0
  for (i in by_size) {
    size <- abs(d[i])
    if (size - before > tolerance * max(abs(x), abs(y))) shared <- size
    before <- size
    d[i] <- if (shared == 0) 0 else sign(d[i]) * shared
  }
  d
}

# The exact distribution of W+ given the ranks: each enters the sum with probability 1/2. Ranks
# are doubled, since ties have halves. Two-sided: twice the smaller tail, at most 1.
exact_p <- function(d) {
  ranks <- round(2 * rank(abs(d)))
  low <- min(sum(ranks[d > 0]), sum(ranks[d < 0]))
  p <- c(1, numeric(low))  # p[s + 1]: that the sum is s
  for (r in sort(ranks)) {
    if (r > low) p <- p / 2
    else p <- (p + c(numeric(r), head(p, -r))) / 2
  }
  min(1, 2 * sum(p))
}

# R's own, where it has an exact test: without ties and zeros.
exact_p_of_r <- function(d, zeros) {
  if (zeros > 0 || anyDuplicated(abs(d)) || length(d) > 1000) return(NA)
  wilcox.test(d, exact = TRUE, correct = FALSE)$p.value
}

hodges_lehmann <- function(d) {
  sums <- outer(d, d, "+")
  median(sums[lower.tri(sums, diag = TRUE)]) / 2
}

# The test of one row with R. `exact`: does the report give an exact p here?
test_of <- function(row) {
  d <- differences_of(values_of(row, row$a), values_of(row, row$b))
  signed <- d[d != 0]
  zeros <- length(d) - length(signed)
  ranks <- rank(abs(signed))
  some <- length(signed) > 0
  exact <- length(d) > 0 && !is.na(row$p_exact_two)
  data.frame(
    n = length(d), n_zero = zeros,
    W_plus = sum(ranks[signed > 0]), W_minus = sum(ranks[signed < 0]),
    p_exact_two = if (!exact) NA else if (some) exact_p(signed) else 1,
    p_of_r = if (exact && some) exact_p_of_r(signed, zeros) else NA,
    p_asym_two = if (some) wilcox.test(signed, exact = FALSE, correct = FALSE)$p.value else NA,
    hl = if (length(d) > 0) hodges_lehmann(d) else NA,
    largest = if (length(d) > 0) max(abs(d)) else 0)
}

# Holm's correction runs over the pairs of interfaces of one measure at one place.
holm_of <- function(rows, tests) {
  p <- ifelse(is.na(tests$p_exact_two), tests$p_asym_two, tests$p_exact_two)
  family <- paste(rows$measure, rows$task, rows$target, rows$pooling, sep = "\r")
  adjusted <- rep(NA_real_, length(p))
  for (one in split(seq_along(p), family)) {
    known <- one[!is.na(p[one])]
    adjusted[known] <- p.adjust(p[known], method = "holm")
  }
  adjusted
}

# Relative; an estimate counts as equal, too, where it is 1e-9 of the differences away.
differs <- function(report, r, scale = 0) {
  one_missing <- is.na(report) != is.na(r)
  far <- abs(report - r) > tolerance * pmax(abs(report), abs(r), scale)
  one_missing | (!is.na(far) & far)
}

check_wilcoxon <- function() {
  if (nrow(comparisons) == 0) {
    cat("The report has one interface: nothing is compared.\n")
    return(invisible())
  }
  rows <- seq_len(nrow(comparisons))
  tests <- do.call(rbind, lapply(rows, function(i) test_of(comparisons[i, ])))
  tests$p_holm <- holm_of(comparisons, tests)
  checked <- c("n", "n_zero", "W_plus", "W_minus", "p_exact_two", "p_asym_two", "p_holm", "hl")
  wrong <- sapply(checked, function(column) {
    differs(comparisons[[column]], tests[[column]], if (column == "hl") tests$largest else 0)
  })
  wrong <- matrix(wrong, nrow = length(rows), dimnames = list(NULL, checked))
  of_r <- !is.na(tests$p_of_r)
  wrong[of_r, "p_exact_two"] <- wrong[of_r, "p_exact_two"] |
    differs(comparisons$p_exact_two, tests$p_of_r)[of_r]
  show_wilcoxon(tests, checked)
  stop_if_wrong(tests, wrong)
  cat(sprintf("\nAll %d tests are the same in R; %d of the exact p are wilcox.test's own, too.\n",
              length(rows), sum(of_r)))
}

place_of <- function(rows) {
  target <- ifelse(is.na(rows$target), rows$pooling, rows$target)
  paste0(rows$measure, ", ", rows$task, " (", target, "): ", rows$a, " - ", rows$b)
}

# Each number of the report above R's.
show_wilcoxon <- function(tests, columns) {
  shown <- function(from, who) {
    cells <- vapply(columns, function(one) format(from[[one]], digits = 7, trim = TRUE),
                    character(nrow(from)))
    data.frame(by = who, matrix(cells, ncol = length(columns), dimnames = list(NULL, columns)),
               check.names = FALSE)
  }
  places <- place_of(comparisons)
  both <- rbind(shown(comparisons, "report"), shown(tests, "R"))
  both <- both[order(rep(seq_along(places), 2)), ]
  both <- cbind(place = as.vector(rbind(places, "")), both)
  cat("Wilcoxon signed-rank tests, differences a - b\n\n")
  options(max.print = 1e6)
  print(both, row.names = FALSE, right = FALSE)
}

stop_if_wrong <- function(tests, wrong) {
  if (!any(wrong)) return(invisible())
  found <- which(wrong, arr.ind = TRUE)
  lines <- apply(found, 1, function(at) {
    column <- colnames(wrong)[at[2]]
    sprintf("  %s, %s: report %.15g, R %.15g", place_of(comparisons[at[1], ]), column,
            comparisons[[column]][at[1]], tests[[column]][at[1]])
  })
  cat("\n", sep = "")
  stop(sprintf("%d numbers of the report differ from R's:\n", length(lines)),
       paste(head(lines, 20), collapse = "\n"), call. = FALSE)
}

# ---- mixed models ----------------------------------------------------------------------------

installed <- function(package, models) {
  if (requireNamespace(package, quietly = TRUE)) return(TRUE)
  cat(sprintf("%s is not installed, so there are no %s; install.packages(\"%s\") adds them.\n",
              package, models, package))
  FALSE
}

wanted_terms <- c("interface", "position", "previous_interface", "target", "station")

# The trials of a task with a value, fit for a model.
model_data <- function(task, value) {
  data <- trials[trials$task == task & is.finite(value), ]
  data$value <- value[trials$task == task & is.finite(value)]
  data$previous_interface[is.na(data$previous_interface)] <- "(none)"
  interfaces <- unique(c(comparisons$a, comparisons$b))  # in the order of the study
  for (column in c("participant", setdiff(wanted_terms, "position"))) {
    known <- unique(data[[column]])
    data[[column]] <- factor(data[[column]], levels = c(intersect(interfaces, known),
                                                        setdiff(known, interfaces)))
  }
  data
}

# The terms that vary; says which do not.
varying_terms <- function(data) {
  varies <- vapply(wanted_terms, function(one) length(unique(data[[one]])) > 1, TRUE)
  if (any(!varies)) {
    cat("  left out, since all trials have the same:", wanted_terms[!varies], "\n")
  }
  wanted_terms[varies]
}

formula_with <- function(terms, person) reformulate(c(terms, person), "value")

# A model that cannot be fitted is said, and the next one follows.
fit <- function(title, data, with_people, without_lme4) {
  cat("\n", title, "\n", sep = "")
  if (length(unique(data$value)) < 2) return(cat("  all values are the same: no model.\n"))
  if (nlevels(data$participant) < 2) return(cat("  one participant: no model.\n"))
  tryCatch(withCallingHandlers({
    terms <- varying_terms(data)
    model <- (if (is.null(with_people)) without_lme4 else with_people)(terms, data)
    print(round(coef(summary(model)), 5))
  }, warning = function(w) {
    cat("  note:", conditionMessage(w), "\n")
    invokeRestart("muffleWarning")
  }, message = function(m) {
    cat("  note:", conditionMessage(m))
    invokeRestart("muffleMessage")
  }), error = function(e) cat("  it could not be fitted:", conditionMessage(e), "\n"))
}

with_fixed_people <- "without lme4: participants as a fixed factor"

fit_linear <- function(title, task, value, lme4) {
  mixed <- function(terms, data) lme4::lmer(formula_with(terms, "(1 | participant)"), data)
  plain <- function(terms, data) lm(formula_with(terms, "participant"), data)
  how <- if (lme4) "linear mixed model" else paste0("linear model, ", with_fixed_people)
  fit(paste0(title, " in ", task, ": ", how), model_data(task, value), if (lme4) mixed, plain)
}

fit_failures <- function(task, lme4) {
  mixed <- function(terms, data) {
    lme4::glmer(formula_with(terms, "(1 | participant)"), data, family = binomial)
  }
  plain <- function(terms, data) glm(formula_with(terms, character()), binomial, data)
  how <- if (lme4) "binomial mixed model" else "binomial model, without lme4: without participants"
  fit(paste0("failures in ", task, ": ", how), model_data(task, trials$failed), if (lme4) mixed,
      plain)
}

fit_rating <- function(name, task, ordinal) {
  data <- model_data(task, trials[[name]])
  if (nrow(data) == 0) return(invisible())
  mixed <- function(terms, data) {
    data$value <- factor(data$value, ordered = TRUE)
    if (nlevels(data$value) < 3) stop("an ordinal model needs three different answers")
    # clmm looks for its data where the formula was made.
    model <- eval(bquote(ordinal::clmm(.(formula_with(terms, "(1 | participant)")), data = data)))
    model
  }
  plain <- function(terms, data) lm(formula_with(terms, "participant"), data)
  how <- if (ordinal) "ordinal mixed model"
         else "linear model, without ordinal: answers as numbers, participants as a fixed factor"
  fit(paste0(name, " in ", task, ": ", how), data, if (ordinal) mixed, plain)
}

fit_models <- function() {
  cat("\nModels: value ~ ", paste(wanted_terms, collapse = " + "), " + (1 | participant)\n\n", sep = "")
  lme4 <- installed("lme4", "linear and binomial mixed models")
  ordinal <- installed("ordinal", "ordinal mixed models")
  for (task in unique(trials$task)) {
    for (name in c("d_first", "d_final")) {
      # D at the start says something only where it is not given by the target alone.
      values <- trials[trials$task == task & is.finite(trials[[name]]), ]
      if (any(tapply(values[[name]], values$target, function(d) diff(range(d))) > 1e-9)) {
        fit_linear(name, task, trials[[name]], lme4)
      }
    }
    fit_linear("log time_s", task, log(trials$time_s), lme4)
    fit_failures(task, lme4)
    for (name in measures$measure[measures$kind == "rating"]) fit_rating(name, task, ordinal)
  }
}

check_wilcoxon()
fit_models()
