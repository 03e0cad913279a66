# SPDX-License-Identifier: GPL-3.0-or-later
# Analyses a study again, with R alone (no packages).
#   Rscript analysis.R [FOLDER] [OUT]
# FOLDER holds the exported trials (data/.../*_data.csv), or else the results of an analysis (confusion_long.csv, which
# has no response times, and of the patterns only those that it names); summary_r.csv, group_r.csv and anova_r.csv are
# written to OUT. Both are the present folder unless named. Their columns are those of summary.csv, group.csv and
# anova.csv.

arguments <- commandArgs(trailingOnly = TRUE)
folder <- if (length(arguments) > 0) arguments[1] else "."
out <- if (length(arguments) > 1) arguments[2] else folder
dir.create(out, showWarnings = FALSE, recursive = TRUE)

# Everything is read as text, since R would take the patterns T and F for logical values.
read <- function(file) read.csv(file, colClasses = "character", na.strings = "NA", encoding = "UTF-8")

names_of <- function(rows) {
    answers <- rows[c("stimulus", "response")]
    lapply(split(unlist(answers), rep(rows$task, 2)), function(letters) unique(letters[!is.na(letters) & letters != "NONE"]))
}

# How many patterns each task has: its letters, or more where the trials say so.
alternatives_of <- function(rows) {
    letters <- lengths(names_of(rows))
    if (!("n_alternatives" %in% names(rows)))
        return(letters)
    told <- suppressWarnings(as.numeric(rows$n_alternatives))
    told <- tapply(ifelse(is.na(told), 0, told), rows$task, max)
    setNames(pmax(letters, as.vector(told[names(letters)])), names(letters))
}

# Texts with a comma, a quote or a line end stand in quotes, those quotes twice; all others are as they are.
write_table <- function(table, name) {
    table[] <- lapply(table, function(column) {
        if (!is.character(column))
            return(column)
        special <- grepl("[\",\r\n]|^[ \t]|[ \t]$", column)
        column[special] <- paste0("\"", gsub("\"", "\"\"", column[special], fixed = TRUE), "\"")
        column
    })
    write.csv(table, file.path(out, name), row.names = FALSE, quote = FALSE)
}

files <- list.files(file.path(folder, "data"), "_task-.*_data\\.csv$", recursive = TRUE, full.names = TRUE)
keys <- c("participant_id", "task", "condition", "stimulus", "response")
if (length(files) > 0) {
    trials <- do.call(rbind, lapply(files, read))
    trials <- trials[trials$outcome %in% c("correct", "incorrect", "timeout"), ]
    alternatives <- alternatives_of(trials)
    trials <- trials[trials$phase == "test", ]
    trials$response_time_s <- as.numeric(trials$response_time_s)
    times <- trials[trials$outcome == "correct" & !is.na(trials$response_time_s), ]
    trials$response[is.na(trials$response)] <- "NONE"
    counts <- aggregate(list(count = rep(1, nrow(trials))), trials[keys], sum)
} else {
    counts <- read(file.path(folder, "confusion_long.csv"))
    alternatives <- alternatives_of(counts)
    times <- NULL
    counts <- counts[counts$phase == "test" & counts$participant_id != "GROUP", c(keys, "count")]
    counts$count <- as.numeric(counts$count)
}
counts$correct <- ifelse(counts$stimulus == counts$response, counts$count, 0)

# Information transfer of a confusion matrix, as counted, in bit.
table_of <- function(part) {
    table <- xtabs(count ~ stimulus + response, part)
    table[rowSums(table) > 0, colSums(table) > 0, drop = FALSE]
}
measured_of <- function(table) {
    share <- table / sum(table)
    expected <- outer(rowSums(share), colSums(share))
    max(0, sum(ifelse(share > 0, share * log2(share / expected), 0)))
}

