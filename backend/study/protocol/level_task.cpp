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

} // namespace teleta::study
