// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/level_task.h"

#include "backend/core/words.h"

namespace teleta::study {

namespace {

constexpr core::Words<Design, 5> kDesigns{
    {"identification", "yes_no", "interval", "same_different", "compare"}};
constexpr core::Words<Vary, 5> kVary{{"intensity", "onset_s", "burst_s", "duration_s", "balance"}};

} // namespace

const char* toString(Design design) {
    return kDesigns.of(design);
}

const char* toString(Vary vary) {
    return kVary.of(vary);
}

const char* unitOf(Vary vary) {
    switch (vary) {
    case Vary::intensity:
        return "drive";
    case Vary::balance:
        return "balance";
    case Vary::onset:
    case Vary::burst:
    case Vary::duration:
        break;
    }
    return "s";
}

std::vector<std::string> answersOf(Design design, std::size_t intervals) {
    switch (design) {
    case Design::identification:
        break;
    case Design::yesNo:
        return {"yes", "no"};
    case Design::sameDifferent:
        return {"same", "different"};
    case Design::compare:
        return {"1", "2"};
    case Design::interval: {
        std::vector<std::string> numbers;
        for (std::size_t i = 1; i <= intervals; ++i)
            numbers.push_back(std::to_string(i));
        return numbers;
    }
    }
    return {};
}

std::size_t intervalsOf(Design design, const LevelTask& task) {
    switch (design) {
    case Design::interval:
        return task.intervals;
    case Design::sameDifferent:
    case Design::compare:
        return 2;
    case Design::identification:
    case Design::yesNo:
        break;
    }
    return 1;
}

Procedure procedureOf(Design design, const LevelTask& task, std::size_t repetitions, bool blocked) {
    if (std::holds_alternative<ConstantSettings>(task.procedure))
        return ConstantSettings{task.values, repetitions, blocked};
    Procedure procedure = task.procedure;
    if (auto* bayes = std::get_if<BayesSettings>(&procedure)) {
        bayes->guessIsLapse = design == Design::compare;
        if (design == Design::interval)
            bayes->guess = {1.0 / static_cast<double>(task.intervals)};
    }
    return procedure;
}

} // namespace teleta::study