# The same without what it has too much on average: jackknife over trials.
transfer_of <- function(part) {
    table <- table_of(part)
    bits <- measured_of(table)
    n <- sum(table)
    left <- 0
    for (cell in which(table > 0)) {
        others <- table
        others[cell] <- others[cell] - 1
        if (n > 1)
            left <- left + table[cell] / n * measured_of(others[rowSums(others) > 0, colSums(others) > 0, drop = FALSE])
    }
    corrected <- if (n > 1) min(bits, n * bits - (n - 1) * left) else bits
    data.frame(it_bits = bits, it_bias_bits = bits - corrected, it_corrected_bits = corrected)
}

# Of several participants: jackknife over participants (Busing, Meijer and van der Leeden 1999), and the interval of the
# true transfer; or, where the answers are too few for that, a bound.
group_transfer_of <- function(part, patterns) {
    table <- table_of(part)
    n <- sum(table)
    rows <- rowSums(table)
    bits <- measured_of(table)
    people <- split(part, part$participant_id)
    m <- length(people)
    corrected <- transfer_of(part)$it_corrected_bits
    variance <- 0
    if (m > 1) {
        own <- sapply(people, function(person) sum(person$count))
        left <- sapply(names(people), function(id) measured_of(table_of(part[part$participant_id != id, ])))
        h <- n / own
        corrected <- m * bits - sum((1 - own / n) * left)
        variance <- mean((h * bits - (h - 1) * left - corrected)^2 / (h - 1))
    }
    g <- 2 * n * log(2) * bits
    freedom <- (nrow(table) - 1) * (ncol(table) - 1)
    guessing <- freedom < 1 || pchisq(g, freedom, lower.tail = FALSE) >= 0.05
    note <- if (m < 4) "few participants"
            else if (n < patterns * max(20, 4 * patterns)) "few trials"
            else if (guessing) "like guessing"
            else if (n - sum(apply(table, 1, max)) < 10) "few different answers"
            else NA
    highest <- max(0, -sum(rows / n * log2(rows / n)))
    within <- function(value) min(max(value, 0), highest)
    ends <- c(NA, NA)
    at_least <- NA
    at_most <- NA
    if (is.na(note)) {
        half <- qt(0.975, m - 1) * sqrt(variance)
        ends <- c(within(corrected - half), within(corrected + half))
    } else if (note == "few different answers") {
        wrong <- n - sum(part$correct)
        off <- sapply(people, function(person) sum(person$count) * (1 - wrong / n) - sum(person$correct))
        effect <- if (wrong > 0 && wrong < n)
                      max(1, sum(off^2 / (sapply(people, function(person) sum(person$count)) * wrong / n * (1 - wrong / n))) / (m - 1))
                  else 1
        e <- if (wrong < n) qbeta(0.95, wrong / effect + 1, (n - wrong) / effect) else 1
        r <- nrow(table)
        at_least <- if (r < 2 || e >= (r - 1) / r) 0
                    else max(0, highest + e * log2(e) + (1 - e) * log2(1 - e) - e * log2(r - 1))
    } else {
        logarithms <- log2(sweep(table / rows, 2, colSums(table) / n, "/"))
        terms <- function(power) rowSums(ifelse(table > 0, table / rows * logarithms^power, 0))
        trials <- sum(ifelse(rows > 1, pmax(0, terms(2) - terms(1)^2) * rows / (rows - 1) * rows / n^2, 0))
        most <- bits + qnorm(0.95) * sqrt(max(variance, trials))
        if (guessing) {
            g <- max(g, freedom)
            lambda <- uniroot(function(x) pchisq(g, max(1, freedom), x) - 0.05, c(0, 4 * (g + 10)), tol = 1e-12)$root
            most <- max(most, lambda / 2 / log(2) / n)
        }
        at_most <- within(most)
    }
    data.frame(it_bits = bits, it_bias_bits = bits - corrected, it_corrected_bits = corrected,
               it_few_trials = as.integer(n < 5 * patterns^2), it_lo = ends[1], it_hi = ends[2], it_at_least = at_least,
               it_at_most = at_most, it_note = note)
}

