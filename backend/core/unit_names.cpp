// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/unit_names.h"

#include <algorithm>
#include <array>

namespace teleta::core {

namespace {

struct Unit {
    std::string_view ending; ///< of a key in a TOML file, or all of it; of a column in lower case
    std::string_view text;
};
constexpr std::array kUnits{Unit{"_N_per_mm", "N/mm"},
                            Unit{"_N_per_m", "N/m"},
                            Unit{"_Ns_per_m", "N s/m"},
                            Unit{"_m_per_s", "m/s"},
                            Unit{"_m_per_s2", "m/s²"},
                            Unit{"_mm_per_s", "mm/s"},
                            Unit{"_rad_per_s", "rad/s"},
                            Unit{"_rad_per_s2", "rad/s²"},
                            Unit{"_deg_per_s", "°/s"},
                            Unit{"_Nm_per_rad", "N m/rad"},
                            Unit{"_Nms_per_rad", "N m s/rad"},
                            Unit{"_per_m", "1/m"},
                            Unit{"_per_s", "1/s"},
                            Unit{"_Nm", "N m"},
                            Unit{"_mN", "mN"},
                            Unit{"_kN", "kN"},
                            Unit{"_N", "N"},
                            Unit{"_J", "J"},
                            Unit{"_mm", "mm"},
                            Unit{"_cm", "cm"},
                            Unit{"_um", "µm"},
                            Unit{"_m", "m"},
                            Unit{"_m2", "m²"},
                            Unit{"_ms", "ms"},
                            Unit{"_us", "µs"},
                            Unit{"_ns", "ns"},
                            Unit{"_min", "min"},
                            Unit{"_s", "s"},
                            Unit{"_kHz", "kHz"},
                            Unit{"_MHz", "MHz"},
                            Unit{"_Hz", "Hz"},
                            Unit{"_rad", "rad"},
                            Unit{"_deg", "°"},
                            Unit{"_kgm2", "kg m²"},
                            Unit{"_kg", "kg"},
                            Unit{"_kPa", "kPa"},
                            Unit{"_Pa", "Pa"},
                            Unit{"_uT", "µT"},
                            Unit{"_percent", "%"},
                            Unit{"mm_per_px", "mm/px"},
                            Unit{"_px", "px"},
                            Unit{"_px2", "px²"},
                            Unit{"_bits", "bit"}};

/// Columns whose unit is not at the end of their name, without the number at their end.
constexpr std::array kColumns{Unit{"q", "rad"},
                              Unit{"tau", "N m"},
                              Unit{"ref", "rad"},
                              Unit{"total_stiffness_se", "N/m"},
                              Unit{"object_stiffness_lower_95", "N/m"},
                              Unit{"object_stiffness_upper_95", "N/m"},
                              Unit{"stiffness_lower_95", "N/m"},
                              Unit{"stiffness_upper_95", "N/m"},
                              Unit{"load_counts", "counts"},
                              Unit{"it_lo", "bit"},
                              Unit{"it_hi", "bit"},
                              Unit{"it_at_least", "bit"},
                              Unit{"it_at_most", "bit"}};

/// Columns without a unit, without the number at their end.
constexpr auto kWithoutUnit = std::to_array<std::string_view>({

    // Taxels, tactors and turns.
    "t", "qx", "qy", "qz", "qw", "qx_commanded", "qy_commanded", "qz_commanded", "qw_commanded", "commanded",
    "drive", "gain", "gain_se",
    // Numbers and names of things.
    "frame", "contact_id", "marker", "found", "taxel", "row", "column", "touch", "touches", "object",
    "true_object", "name", "joint", "run", "source", "samples", "active", "condition_number", "confidence",
    "value", "slip_index", "slip_share",
    // Words.
    "contact_type", "type", "contact", "event", "state", "text", "utc", "phase", "limits", "method",
    "material", "shape", "true_shape", "safe", "level", "reliable", "refusal", "warnings", "kept", "used",
    "dead", "why",
    // What accuracy costs, and effects of a scene.
    "ladder", "rung", "parameter", "error_mean", "error_p95", "error_max", "error_unit", "pareto", "effect",
    "measure", "mean", "mean_without", "spread_with", "spread_without", "change", "change_per_spread",
    "p_mean", "p_spread", "seeds_that_differ", "moves",
    // Studies.
    "schema", "participant_id", "session_id", "mode", "task", "condition", "condition_position",
    "sequence_row", "block", "trial", "trial_in_block", "repetition", "attempt", "stimulus", "response",
    "outcome", "correct", "n_alternatives", "response_device", "response_key", "n_replays", "early_presses",
    "device_faults", "feedback", "masking_noise", "time_utc", "seed", "order_method", "stimulus_set_sha256",
    "app_version", "questionnaire", "when", "item", "kind", "question", "answer", "answer_text", "note",
    "participants", "count", "row_total", "n", "n_correct", "n_timeout", "rt_n", "accuracy", "accuracy_mean",
    "accuracy_sd", "wilson_lo", "wilson_hi", "cp_lo", "cp_hi", "t_lo", "t_hi", "p_chance", "it_few_trials",
    "it_note", "df", "ss", "ss_error", "f", "p", "eps_gg", "p_gg", "eps_hf", "p_hf", "partial_eta",
    "generalized_eta", "dropped", "design", "track", "level", "level_unit", "reference", "procedure",
    "excluded", "recording", "function", "threshold", "lo", "hi", "interval", "unit", "spread", "guess",
    "lapse", "lapse_lo", "lapse_hi", "deviance", "p_deviance", "jnd", "weber", "pse", "stair_estimate",
    "stair_reversals", "bayes_mean", "bayes_sd", "scale", "n_positive", "positive", "counts", "hits",
    "n_signal", "false_alarms", "n_noise", "dprime", "c", "category", "series", "low", "high", "singles",
    "file", "description", "levels", "missing", "study_id", "enrolment", "acq_time", "x", "y",
    // Comparisons, ranks, models and exclusions of studies.
    "test", "first", "second", "difference", "p_holm", "family", "dz", "dz_lo", "dz_hi", "dav", "hedges_j",
    "gz", "partial_eta2_lo", "partial_eta2_hi", "zeros", "w_plus", "w_minus", "chi", "exact", "rank_biserial",
    "kendall_w", "term", "estimate", "se", "sd_participants", "log_likelihood", "lr_chi", "lr_df", "lr_p",
    "trials", "against", "ratio", "rule", "of", "origin", "trials_before", "sessions"});

constexpr char lowered(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// ending: of the table. exact: its letters as they are; otherwise in lower case.
bool endsWith(std::string_view name, std::string_view ending, bool exact) {
    return name.size() >= ending.size() + (ending.front() == '_' ? 1U : 0U) &&
           std::ranges::equal(name.substr(name.size() - ending.size()), ending, {}, {},
                              [exact](char c) { return exact ? c : lowered(c); });
}

/// The longest ending of the table that the name has; empty: none.
Unit unitAtEnd(std::string_view name, bool alsoExact) {
    Unit longest;
    for (const Unit& unit : kUnits)
        if (unit.ending.size() > longest.ending.size() &&
            ((alsoExact && endsWith(name, unit.ending, true)) || endsWith(name, unit.ending, false)))
            longest = unit;
    return longest;
}

bool hasUpperCase(std::string_view name) {
    return std::ranges::any_of(name, [](char c) { return lowered(c) != c; });
}

std::optional<std::string_view> unitOfNamed(std::string_view column) {
    const auto found = std::ranges::find(kColumns, column, &Unit::ending);
    if (found != kColumns.end())
        return found->text;
    return std::ranges::find(kWithoutUnit, column) != kWithoutUnit.end() ? std::optional(std::string_view())
                                                                         : std::nullopt;
}

} // namespace

std::string_view unitOf(std::string_view key) {
    return unitAtEnd(key, true).text;
}

std::string_view withoutUnit(std::string_view key) {
    return key.substr(0, key.size() - unitAtEnd(key, true).ending.size());
}

std::string lowerCaseUnit(std::string_view key) {
    std::string name(key);
    std::ranges::transform(name.begin() + static_cast<std::ptrdiff_t>(withoutUnit(key).size()), name.end(),
                           name.begin() + static_cast<std::ptrdiff_t>(withoutUnit(key).size()), lowered);
    return name;
}

std::optional<std::string_view> unitOfColumn(std::string_view column) {
    if (hasUpperCase(column))
        return std::nullopt;
    if (const auto named = unitOfNamed(column))
        return named;
    if (const Unit unit = unitAtEnd(column, false); !unit.ending.empty())
        return unit.text;
    return unitOfNamed(column.substr(0, column.find_last_not_of("0123456789") + 1));
}

} // namespace teleta::core
