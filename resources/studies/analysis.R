# SPDX-License-Identifier: GPL-3.0-or-later
# Analyses a study again, with R alone (no packages).
#   Rscript analysis.R [FOLDER] [OUT]
# FOLDER holds the exported trials (data/.../*_data.csv), or else the results of an analysis (confusion_long.csv, which
# has no response times, and of the patterns only those that it names); summary_r.csv, group_r.csv, anova_r.csv,
# comparisons_r.csv, ranks_r.csv, binomial_model_r.csv and response_times_r.csv are written to OUT. Both are the present
# folder unless named. Their columns are those of the files without _r. Tasks with levels also give thresholds_r.csv and
# sdt_r.csv. Where the package lme4 is installed, it fits the binomial model once more.

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

# Tasks with levels: psychometric functions and signal detection, from the trials or from levels.csv and sdt.csv.
# p of the deviance and what adaptive procedures themselves estimate are not computed here.
levels_of_trials <- function(trials) {
    if (!all(c("design", "level") %in% names(trials)))
        return(NULL)
    trials <- trials[!is.na(trials$level) & !is.na(trials$design) & trials$design != "identification", ]
    if ("excluded" %in% names(trials))
        trials <- trials[is.na(trials$excluded), ]
    if (nrow(trials) == 0)
        return(NULL)
    trials$level <- as.numeric(trials$level)
    trials$reference <- as.numeric(trials$reference)
    equal <- abs(trials$level - trials$reference) <= 1e-9 * abs(trials$reference)
    right <- !is.na(trials$response) & trials$response == trials$stimulus
    more <- trials$level >= trials$reference | equal
    trials$positive <- ifelse(trials$design == "yes_no", trials$response %in% "yes",
                       ifelse(trials$design == "same_different", trials$response %in% "different",
                       ifelse(trials$design == "compare", right == more, right)))
    trials$counts <- !(trials$design == "yes_no" & trials$stimulus == "no") &
                     !(trials$design == "same_different" & trials$stimulus == "same")
    trials[trials$design != "compare" | !is.na(trials$response), ]
}

place_columns <- c("participant_id", "task", "condition", "track")
split_places <- function(rows) split(rows, rows[place_columns], drop = TRUE)

level_table_of <- function(part) {
    shown <- part[part$counts, ]
    if (nrow(shown) == 0)
        return(NULL)
    design <- shown$design[1]
    none <- part[!part$counts, ]
    scale <- if (shown$level_unit[1] %in% c("drive", NA) && design != "compare" && min(shown$level) > 0) "log10" else "linear"
    guess <- if (design == "interval") 1 / as.numeric(shown$n_alternatives[1])
             else if (design == "compare") NA
             else if (nrow(none) > 0) (sum(none$positive) + 0.5) / (nrow(none) + 1)
             else 0.02
    n <- aggregate(cbind(n = 1, n_positive = as.numeric(positive)) ~ level, shown, sum)
    cbind(shown[rep(1, nrow(n)), c(place_columns, "design")], "function" = if (scale == "log10") "weibull" else "gauss",
          scale = scale, guess = guess, lapse_lo = 0, lapse_hi = 0.06, level = n$level,
          level_unit = shown$level_unit[1], reference = shown$reference[1], n = n$n, n_positive = n$n_positive)
}

# F and 1 - F, without cancellation.
rise_of <- function(name, x, t, s, complement = FALSE)
    switch(name, gauss = pnorm(x, t, s, lower.tail = !complement), logistic = plogis(x, t, s, lower.tail = !complement),
           weibull = {
               u <- ifelse(x > 0, exp(pmin(s * log(pmax(x, 1e-300) / t), 700)), 0) * log(2)
               if (complement) exp(-u) else -expm1(-u)
           })