# Participants: accuracy with Wilson's and the exact interval, and against chance.
summary_of <- function(part) {
    n <- sum(part$count)
    x <- sum(part$correct)
    wilson <- suppressWarnings(prop.test(x, n, correct = FALSE))$conf.int
    exact <- binom.test(x, n)$conf.int
    own <- times$response_time_s[times$participant_id == part$participant_id[1] & times$task == part$task[1] &
                                 times$condition == part$condition[1]]
    cbind(data.frame(participant_id = part$participant_id[1], task = part$task[1], condition = part$condition[1],
                     n = n, n_correct = x, n_timeout = sum(part$count[part$response == "NONE"]), accuracy = x / n,
                     wilson_lo = wilson[1], wilson_hi = wilson[2], cp_lo = exact[1], cp_hi = exact[2],
                     p_chance = pbinom(x - 1, n, 1 / alternatives[[part$task[1]]], lower.tail = FALSE)),
          transfer_of(part),
          data.frame(rt_median_s = if (length(own) > 0) median(own) else NA,
                     rt_n = if (is.null(times)) NA else length(own)))
}
summaries <- do.call(rbind, lapply(split(counts, counts[c("participant_id", "task", "condition")], drop = TRUE),
                                   summary_of))

# Groups: the interval of the mean over participants from Student's t, and the transfer of all answers together.
group_of <- function(part) {
    own <- summaries[summaries$task == part$task[1] & summaries$condition == part$condition[1], ]
    m <- nrow(own)
    deviation <- if (m > 1) sd(own$accuracy) else NA
    half <- if (m > 1) qt(0.975, m - 1) * deviation / sqrt(m) else NA
    patterns <- alternatives[[part$task[1]]]
    cbind(data.frame(task = part$task[1], condition = part$condition[1], participants = m,
                     accuracy_mean = mean(own$accuracy), accuracy_sd = deviation, t_lo = mean(own$accuracy) - half,
                     t_hi = mean(own$accuracy) + half, n = sum(part$count)),
          group_transfer_of(part, patterns))
}
groups <- do.call(rbind, lapply(split(counts, counts[c("task", "condition")], drop = TRUE), group_of))

# ANOVA within participants of the share of correct answers in each cell.
# cells: one row a participant; contrasts: orthonormal columns of the effect; errors: sums of squares of all errors.
epsilons_of <- function(cells, contrasts) {
    k <- ncol(contrasts)
    if (k == 1)
        return(c(1, 1))
    covariance <- cov(cells %*% contrasts)
    gg <- sum(diag(covariance))^2 / (k * sum(covariance^2))
    n <- nrow(cells)
    denominator <- k * (n - 1 - k * gg)
    c(gg, if (denominator > 1e-12) min(1, (n * k * gg - 2) / denominator) else NA)
}

differences <- function(levels) {
    helmert <- contr.helmert(levels)
    sweep(helmert, 2, sqrt(colSums(helmert^2)), "/")
}
averages <- function(levels) matrix(1 / sqrt(levels), levels, 1)

line_of <- function(task, effect, stimulus, table, corrected, cells, contrasts, errors) {
    if (table[2, "Sum Sq"] <= 1e-20)
        return(NULL)
    epsilons <- epsilons_of(cells, contrasts)
    data.frame(task = task, effect = effect, stimulus = stimulus, df1 = table[1, "Df"], df2 = table[2, "Df"],
               ss = table[1, "Sum Sq"], ss_error = table[2, "Sum Sq"], f = table[1, "F value"],
               p = table[1, "Pr(>F)"], eps_gg = epsilons[1],
               p_gg = if (is.null(corrected)) table[1, "Pr(>F)"] else corrected[1, "G-G Pr"],
               eps_hf = epsilons[2],
               p_hf = if (is.null(corrected)) table[1, "Pr(>F)"] else corrected[1, "H-F Pr"],
               partial_eta2 = table[1, "Sum Sq"] / sum(table[, "Sum Sq"]),
               generalized_eta2 = table[1, "Sum Sq"] / (table[1, "Sum Sq"] + errors), n = nrow(cells))
}

