// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/servo/servo_texts.h"

#include <QStringList>

namespace teleta::servo {

QString ServoTexts::task(TaskKind kind) {
    switch (kind) {
    case TaskKind::freeMotion:
        return tr("Free motion");
    case TaskKind::align:
        return tr("Align");
    case TaskKind::edgeControl:
        return tr("Edge control");
    case TaskKind::explore:
        return tr("Explore");
    case TaskKind::roll:
        return tr("Roll");
    case TaskKind::pointFollowing:
        return tr("Follow a point");
    case TaskKind::comanipulation:
        return tr("Co-manipulation");
    }
    return {};
}

QString ServoTexts::contact(ContactState state) {
    switch (state) {
    case ContactState::none:
        return tr("no contact");
    case ContactState::touching:
        return tr("in contact");
    case ContactState::searching:
        return tr("searching for the contact");
    case ContactState::lost:
        return tr("contact lost");
    }
    return {};
}

QString ServoTexts::limit(Limit limit) {
    switch (limit) {
    case Limit::toolSpeed:
        return tr("tool speed");
    case Limit::turnRate:
        return tr("turn rate");
    case Limit::force:
        return tr("force");
    case Limit::saturation:
        return tr("saturated taxel");
    case Limit::deviation:
        return tr("distance from the measured pose");
    case Limit::jointSpeed:
        return tr("joint speed");
    case Limit::jointEnd:
        return tr("end of a joint");
    case Limit::singular:
        return tr("singular arm");
    case Limit::gap:
        return tr("gap between frames");
    case Limit::badInput:
        return tr("unusable numbers");
    }
    return {};
}

QString ServoTexts::limits(const ActiveLimits& limits) {
    QStringList names;
    for (std::size_t i = 0; i < kLimits; ++i)
        if (limits.has(static_cast<Limit>(i)))
            names << limit(static_cast<Limit>(i));
    return names.join(tr(", ", "between the limits that act"));
}

QString ServoTexts::feature(int row, bool edge) {
    switch (row) {
    case kX:
        return tr("CoP x");
    case kY:
        return tr("CoP y");
    case kZ:
        return tr("Force");
    case kWx:
        return edge ? tr("\u2212DZMP x") : tr("CoC y");
    case kWy:
        return edge ? tr("\u2212DZMP y") : tr("CoC x");
    default:
        return tr("\u03b1 z");
    }
}

} // namespace teleta::servo
