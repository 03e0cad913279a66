// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/files/loss.h"

#include "backend/pattern/files/foreign_formats.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::pattern {

namespace {

struct PatternLoss {
    Q_DECLARE_TR_FUNCTIONS(PatternLoss)
};

QString text(const Loss& loss) {
    const QString detail = QString::fromStdString(loss.detail);
    const QString burst = QString::number(std::lround(1000.0 * kBurst_s));
    switch (loss.kind) {
    case LossKind::frequency:
        return PatternLoss::tr(
                   "Frequencies left out: %1. The frequency of the motors follows their intensity.")
            .arg(loss.count);
    case LossKind::shape:
        return PatternLoss::tr(
                   "Shapes and phases of waves left out: %1. The motors play their strength only.")
            .arg(loss.count);
    case LossKind::burst:
        return PatternLoss::tr("Short pulses that became bursts of %2 ms: %1.").arg(loss.count).arg(burst);
    case LossKind::longer:
        return PatternLoss::tr(
                   "The pattern is longer than the file by %1 s, so that its last burst is whole.")
            .arg(detail);
    case LossKind::oneSignal:
        return PatternLoss::tr("The file holds one signal. It plays on tactor %1.", "a list of numbers")
            .arg(detail);
    case LossKind::place:
        return PatternLoss::tr("Channels without a direction, put on the tactors in their order: %1.")
            .arg(loss.count);
    case LossKind::channel:
        return PatternLoss::tr("Channels left out, because no tactor is left for them: %1.").arg(loss.count);
    case LossKind::otherArm:
        return PatternLoss::tr("Effects for the other arm left out: %1.").arg(loss.count);
    case LossKind::otherDevice:
        return PatternLoss::tr("Effects for other devices left out: %1.").arg(loss.count);
    case LossKind::modality:
        return PatternLoss::tr("Parts that are not vibration left out: %1.").arg(loss.count);
    case LossKind::disabled:
        return PatternLoss::tr("Tracks left out that are switched off: %1.").arg(loss.count);
    case LossKind::overlap:
        return PatternLoss::tr("Pieces that overlap others: %1. The stronger one counts; they do not add up.")
            .arg(loss.count);
    case LossKind::path:
        return PatternLoss::tr("Paths shared among the motors nearest to them: %1.").arg(loss.count);
    case LossKind::point:
        return PatternLoss::tr("Paths or envelopes of a single point left out: %1. They have no length.")
            .arg(loss.count);
    case LossKind::audio:
        return PatternLoss::tr("Sounds left out: %1.").arg(loss.count);
    case LossKind::envelope:
        return PatternLoss::tr("Events whose attack, decay or release was left out: %1.").arg(loss.count);
    case LossKind::parameter:
        return PatternLoss::tr("Settings that a pattern does not have: %1.").arg(loss.count);
    case LossKind::waveform:
        return PatternLoss::tr("Coded wave forms left out: %1.").arg(loss.count);
    case LossKind::curve:
        return PatternLoss::tr("Curves of displacement, of which the size plays in straight lines: %1.")
            .arg(loss.count);
    case LossKind::clipped:
        return PatternLoss::tr("Intensities beyond full drive, set to 1: %1.").arg(loss.count);
    case LossKind::early:
        return PatternLoss::tr("Keyframes before the beginning of their effect, moved to it: %1.")
            .arg(loss.count);
    case LossKind::objects:
        return PatternLoss::tr("Objects written as the intensities that they play: %1.").arg(loss.count);
    case LossKind::steps:
        return PatternLoss::tr(
                   "Slopes written as steps of %2 ms: %1. They differ from the pattern by up to %3.")
            .arg(loss.count)
            .arg(kTactPiece_ms)
            .arg(detail);
    case LossKind::rounding:
        return PatternLoss::tr("Times rounded to milliseconds: %1.").arg(loss.count);
    }
    return {};
}

} // namespace

const char* toString(LossKind kind) {
    switch (kind) {
    case LossKind::frequency:
        return "frequency";
    case LossKind::shape:
        return "shape";
    case LossKind::burst:
        return "burst";
    case LossKind::longer:
        return "longer";
    case LossKind::oneSignal:
        return "one-signal";
    case LossKind::place:
        return "place";
    case LossKind::channel:
        return "channel";
    case LossKind::otherArm:
        return "other-arm";
    case LossKind::otherDevice:
        return "other-device";
    case LossKind::modality:
        return "modality";
    case LossKind::disabled:
        return "disabled";
    case LossKind::overlap:
        return "overlap";
    case LossKind::path:
        return "path";
    case LossKind::point:
        return "point";
    case LossKind::audio:
        return "audio";
    case LossKind::envelope:
        return "envelope";
    case LossKind::parameter:
        return "parameter";
    case LossKind::waveform:
        return "waveform";
    case LossKind::curve:
        return "curve";
    case LossKind::clipped:
        return "clipped";
    case LossKind::early:
        return "early";
    case LossKind::objects:
        return "objects";
    case LossKind::steps:
        return "steps";
    case LossKind::rounding:
        return "rounding";
    }
    return "";
}

std::string describe(const Loss& loss) {
    QString all = text(loss);
    if (loss.first_s && loss.count > 0)
        all += QLatin1Char(' ') +
               PatternLoss::tr("The first one is at %1 s.").arg(std::round(1000.0 * *loss.first_s) / 1000.0);
    if (!loss.where.empty())
        all +=
            QLatin1Char(' ') + PatternLoss::tr("First seen in %1.").arg(QString::fromStdString(loss.where));
    return all.toStdString();
}

Loss& LossCounter::of(LossKind kind) {
    const auto found = std::ranges::find(m_losses, kind, &Loss::kind);
    if (found != m_losses.end())
        return *found;
    m_losses.push_back({kind, 0, {}, m_where, {}});
    return m_losses.back();
}

void LossCounter::add(LossKind kind, std::optional<double> at_s, std::size_t count) {
    if (count == 0)
        return;
    Loss& loss = of(kind);
    loss.count += count;
    if (at_s && (!loss.first_s || *at_s < *loss.first_s))
        loss.first_s = at_s;
}

void LossCounter::note(LossKind kind, std::size_t count, std::string detail) {
    if (detail.empty())
        return;
    Loss& loss = of(kind);
    loss.count = count;
    loss.detail = std::move(detail);
}

std::size_t LossCounter::count(LossKind kind) const {
    const auto found = std::ranges::find(m_losses, kind, &Loss::kind);
    return found == m_losses.end() ? 0 : found->count;
}

} // namespace teleta::pattern