anova_of <- function(part) {
    task <- part$task[1]
    totals <- aggregate(part[c("count", "correct")], part[c("participant_id", "condition", "stimulus")], sum)
    totals$y <- totals$correct / totals$count
    conditions <- sort(unique(totals$condition))
    patterns <- sort(unique(totals$stimulus))
    people <- sort(unique(totals$participant_id))
    design <- expand.grid(p = patterns, c = conditions, stringsAsFactors = TRUE)
    value <- function(person, condition, pattern) {
        y <- totals$y[totals$participant_id == person & totals$condition == condition & totals$stimulus == pattern]
        if (length(y) == 1) y else NA
    }
    cells <- t(sapply(people, function(person) mapply(value, person, as.character(design$c), as.character(design$p))))
    complete <- cells[rowSums(is.na(cells)) == 0, , drop = FALSE]
    n <- nrow(complete)
    kinds <- c(length(conditions), length(patterns))
    lines <- NULL
    one_way <- function(effect, stimulus, columns) {
        columns <- columns[rowSums(is.na(columns)) == 0, , drop = FALSE]
        m <- nrow(columns)
        if (m < 2)
            return(NULL)
        levels <- factor(seq_len(ncol(columns)))
        long <- data.frame(y = as.vector(columns), s = factor(rep(seq_len(m), ncol(columns))), c = rep(levels, each = m))
        fit <- summary(aov(y ~ c + Error(s / c), data = long))
        table <- fit[["Error: s:c"]][[1]]
        line_of(task, effect, stimulus, table,
                if (ncol(columns) > 2) anova(lm(columns ~ 1), M = ~c, X = ~1, idata = data.frame(c = levels),
                                             test = "Spherical"),
                columns, differences(ncol(columns)),
                table[2, "Sum Sq"] + fit[["Error: s"]][[1]]["Residuals", "Sum Sq"])
    }
    if (length(conditions) == 1 && length(patterns) > 1)
        return(one_way("pattern", NA, cells))
    if (n >= 2 && length(conditions) >= 2) {
        long <- data.frame(y = as.vector(complete), s = factor(rep(seq_len(n), ncol(complete))),
                           c = rep(design$c, each = n), p = rep(design$p, each = n))
        fit <- summary(aov(y ~ c * p + Error(s / (c * p)), data = long))
        model <- lm(complete ~ 1)
        corrected <- function(M, X) anova(model, M = M, X = X, idata = design, test = "Spherical")
        several <- kinds[1] > 2
        errors <- sum(sapply(fit, function(stratum) stratum[[1]]["Residuals", "Sum Sq"]))
        two_way <- function(effect, stratum, first, second, corrected)
            line_of(task, effect, NA, fit[[stratum]][[1]], corrected, complete, kronecker(first, second), errors)
        lines <- rbind(
            two_way("condition", "Error: s:c", differences(kinds[1]), averages(kinds[2]), if (several) corrected(~c, ~1)),
            two_way("pattern", "Error: s:p", averages(kinds[1]), differences(kinds[2]),
                    if (kinds[2] > 2) corrected(~c + p, ~c)),
            two_way("condition:pattern", "Error: s:c:p", differences(kinds[1]), differences(kinds[2]),
                    if (several || kinds[2] > 2) corrected(~c * p, ~c + p)))
    }
    for (pattern in if (length(conditions) >= 2) patterns)
        lines <- rbind(lines, one_way("condition", pattern, cells[, design$p == pattern, drop = FALSE]))
    lines
}
anovas <- do.call(rbind, lapply(split(counts, counts$task), anova_of))

write_table(groups, "group_r.csv")
write_table(summaries, "summary_r.csv")
if (!is.null(anovas)) {
    write_table(anovas, "anova_r.csv")
    print(anovas, row.names = FALSE, digits = 4)
}
