// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/edit/comparison.h"
#include "widgets/pattern/document/pattern_overview.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>

namespace teleta::pattern {

/// The pattern with which a document is compared, and their difference; recomputed on a pool thread when the
/// document has not changed for a moment. Thread: GUI.
class PatternReference : public QObject {
    Q_OBJECT
public:
    explicit PatternReference(PatternDocument* document, QObject* parent = nullptr);

    /// Null ends the comparison.
    void setPattern(std::shared_ptr<const Pattern> pattern);
    [[nodiscard]] const std::shared_ptr<const Pattern>& pattern() const { return m_pattern; }
    /// Envelopes of a long pattern; otherwise null.
    [[nodiscard]] const std::shared_ptr<const TrackEnvelopes>& envelopes() const { return m_envelopes; }
    /// Empty: not yet known, or the patterns have too many corners.
    [[nodiscard]] const std::optional<Comparison>& comparison() const { return m_comparison; }

signals:
    void changed();

private:
    void compare();

    PatternDocument* m_document;
    QTimer m_rest;
    std::shared_ptr<const Pattern> m_pattern;
    std::shared_ptr<const TrackEnvelopes> m_envelopes;
    std::optional<Comparison> m_comparison;
    bool m_comparing = false;
};

} // namespace teleta::pattern