fit_of <- function(part) {
    name <- part[["function"]][1]
    x <- part$level
    n <- part$n
    k <- part$n_positive
    guess <- part$guess[1]
    middle <- if (is.na(guess)) 0.5 else (1 + guess) / 2
    free <- part$lapse_hi[1] > part$lapse_lo[1]
    line <- data.frame(part[1, c(place_columns, "design", "function")], n = sum(n), threshold = NA, lo = NA, hi = NA,
                       interval = "profile", unit = part$level_unit[1], spread = NA, guess = guess,
                       lapse = if (free) NA else part$lapse_lo[1], deviance = NA, jnd = NA, weber = NA, pse = NA,
                       note = NA, check.names = FALSE)
    said <- function(note) {
        line$note <- note
        line
    }
    log_scale <- part$scale[1] == "log10" || name == "weibull"
    if (log_scale && max(x) <= 0)
        return(said("levelsNotAbove0"))
    rank <- seq_along(x) - 1
    share <- sum(k) / sum(n)
    trend <- share * (1 - share) * (sum(n * rank^2) - sum(n * rank)^2 / sum(n))
    if (trend > 0 && (sum(rank * k) - share * sum(n * rank)) / sqrt(trend) < -1.96)
        return(said("falls"))
    if (length(x) < 2 + free)
        return(said("tooFewLevels"))
    range <- max(x) - min(x)
    gap <- min(diff(x))
    positive <- min(x[x > 0 | !log_scale])
    ends <- if (part$scale[1] == "log10") c(positive / 10, max(x) * 10)
            else c(if (log_scale) max(min(x) - range, positive / 10) else min(x) - range, max(x) + range)
    if (log_scale)
        ends <- log(ends)
    spreads <- log(if (name == "weibull") c(0.3, 60) else c(gap / 20, 10 * range))
    low <- c(ends[1], spreads[1], part$lapse_lo[1])
    high <- c(ends[2], spreads[2], part$lapse_hi[1])
    term <- function(count, p) sum(ifelse(count == 0, 0, count * log(pmax(p, 1e-100))))
    minus <- function(at) {
        t <- if (log_scale) exp(at[1]) else at[1]
        g <- if (is.na(guess)) at[3] else guess
        rising <- 1 - g - at[3]
        -term(k, g + rising * rise_of(name, x, t, exp(at[2]))) -
            term(n - k, at[3] + rising * rise_of(name, x, t, exp(at[2]), TRUE))
    }
    # Parameters with `held` in place of NA are searched from the best points of a grid, never from one start.
    search <- function(held = c(NA, NA, if (free) NA else low[3]), also = NULL) {
        open <- which(is.na(held))
        inner <- if (log_scale) log(c(positive, max(x))) else range(x)
        values <- list(if (is.na(held[1])) c(seq(inner[1], inner[2], length.out = 14), seq(inner[1], low[1], length.out = 4)[-1],
                                             seq(inner[2], high[1], length.out = 4)[-1]) else held[1],
                       if (is.na(held[2])) low[2] + (seq_len(10) - 0.5) / 10 * (high[2] - low[2]) else held[2],
                       if (is.na(held[3])) low[3] + (seq_len(4) - 0.5) / 4 * (high[3] - low[3]) else held[3])
        grid <- as.matrix(expand.grid(values))
        starts <- grid[order(apply(grid, 1, minus))[seq_len(min(3, nrow(grid)))], , drop = FALSE]
        if (!is.null(also))
            starts <- rbind(also, starts)
        best <- list(value = Inf)
        for (i in seq_len(nrow(starts))) {
            put <- function(some) replace(ifelse(is.na(held), 0, held), open, some)
            end <- nlminb(starts[i, open], function(some) minus(put(some)), lower = low[open], upper = high[open],
                          control = list(rel.tol = 1e-13, x.tol = 1e-11, iter.max = 500, eval.max = 1000))
            if (end$objective < best$value)
                best <- list(value = end$objective, at = put(end$par))
        }
        best
    }
    best <- search()
    constant <- -term(k, share) - term(n - k, 1 - share)
    exact <- binom.test(sum(k), sum(n))$conf.int
    if (2 * (constant - best$value) < qchisq(0.95, 1))
        return(said(if (exact[1] > middle) sprintf("belowRange (below %s)", format(min(x), digits = 15))
                    else if (exact[2] < middle) sprintf("aboveRange (above %s)", format(max(x), digits = 15))
                    else "noRise"))
    t_of <- function(parameter) if (log_scale) exp(parameter) else parameter
    outside <- function(t) if (t < min(x) * (1 - 1e-9)) sprintf("belowRange (below %s)", format(min(x), digits = 15))
                           else if (t > max(x) * (1 + 1e-9)) sprintf("aboveRange (above %s)", format(max(x), digits = 15))
    t <- t_of(best$at[1])
    if (!is.null(outside(t)))
        return(said(outside(t)))
    lapse_held <- if (free) NA else low[3]
    step <- any(sapply(c(low[2], high[2]), function(limit) search(c(NA, limit, lapse_held), best$at)$value - best$value < 1e-6))
    excess <- function(parameter) 2 * (search(c(parameter, NA, lapse_held), best$at)$value - best$value) - qchisq(0.95, 1)
    # Outwards in twentieths of the way to the limit, as far as the profile stays close.
    end_of <- function(limit) {
        before <- best$at[1]
        for (share in (seq_len(40) / 40)^2) {
            at <- best$at[1] + share * (limit - best$at[1])
            if (excess(at) > 0)
                return(t_of(uniroot(excess, sort(c(before, at)), tol = 1e-10)$root))
            before <- at
        }
        NA
    }
    line$lo <- end_of(low[1])
    line$hi <- end_of(high[1])
    if (step) {
        t <- if (part$scale[1] == "log10") sqrt(line$lo * line$hi) else (line$lo + line$hi) / 2
        if (!is.na(t) && !is.null(outside(t))) {
            line$lo <- NA
            line$hi <- NA
            return(said(outside(t)))
        }
    }
    line$threshold <- t
    line$lapse <- best$at[3]
    line$guess <- if (is.na(guess)) best$at[3] else guess
    own <- k / n
    line$deviance <- max(0, 2 * (best$value + term(k, own) + term(n - k, 1 - own)))
    if (part$design[1] %in% "compare")
        line$pse <- t
    if (step)
        return(said("slopeAtLimit"))
    line$spread <- exp(best$at[2])
    if (part$design[1] %in% "compare") {
        quarter <- switch(name, gauss = qnorm(0.75) * line$spread, logistic = log(3) * line$spread,
                          weibull = t * ((log(4) / log(2))^(1 / line$spread) - (log(4 / 3) / log(2))^(1 / line$spread)) / 2)
        line$jnd <- quarter
        if (part$reference[1] != 0)
            line$weber <- quarter / part$reference[1]
    }
    if (free && best$at[3] > high[3] - 1e-6) said("lapseAtLimit") else line
}

