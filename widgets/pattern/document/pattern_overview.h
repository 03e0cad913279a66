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

namespace teleta::editor {

/// Ranges of the tracks of a pattern, one a tactor; empty when the pattern is too rich for straight lines.
using TrackEnvelopes = std::array<pattern::TrackEnvelope, core::kTactors>;
[[nodiscard]] std::shared_ptr<const TrackEnvelopes> envelopesOf(const pattern::Pattern& pattern);

/// What a long pattern does as a whole, for pictures in which a pixel is many breakpoints. Made on a pool
/// thread: first what is commanded, then what the motors do with it; after an edit only what changed is
/// predicted anew. Until then the answers are those of the pattern before. Thread: GUI.
class PatternOverview : public QObject {
    Q_OBJECT
public:
    /// Shorter patterns are sampled when they are drawn.
    static constexpr double kShortest_s = 15.0;

    explicit PatternOverview(PatternDocument* document, QObject* parent = nullptr);
    ~PatternOverview() override;

    /// Null: not yet, or the pattern is shorter than kShortest_s.
    [[nodiscard]] const std::shared_ptr<const TrackEnvelopes>& commanded() const { return m_commanded; }
    /// Null also when the pattern is too long (MotorPrediction::kLongest_s).
    [[nodiscard]] const std::shared_ptr<const pattern::MotorPrediction>& predicted() const {
        return m_predicted;
    }
    /// All of it is of the pattern as it is now.
    [[nodiscard]] bool isCurrent() const { return !m_cancelled && m_revision == m_document->revision(); }

signals:
    void changed();

private:
    void look();
    void predict(const std::shared_ptr<const pattern::Pattern>& pattern, quint64 revision);
    /// True when the pattern has changed meanwhile, and the work has begun again.
    bool outdated(quint64 revision);

    PatternDocument* m_document;
    std::shared_ptr<const TrackEnvelopes> m_commanded;
    std::shared_ptr<const pattern::MotorPrediction> m_predicted;
    std::shared_ptr<const pattern::Pattern> m_predictedPattern;
    std::shared_ptr<std::atomic<bool>> m_cancelled; ///< of the work under way; null: none is
    quint64 m_revision = 0;
};

} // namespace teleta::editor
