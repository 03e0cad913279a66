// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/stiffness/refusal.h"

namespace teleta::stiffness {

const char* toString(Refusal refusal) {
    switch (refusal) {
    case Refusal::notFinite:
        return "notFinite";
    case Refusal::notPositive:
        return "notPositive";
    case Refusal::negativeUncertainty:
        return "negativeUncertainty";
    case Refusal::outOfRange:
        return "outOfRange";
    case Refusal::badWindow:
        return "badWindow";
    case Refusal::noSamples:
        return "noSamples";
    case Refusal::windowNotReached:
        return "windowNotReached";
    case Refusal::tooFewSamples:
        return "tooFewSamples";
    case Refusal::torqueUnchanged:
        return "torqueUnchanged";
    case Refusal::angleOpposesTorque:
        return "angleOpposesTorque";
    case Refusal::tooQuick:
        return "tooQuick";
    case Refusal::noTorques:
        return "noTorques";
    }
    return "";
}

} // namespace teleta::stiffness