group_threshold_of <- function(lines, scales) {
    log_scale <- scales == "log10"
    known <- lines$threshold[!is.na(lines$threshold)]
    places <- if (log_scale) log10(known) else known
    back <- function(value) if (log_scale) 10^value else value
    m <- length(places)
    half <- if (m > 1) qt(0.975, m - 1) * sd(places) / sqrt(m) else NA
    group <- lines[1, ]
    group[] <- NA
    same <- c("task", "condition", "track", "design", "function", "unit")
    group[same] <- lines[1, same]
    group$participant_id <- "GROUP"
    group$interval <- "t"
    group$n <- m
    if (m > 0) {
        group$threshold <- back(mean(places))
        group$lo <- back(mean(places) - half)
        group$hi <- back(mean(places) + half)
    }
    average <- function(values) if (any(!is.na(values))) mean(values, na.rm = TRUE) else NA
    group$jnd <- average(lines$jnd)
    group$weber <- average(lines$weber)
    if (lines$design[1] %in% "compare")
        group$pse <- group$threshold
    if (m < nrow(lines))
        group$note <- sprintf("%d of %d without threshold", nrow(lines) - m, nrow(lines))
    group
}

# The fit of all participants at once: Psi = g + (1 - g - l) Phi(b1 (x - t) + s z), z of each participant from N(0, 1).
# NULL: fewer than five, or no rise with a finite slope.
together_of <- function(part) {
    log_scale <- part$scale[1] == "log10"
    part <- part[!log_scale | part$level > 0, ]
    people <- unique(part$participant_id)
    x <- if (log_scale) log10(part$level) else part$level
    span <- diff(range(x))
    if (length(people) < 5 || !(span > 0))
        return(NULL)
    x <- (x - min(x)) / span
    lapse <- if (part$lapse_hi[1] > part$lapse_lo[1]) 0.02 else part$lapse_lo[1]
    guesses <- part$guess[match(people, part$participant_id)]
    guess <- mean(ifelse(is.na(guesses), lapse, guesses))
    # The integral over z by the trapezoidal rule, which is exact enough for so smooth a curve that ends in zeros.
    step <- 0.02
    z <- seq(-8.5, 8.5, step)
    person <- factor(part$participant_id)
    minus <- function(t, slope, s) {
        eta <- outer(slope * (x - t), s * z, "+")
        right <- guess + (1 - guess - lapse) * pnorm(eta)
        wrong <- lapse + (1 - guess - lapse) * pnorm(eta, lower.tail = FALSE)
        rows <- part$n_positive * log(pmax(right, 1e-300)) + (part$n - part$n_positive) * log(pmax(wrong, 1e-300))
        heights <- sweep(rowsum(rows, person), 2, z^2 / 2)
        most <- apply(heights, 1, max)
        -sum(most + log(rowSums(exp(heights - most)) * step / sqrt(2 * pi)))
    }
    search <- function(start, t = NULL) {
        open <- function(at) if (is.null(t)) minus(at[1], exp(at[2]), at[3]) else minus(t, exp(at[1]), at[2])
        low <- c(if (is.null(t)) -1, log(1e-3), 0)
        high <- c(if (is.null(t)) 2, log(60), 30)
        nlminb(start, open, lower = low, upper = high, control = list(rel.tol = 1e-12, iter.max = 300))
    }
    grid <- as.matrix(expand.grid(c(0.2, 0.5, 0.8), log(c(2, 6, 20)), c(0.3, 1.5)))
    first <- which.min(apply(grid, 1, function(at) minus(at[1], exp(at[2]), at[3])))
    best <- search(grid[first, ])
    slope <- exp(best$par[2])
    if (slope > 59.9 || slope < 2e-3)
        return(NULL)
    excess <- function(t) 2 * (search(best$par[2:3], t)$objective - best$objective) - qchisq(0.95, 1)
    end_of <- function(limit) {
        if (excess(limit) <= 0)
            return(NA)
        uniroot(excess, sort(c(best$par[1], limit)), tol = 1e-8)$root
    }
    shown <- if (log_scale) log10(part$level) else part$level
    back <- function(t) if (log_scale) 10^(min(shown) + span * t) else min(shown) + span * t
    list(threshold = back(best$par[1]), lo = back(end_of(-1)), hi = back(end_of(2)), sd = span * best$par[3] / slope,
         n = length(people), guess = guess, lapse = lapse)
}

