// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/edit/track_envelope.h"
#include "backend/pattern/motors/motor_prediction.h"
#include "widgets/pattern/document/pattern_document.h"

#include <QObject>

#include <array>
#include <atomic>
#include <memory>
#include <optional>

namespace teleta::pattern {

/// Envelopes of a pattern, one per tactor.
using TrackEnvelopes = std::array<TrackEnvelope, core::kTactors>;
[[nodiscard]] std::shared_ptr<const TrackEnvelopes> envelopesOf(const Pattern& pattern);

/// Envelopes and predictions of a long pattern, for drawing when a pixel covers many breakpoints. Computed on
/// a pool thread: first the commanded envelope, then the prediction; after an edit only the changed part is
/// predicted again. Until then the previous results remain. Thread: GUI.
class PatternOverview : public QObject {
    Q_OBJECT
public:
    /// Shorter patterns are sampled while drawing.
    static constexpr double kShortest_s = 15.0;

    explicit PatternOverview(PatternDocument* document, QObject* parent = nullptr);
    ~PatternOverview() override;

    /// Null: not yet computed, or the pattern is shorter than kShortest_s.
    [[nodiscard]] const std::shared_ptr<const TrackEnvelopes>& commanded() const { return m_commanded; }
    /// Also null when the pattern is longer than MotorPrediction::kLongest_s.
    [[nodiscard]] const std::shared_ptr<const MotorPrediction>& predicted() const { return m_predicted; }
    /// Whether all results are up to date with the pattern.
    [[nodiscard]] bool isCurrent() const { return !m_cancelled && m_revision == m_document->revision(); }

signals:
    void changed();

private:
    void look();
    void predict(const std::shared_ptr<const Pattern>& pattern, quint64 revision);
    /// Returns true when the pattern has changed meanwhile; the work then restarts.
    bool outdated(quint64 revision);

    PatternDocument* m_document;
    std::shared_ptr<const TrackEnvelopes> m_commanded;
    std::shared_ptr<const MotorPrediction> m_predicted;
    std::shared_ptr<const Pattern> m_predictedPattern;
    std::shared_ptr<std::atomic<bool>> m_cancelled; ///< cancels the running work; null: none is running
    quint64 m_revision = 0;
};

} // namespace teleta::pattern
