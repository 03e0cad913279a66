# SPDX-License-Identifier: GPL-3.0-or-later
# Analyses a study again, with R alone (no packages).
#   Rscript analysis.R [FOLDER] [OUT]
# FOLDER holds the exported trials (data/.../*_data.csv), or else the results of an analysis (confusion_long.csv);
# summary_r.csv and anova_r.csv are written to OUT. Both are the present folder unless named.

arguments <- commandArgs(trailingOnly = TRUE)
folder <- if (length(arguments) > 0) arguments[1] else "."
out <- if (length(arguments) > 1) arguments[2] else folder
dir.create(out, showWarnings = FALSE, recursive = TRUE)

# Everything is read as text, since R would take the patterns T and F for logical values.
read <- function(file) read.csv(file, colClasses = "character", na.strings = "NA", encoding = "UTF-8")

files <- list.files(file.path(folder, "data"), "_task-.*_data\\.csv$", recursive = TRUE, full.names = TRUE)
keys <- c("participant_id", "task", "condition", "stimulus", "response")
if (length(files) > 0) {
    trials <- do.call(rbind, lapply(files, read))
    trials <- trials[trials$phase == "test" & trials$outcome %in% c("correct", "incorrect", "timeout"), ]
    trials$response[is.na(trials$response)] <- "NONE"
    counts <- aggregate(list(count = rep(1, nrow(trials))), trials[keys], sum)
} else {
    counts <- read(file.path(folder, "confusion_long.csv"))
    counts <- counts[counts$phase == "test" & counts$participant_id != "GROUP", c(keys, "count")]
    counts$count <- as.numeric(counts$count)
}
counts$correct <- ifelse(counts$stimulus == counts$response, counts$count, 0)

# Participants: accuracy with Wilson's and the exact interval.
summary_of <- function(part) {
    n <- sum(part$count)
    x <- sum(part$correct)
    wilson <- suppressWarnings(prop.test(x, n, correct = FALSE))$conf.int
    exact <- binom.test(x, n)$conf.int
    data.frame(participant_id = part$participant_id[1], task = part$task[1], condition = part$condition[1], n = n,
               n_correct = x, accuracy = x / n, wilson_lo = wilson[1], wilson_hi = wilson[2], cp_lo = exact[1],
               cp_hi = exact[2])
}
summaries <- do.call(rbind, lapply(split(counts, counts[c("participant_id", "task", "condition")], drop = TRUE),
                                   summary_of))

# ANOVA within participants of the share of correct answers in each cell.
line_of <- function(task, effect, stimulus, table, corrected) {
    if (table[2, "Sum Sq"] <= 1e-20)
        return(NULL)
    data.frame(task = task, effect = effect, stimulus = stimulus, df1 = table[1, "Df"], df2 = table[2, "Df"],
               ss = table[1, "Sum Sq"], ss_error = table[2, "Sum Sq"], f = table[1, "F value"],
               p = table[1, "Pr(>F)"],
               p_gg = if (is.null(corrected)) table[1, "Pr(>F)"] else corrected[1, "G-G Pr"],
               p_hf = if (is.null(corrected)) table[1, "Pr(>F)"] else corrected[1, "H-F Pr"])
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
    lines <- NULL
    if (n >= 2 && length(conditions) >= 2) {
        long <- data.frame(y = as.vector(complete), s = factor(rep(seq_len(n), ncol(complete))),
                           c = rep(design$c, each = n), p = rep(design$p, each = n))
        fit <- summary(aov(y ~ c * p + Error(s / (c * p)), data = long))
        model <- lm(complete ~ 1)
        corrected <- function(M, X) anova(model, M = M, X = X, idata = design, test = "Spherical")
        several <- length(conditions) > 2
        lines <- rbind(
            line_of(task, "condition", NA, fit[["Error: s:c"]][[1]], if (several) corrected(~c, ~1)),
            line_of(task, "pattern", NA, fit[["Error: s:p"]][[1]],
                    if (length(patterns) > 2) corrected(~c + p, ~c)),
            line_of(task, "condition:pattern", NA, fit[["Error: s:c:p"]][[1]],
                    if (several || length(patterns) > 2) corrected(~c * p, ~c + p)))
        for (pattern in patterns) {
            columns <- cells[, design$p == pattern, drop = FALSE]
            columns <- columns[rowSums(is.na(columns)) == 0, , drop = FALSE]
            m <- nrow(columns)
            if (m < 2)
                next
            long <- data.frame(y = as.vector(columns), s = factor(rep(seq_len(m), ncol(columns))),
                               c = factor(rep(conditions, each = m)))
            table <- summary(aov(y ~ c + Error(s / c), data = long))[["Error: s:c"]][[1]]
            within <- data.frame(c = factor(conditions))
            lines <- rbind(lines, line_of(task, "condition", pattern, table,
                                          if (several) anova(lm(columns ~ 1), M = ~c, X = ~1, idata = within,
                                                             test = "Spherical")))
        }
    }
    lines
}
anovas <- do.call(rbind, lapply(split(counts, counts$task), anova_of))

write.csv(summaries, file.path(out, "summary_r.csv"), row.names = FALSE, quote = FALSE)
if (!is.null(anovas)) {
    write.csv(anovas, file.path(out, "anova_r.csv"), row.names = FALSE, quote = FALSE)
    print(anovas, row.names = FALSE, digits = 4)
}