group_together_of <- function(part, lines) {
    fit <- together_of(part)
    if (is.null(fit))
        return(NULL)
    row <- lines[1, ]
    row[] <- NA
    same <- c("task", "condition", "track", "design", "unit")
    row[same] <- lines[1, same]
    row$participant_id <- "GROUP"
    row[["function"]] <- "gauss"
    row$interval <- "profile"
    numbers <- c("n", "threshold", "lo", "hi", "guess", "lapse")
    row[numbers] <- fit[numbers]
    if (lines$design[1] %in% "compare")
        row$pse <- fit$threshold
    row$note <- sprintf("hierarchical; sd of participants %s", format(fit$sd, digits = 15))
    row
}

# Counts of each track for signal detection.
detection_counts_of <- function(part) {
    design <- part$design[1]
    row <- data.frame(part[1, place_columns], hits = NA, n_signal = NA, false_alarms = NA, n_noise = NA, method = NA)
    m <- as.numeric(part$n_alternatives[1])
    if (design == "interval" && m > 2) {
        row$hits <- sum(part$positive)
        row$n_signal <- nrow(part)
        row$method <- sprintf("%d intervals", m)
        return(row)
    }
    signal <- switch(design, yes_no = "yes", same_different = "different", interval = "1")
    said <- part$response %in% signal
    row$hits <- sum(said & part$stimulus == signal)
    row$n_signal <- sum(part$stimulus == signal)
    row$false_alarms <- sum(said & part$stimulus != signal)
    row$n_noise <- sum(part$stimulus != signal)
    row$method <- switch(design, yes_no = "yes/no", interval = "2 intervals",
                         same_different = if (length(unique(part$level[part$counts])) <= 1) "independent" else "differencing")
    row
}

detection_of <- function(row) {
    result <- data.frame(dprime = NA, lo = NA, hi = NA, c = NA)
    if (grepl("intervals", row$method) && is.na(row$n_noise)) {
        m <- as.numeric(sub(" .*", "", row$method))
        share <- function(d) integrate(function(u) dnorm(u - d) * pnorm(u)^(m - 1), d - 9, d + 9, rel.tol = 1e-11)$value
        solve <- function(p) if (p <= 0 || p >= 1) NA else uniroot(function(d) share(d) - p, c(-20, 20), tol = 1e-11)$root
        wilson <- suppressWarnings(prop.test(row$hits, row$n_signal, correct = FALSE))$conf.int
        result$dprime <- solve((row$hits + 1 / m) / (row$n_signal + 1))
        ends <- sapply(wilson, solve)
        if (!anyNA(ends))
            result[c("lo", "hi")] <- ends
        return(result)
    }
    if (row$n_signal == 0 || row$n_noise == 0)
        return(result)
    h <- (row$hits + 0.5) / (row$n_signal + 1)
    f <- (row$false_alarms + 0.5) / (row$n_noise + 1)
    z <- qnorm(c(h, f))
    if (grepl("differencing|independent", row$method)) {
        result$dprime <- if (h <= f) 0
            else if (grepl("independent", row$method)) 2 * qnorm((1 + sqrt(2 * pnorm((z[1] - z[2]) / 2) - 1)) / 2)
            else {
                k <- -sqrt(2) * qnorm(f / 2)
                uniroot(function(d) pnorm((d - k) / sqrt(2)) + pnorm((-d - k) / sqrt(2)) - h, c(0, 40), tol = 1e-11)$root
            }
        return(result)
    }
    deviation <- sqrt(h * (1 - h) / (row$n_signal * dnorm(z[1])^2) + f * (1 - f) / (row$n_noise * dnorm(z[2])^2))
    factor <- if (row$method == "2 intervals") sqrt(2) else 1
    result$dprime <- (z[1] - z[2]) / factor
    result$lo <- (z[1] - z[2] - qnorm(0.975) * deviation) / factor
    result$hi <- (z[1] - z[2] + qnorm(0.975) * deviation) / factor
    result$c <- -sum(z) / 2
    result
}

