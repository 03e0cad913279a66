// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/refusal.h"

namespace teleta::study {

const char* toString(Refusal refusal) {
    switch (refusal) {
    case Refusal::noData:
        return "no data";
    case Refusal::notFinite:
        return "not finite";
    case Refusal::badShape:
        return "bad shape";
    case Refusal::tooFewLevels:
        return "fewer than two levels";
    case Refusal::oneParticipant:
        return "fewer than two complete participants";
    case Refusal::noVariance:
        return "no variance";
    case Refusal::noErrorVariance:
        return "no error variance";
    }
    return "";
}

} // namespace teleta::study
