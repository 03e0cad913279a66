// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/tactors.h"
#include "widgets/base/controls/badge.h"
#include "widgets/base/figure/sized_view.h"

#include <QPointF>
#include <QRectF>
#include <QString>

#include <array>
#include <cstddef>
#include <optional>

namespace teleta::bracelet {

/// Layout of the view. Thread: any (pure).
struct BraceletLayout {
    BraceletLayout(const QRectF& rect, const QFont& font);

    double em = 16.0;
    QRectF title, arm, note;
    double radius = 0.0; ///< of a tactor
    std::array<QPointF, core::kTactors> centre;

    [[nodiscard]] std::optional<std::size_t> tactorAt(const QPointF& point) const;
};

/// The six tactors on the unrolled forearm, left to right once around it (0 to 300 degrees), every other one
/// shifted along the arm. The fuller a disc, the stronger the tactor vibrates. Where holding is allowed, a
/// tactor vibrates while the mouse or its key 1..6 is held; losing the focus or hiding the window ends that.
/// Thread: GUI.
class BraceletView : public base::SizedView {
    Q_OBJECT
public:
    explicit BraceletView(QWidget* parent = nullptr);

    /// Current intensity of each tactor; clamped to 0..1, NaN is off.
    void setIntensities(const core::Intensities& intensities);
    [[nodiscard]] const core::Intensities& intensities() const { return m_intensities; }
    /// What is playing, in one line.
    void setTitle(const QString& title);
    /// State of the bracelet: for example that none is connected, or that STOP is engaged.
    void setNote(const QString& note);
    /// The note tells why nothing can be felt now: it is written in the colour of what is lost.
    void setAlarming(bool alarming);
    /// The intensities are those of a pattern that is not played: discs are outlined, not filled.
    void setPreview(bool preview);
    [[nodiscard]] bool isPreview() const { return m_preview; }
    void setProvenance(base::Provenance provenance);
    /// Whether single tactors can be felt by holding them; off by default.
    void setHoldable(bool holdable);

    [[nodiscard]] BraceletLayout layoutNow() const;

signals:
    /// The held tactor, 0..5, changed; empty: none.
    void held(std::optional<std::size_t> tactor);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void retranslate();
    void describe();
    [[nodiscard]] QString shownTitle() const;
    void hold(std::optional<std::size_t> tactor);

    core::Intensities m_intensities{};
    QString m_title;
    QString m_note;
    base::Provenance m_provenance = base::Provenance::live;
    bool m_alarming = false;
    bool m_preview = false;
    bool m_holdable = false;
    std::optional<std::size_t> m_held;
};

} // namespace teleta::bracelet