write_levels <- function(level_trials) {
    if (!is.null(level_trials)) {
        table <- do.call(rbind, lapply(split_places(level_trials), level_table_of))
        detectable <- level_trials[level_trials$design != "compare", ]
        detection <- if (nrow(detectable) > 0) do.call(rbind, lapply(split_places(detectable), detection_counts_of))
    } else if (file.exists(file.path(folder, "levels.csv"))) {
        table <- read(file.path(folder, "levels.csv"))
        names(table)[names(table) == "function."] <- "function"
        numbers <- c("guess", "lapse_lo", "lapse_hi", "level", "reference", "n", "n_positive")
        table[numbers] <- lapply(table[numbers], as.numeric)
        detection <- if (file.exists(file.path(folder, "sdt.csv"))) read(file.path(folder, "sdt.csv"))
        if (!is.null(detection)) {
            detection <- detection[detection$participant_id != "GROUP", ]
            counted <- c("hits", "n_signal", "false_alarms", "n_noise")
            detection[counted] <- lapply(detection[counted], as.numeric)
        }
    } else {
        return()
    }
    if (is.null(table))
        return()
    parts <- split_places(table)
    lines <- do.call(rbind, lapply(parts, fit_of))
    scales <- sapply(parts, function(part) part$scale[1])
    together <- lines[c("task", "condition", "track")]
    groups <- lapply(split(seq_len(nrow(lines)), together, drop = TRUE),
                     function(rows) rbind(group_threshold_of(lines[rows, ], scales[rows[1]]),
                                          group_together_of(do.call(rbind, parts[rows]), lines[rows, ])))
    write_table(rbind(lines, do.call(rbind, groups)), "thresholds_r.csv")
    if (is.null(detection) || nrow(detection) == 0)
        return()
    detected <- cbind(detection[c(place_columns, "hits", "n_signal", "false_alarms", "n_noise")],
                      do.call(rbind, lapply(split(detection, seq_len(nrow(detection))), detection_of)),
                      method = detection$method)
    means <- lapply(split(detected, detected[c("task", "condition", "track")], drop = TRUE), function(own) {
        values <- own$dprime[!is.na(own$dprime)]
        m <- length(values)
        half <- if (m > 1) qt(0.975, m - 1) * sd(values) / sqrt(m) else NA
        group <- own[1, ]
        group[] <- NA
        group[c("task", "condition", "track")] <- own[1, c("task", "condition", "track")]
        group$participant_id <- "GROUP"
        group$method <- "t"
        if (m > 0)
            group[c("dprime", "lo", "hi")] <- mean(values) + c(0, -half, half)
        group
    })
    write_table(rbind(detected, do.call(rbind, means)), "sdt_r.csv")
}

files <- list.files(file.path(folder, "data"), "_task-.*_data\\.csv$", recursive = TRUE, full.names = TRUE)
keys <- c("participant_id", "task", "condition", "stimulus", "response")
if (length(files) > 0) {
    trials <- do.call(rbind, lapply(files, read))
    trials <- trials[trials$outcome %in% c("correct", "incorrect", "timeout"), ]
    # What an exclusion rule has taken out does not count.
    if ("excluded" %in% names(trials))
        trials <- trials[is.na(trials$excluded), ]
    alternatives <- alternatives_of(trials)
    trials <- trials[trials$phase == "test", ]
    trials$response_time_s <- as.numeric(trials$response_time_s)
    times <- trials[trials$outcome == "correct" & !is.na(trials$response_time_s), ]
    write_levels(levels_of_trials(trials))
    trials$response[is.na(trials$response)] <- "NONE"
    counts <- aggregate(list(count = rep(1, nrow(trials))), trials[keys], sum)
} else {
    write_levels(NULL)
    # The results of a fit alone have no confusion matrices.
    if (!file.exists(file.path(folder, "confusion_long.csv")) && file.exists(file.path(folder, "levels.csv")))
        quit(save = "no")
    counts <- read(file.path(folder, "confusion_long.csv"))
    alternatives <- alternatives_of(counts)
    times <- NULL
    counts <- counts[counts$phase == "test" & counts$participant_id != "GROUP", c(keys, "count")]
    if (nrow(counts) == 0)
        quit(save = "no")
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
            lambda <- if (pchisq(g, max(1, freedom)) <= 0.05) 0
                      else uniroot(function(x) pchisq(g, max(1, freedom), x) - 0.05, c(0, 4 * (g + 10)), tol = 1e-12)$root
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
    # A share is 0 .. 1, and so is the mean of shares.
    patterns <- alternatives[[part$task[1]]]
    cbind(data.frame(task = part$task[1], condition = part$condition[1], participants = m,
                     accuracy_mean = mean(own$accuracy), accuracy_sd = deviation, t_lo = max(0, mean(own$accuracy) - half),
                     t_hi = min(1, mean(own$accuracy) + half), n = sum(part$count)),
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

# Comparisons of the levels of each effect, of means and of ranks; Holm's p over the pairs of an effect.
in_order <- function(names) sort(unique(names), method = "radix")

# Shares of correct answers by participant, condition and pattern; NA: not presented.
shares_of <- function(part) {
    totals <- aggregate(part[c("count", "correct")], part[c("participant_id", "condition", "stimulus")], sum)
    sides <- lapply(totals[c("participant_id", "condition", "stimulus")], in_order)
    shares <- array(NA_real_, lengths(sides), unname(sides))
    shares[as.matrix(totals[c("participant_id", "condition", "stimulus")])] <- totals$correct / totals$count
    shares
}

# Interval of d_z from the noncentral t distribution.
dz_interval_of <- function(t, n) {
    end <- function(p) suppressWarnings(uniroot(function(delta) pt(t, n - 1, delta) - p, t + c(-1, 1) * (5 + abs(t)),
                                                extendInt = "downX", tol = 1e-12)$root) / sqrt(n)
    c(end(0.975), end(0.025))
}

# Interval of partial eta squared from the noncentral F distribution.
eta_interval_of <- function(f, df1, df2) {
    end <- function(p) {
        if (pf(f, df1, df2) <= p)
            return(0)
        lambda <- uniroot(function(x) pf(f, df1, df2, x) - p, c(0, 10 + 2 * df1 * f), extendInt = "downX", tol = 1e-12)$root
        lambda / (lambda + df1 + df2 + 1)
    }
    c(end(0.975), end(0.025))
}

# One pair of columns: paired t test and effect sizes. NULL: without any spread of the differences.
pair_of <- function(a, b) {
    d <- a - b
    n <- length(d)
    if (n < 2 || sd(d) <= 16 * .Machine$double.eps * max(abs(c(a, b))))
        return(NULL)
    test <- t.test(a, b, paired = TRUE)
    t <- unname(test$statistic)
    dz <- dz_interval_of(t, n)
    j <- if (n > 2) exp(lgamma((n - 1) / 2) - lgamma((n - 2) / 2)) / sqrt((n - 1) / 2) else NA
    data.frame(n = n, difference = mean(d), lo = test$conf.int[1], hi = test$conf.int[2], t = t, df = n - 1,
               p = test$p.value, p_holm = NA_real_, dz = t / sqrt(n), dz_lo = dz[1], dz_hi = dz[2],
               dav = mean(d) / sqrt((var(a) + var(b)) / 2), hedges_j = j, gz = j * t / sqrt(n))
}

# Wilcoxon's signed rank test with Pratt's zeros; exact up to 25 differences. NULL: nothing but zeros.
ranks_of <- function(a, b) {
    d <- round((a - b) / max(abs(c(a, b)), 1e-300), 10)
    ranks <- rank(abs(d))[d != 0]
    positive <- sum(rank(abs(d))[d > 0])
    negative <- sum(rank(abs(d))[d < 0])
    if (length(ranks) == 0)
        return(NULL)
    exact <- length(ranks) <= 25
    p <- if (exact) {
        share <- c(1, numeric(sum(2 * ranks)))
        for (rank in 2 * ranks)
            share <- (share + c(numeric(rank), head(share, -rank))) / 2
        min(1, 2 * sum(share[seq_len(2 * min(positive, negative) + 1)]))
    } else 2 * pnorm(-abs(positive - negative) / 2 / sqrt(sum(ranks^2) / 4))
    data.frame(test = "wilcoxon", n = length(d), zeros = sum(d == 0), w_plus = positive, w_minus = negative, p = p, p_holm = NA_real_,
               exact = as.integer(exact), rank_biserial = (positive - negative) / (positive + negative))
}

# All pairs of the columns of a matrix, as rows of `how`.
pairs_of <- function(task, effect, stimulus, values, how) {
    values <- values[rowSums(is.na(values)) == 0, , drop = FALSE]
    if (ncol(values) < 2 || nrow(values) < 2)
        return(NULL)
    do.call(rbind, combn(ncol(values), 2, function(two) {
        row <- how(values[, two[1]], values[, two[2]])
        if (is.null(row)) NULL
        else cbind(data.frame(task = task, effect = effect, stimulus = stimulus, first = colnames(values)[two[1]],
                              second = colnames(values)[two[2]]), row)
    }, simplify = FALSE))
}

with_holm <- function(rows) {
    if (!is.null(rows))
        rows$p_holm <- p.adjust(rows$p, "holm")
    rows
}

comparisons_of <- function(part, how) {
    task <- part$task[1]
    shares <- shares_of(part)
    complete <- shares[apply(!is.na(shares), 1, all), , , drop = FALSE]
    patterns <- dimnames(shares)[[3]]
    rbind(if (dim(shares)[2] > 1) with_holm(pairs_of(task, "condition", NA, apply(complete, c(1, 2), mean), how)),
          with_holm(pairs_of(task, "pattern", NA, apply(complete, c(1, 3), mean), how)),
          if (dim(shares)[2] > 1)
              with_holm(do.call(rbind, lapply(patterns, function(pattern)
                  pairs_of(task, "condition", pattern, matrix(shares[, , pattern], dim(shares)[1],
                                                              dimnames = dimnames(shares)[1:2]), how)))))
}

friedman_of <- function(part) {
    task <- part$task[1]
    shares <- shares_of(part)
    complete <- shares[apply(!is.na(shares), 1, all), , , drop = FALSE]
    line <- function(effect, stimulus, values) {
        values <- values[rowSums(is.na(values)) == 0, , drop = FALSE]
        if (ncol(values) < 3 || nrow(values) < 2 || all(values == values[, 1]))
            return(NULL)
        test <- friedman.test(round(values / max(abs(values)), 10))
        data.frame(task = task, effect = effect, stimulus = stimulus, test = "friedman", first = NA, second = NA,
                   n = nrow(values), chi2 = unname(test$statistic), df = unname(test$parameter), p = test$p.value,
                   kendall_w = unname(test$statistic) / (nrow(values) * (ncol(values) - 1)))
    }
    rbind(line("condition", NA, apply(complete, c(1, 2), mean)), line("pattern", NA, apply(complete, c(1, 3), mean)),
          do.call(rbind, lapply(dimnames(shares)[[3]], function(pattern)
              line("condition", pattern, matrix(shares[, , pattern], dim(shares)[1])))))
}

by_task <- function(f, ...) do.call(rbind, unname(lapply(split(counts, counts$task), f, ...)))
some <- function(table, name) if (!is.null(table) && nrow(table) > 0) write_table(table, name)

some(by_task(comparisons_of, pair_of), "comparisons_r.csv")
ranked <- by_task(comparisons_of, ranks_of)
if (!is.null(ranked))
    some(cbind(ranked[c("task", "effect", "stimulus", "test", "first", "second")],
               ranked[setdiff(names(ranked), c("task", "effect", "stimulus", "test", "first", "second"))]), "ranks_r.csv")
some(by_task(friedman_of), "friedman_r.csv")
if (!is.null(anovas)) {
    spherical <- anovas[anovas$eps_gg >= 0.75, ]
    eta <- if (nrow(spherical) > 0) t(mapply(eta_interval_of, spherical$f, spherical$df1, spherical$df2))
    if (!is.null(eta))
        some(cbind(spherical[c("task", "effect", "stimulus")],
               data.frame(first = NA, second = NA, partial_eta2 = spherical$partial_eta2, partial_eta2_lo = eta[, 1],
                          partial_eta2_hi = eta[, 2])),
             "partial_eta2_r.csv")
}

# Response times: geometric means of the participants, and conditions compared by their logarithms.
if (!is.null(times) && nrow(times) > 0) {
    own <- aggregate(list(value = times$response_time_s), times[c("participant_id", "task", "condition")],
                     function(x) c(length(x), if (all(x > 0)) exp(mean(log(x))) else NA, median(x)))
    own <- cbind(own[1:3], data.frame(against = NA, n = own$value[, 1], geometric_mean_s = own$value[, 2],
                                      median_s = own$value[, 3]))
    ratios <- do.call(rbind, lapply(split(own, own$task), function(part) {
        conditions <- in_order(part$condition)
        if (length(conditions) < 2)
            return(NULL)
        logs <- sapply(conditions, function(condition)
            log(part$geometric_mean_s[part$condition == condition][match(in_order(part$participant_id),
                                                                         part$participant_id[part$condition == condition])]))
        with_holm(do.call(rbind, combn(ncol(logs), 2, function(two) {
            both <- logs[rowSums(is.na(logs[, two])) == 0, two, drop = FALSE]
            row <- pair_of(both[, 1], both[, 2])
            if (is.null(row)) NULL
            else data.frame(participant_id = "GROUP", task = part$task[1], condition = conditions[two[1]],
                            against = conditions[two[2]], n = row$n, ratio = exp(row$difference), lo = exp(row$lo),
                            hi = exp(row$hi), t = row$t, df = row$df, p = row$p, p_holm = NA_real_)
        }, simplify = FALSE)))
    }))
    some(own, "response_times_r.csv")
    some(ratios, "response_time_ratios_r.csv")
}

# Binomial model with an intercept that differs between participants: likelihood by adaptive Gauss-Hermite quadrature.
hermite <- local({
    off <- sqrt(seq_len(24) / 2)
    jacobi <- matrix(0, 25, 25)
    jacobi[cbind(1:24, 2:25)] <- off
    jacobi[cbind(2:25, 1:24)] <- off
    found <- eigen(jacobi, symmetric = TRUE)
    list(at = found$values, weight = sqrt(pi) * found$vectors[1, ]^2)
})
likelihood_of <- function(parameters, x, correct, n, people) {
    fixed <- as.vector(x %*% parameters[seq_len(ncol(x))])
    s <- parameters[ncol(x) + 1]
    sum(sapply(split(seq_along(n), people), function(rows) {
        height <- function(z) sum(correct[rows] * plogis(fixed[rows] + s * z, log.p = TRUE) +
                                  (n - correct)[rows] * plogis(-fixed[rows] - s * z, log.p = TRUE)) - z^2 / 2
        z <- 0
        for (step in 1:50) {
            share <- plogis(fixed[rows] + s * z)
            z <- z + (s * sum(correct[rows] - n[rows] * share) - z) / (1 + s^2 * sum(n[rows] * share * (1 - share)))
        }
        share <- plogis(fixed[rows] + s * z)
        width <- sqrt(2 / (1 + s^2 * sum(n[rows] * share * (1 - share))))
        heights <- sapply(z + width * hermite$at, height)
        height(z) + log(sum(hermite$weight * exp(heights - height(z) + hermite$at^2)) * width / sqrt(2 * pi))
    }))
}
model_fit_of <- function(x, rows) {
    people <- factor(rows$participant_id)
    plain <- glm(cbind(rows$correct, rows$count - rows$correct) ~ x - 1, family = binomial)
    negative <- function(parameters) -likelihood_of(parameters, x, rows$correct, rows$count, people)
    best <- NULL
    for (s in c(0.2, 0.6, 1.5)) {
        found <- optim(c(coef(plain), s), negative, method = "BFGS", control = list(reltol = 1e-14, maxit = 500))
        if (is.null(best) || found$value < best$value)
            best <- found
    }
    at_zero <- negative(c(coef(plain), 0))
    if (at_zero - best$value < 1e-7)
        return(list(b = coef(plain), se = sqrt(diag(vcov(plain))), s = 0, value = -at_zero))
    covariance <- solve(optimHess(best$par, negative))
    list(b = best$par[seq_len(ncol(x))], se = sqrt(diag(covariance))[seq_len(ncol(x))], s = abs(best$par[ncol(x) + 1]),
         value = -best$value)
}
model_of <- function(part) {
    rows <- aggregate(part[c("count", "correct")], part[c("participant_id", "condition")], sum)
    conditions <- in_order(rows$condition)
    shares <- sapply(conditions, function(name) sum(rows$correct[rows$condition == name]) / sum(rows$count[rows$condition == name]))
    if (length(unique(rows$participant_id)) < 5 || any(shares == 0) || any(shares == 1))
        return(NULL)
    x <- cbind(1, vapply(conditions[-1], function(name) as.numeric(rows$condition == name), numeric(nrow(rows))))
    whole <- model_fit_of(x, rows)
    ratio <- if (length(conditions) > 1) 2 * (whole$value - model_fit_of(x[, 1, drop = FALSE], rows)$value) else NA
    row <- function(...) data.frame(task = part$task[1], ...)
    result <- row(term = c("intercept", rep("condition", length(conditions) - 1)), level = c(NA, conditions[-1]),
                  reference = conditions[1], estimate = whole$b, se = whole$se, lo = whole$b - qnorm(0.975) * whole$se,
                  hi = whole$b + qnorm(0.975) * whole$se, sd_participants = whole$s, log_likelihood = whole$value,
                  lr_chi2 = NA, lr_df = NA, lr_p = NA)
    if (length(conditions) > 1)
        result <- rbind(result, row(term = "condition", level = NA, reference = NA, estimate = NA, se = NA, lo = NA, hi = NA,
                                    sd_participants = NA, log_likelihood = NA, lr_chi2 = ratio,
                                    lr_df = length(conditions) - 1,
                                    lr_p = pchisq(ratio, length(conditions) - 1, lower.tail = FALSE)))
    result
}
some(by_task(model_of), "binomial_model_r.csv")

# The same by lme4, as a place to go on from: other models are a matter of another formula.
if (requireNamespace("lme4", quietly = TRUE)) {
    lme4_of <- function(part) {
        rows <- aggregate(part[c("count", "correct")], part[c("participant_id", "condition")], sum)
        rows$condition <- factor(rows$condition, levels = in_order(rows$condition))
        rows$participant_id <- factor(rows$participant_id)
        formula <- if (nlevels(rows$condition) > 1) cbind(correct, count - correct) ~ condition + (1 | participant_id)
                   else cbind(correct, count - correct) ~ 1 + (1 | participant_id)
        fit <- tryCatch(lme4::glmer(formula, rows, binomial, nAGQ = 25), error = function(problem) NULL)
        if (is.null(fit) || nlevels(rows$participant_id) < 5)
            return(NULL)
        estimates <- lme4::fixef(fit)
        data.frame(task = part$task[1], term = c("intercept", rep("condition", length(estimates) - 1)),
                   level = c(NA, levels(rows$condition)[-1]), reference = levels(rows$condition)[1],
                   estimate = unname(estimates), sd_participants = unname(attr(lme4::VarCorr(fit)$participant_id, "stddev")))
    }
    some(by_task(lme4_of), "binomial_model_lme4_r.csv")
}

# A plan: its power, standard error and Wilson's interval, from the counts.
if (file.exists(file.path(folder, "plan.csv"))) {
    plan <- read.csv(file.path(folder, "plan.csv"))
    plan$power <- plan$significant / plan$studies
    plan$se <- sqrt(plan$power * (1 - plan$power) / plan$studies)
    ends <- mapply(function(x, n) suppressWarnings(prop.test(x, n, correct = FALSE))$conf.int, plan$significant, plan$studies)
    plan$lo <- ends[1, ]
    plan$hi <- ends[2, ]
    some(plan[c("test", "participants", "studies", "power", "se", "lo", "hi")], "plan_r.csv")
}
