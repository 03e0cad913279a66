// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/controls/badge.h"

#include <QWidget>

namespace teleta::base {

/// The thin line along the top of a view whose data are not live: violet for simulated data, blue-grey for
/// recorded ones. It lies over the view, follows its size, and lets the mouse through. The word stands once
/// in the page's title; a screen reader finds it here too. Thread: GUI.
class ProvenanceStripe : public QWidget {
    Q_OBJECT

public:
    explicit ProvenanceStripe(QWidget* view);

    void setProvenance(Provenance provenance);
    [[nodiscard]] Provenance provenance() const { return m_provenance; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void place();
    void describe();

    Provenance m_provenance = Provenance::live;
};

/// Gives a view its stripe, which it makes when it is needed first, or takes it away. Thread: GUI.
void showProvenance(QWidget* view, Provenance provenance);

/// The word for data that are not live, as a badge: once in the title of a page. Hidden for live data.
/// Thread: GUI.
class ProvenanceBadge : public QWidget {
    Q_OBJECT

public:
    explicit ProvenanceBadge(QWidget* parent = nullptr);

    void setProvenance(Provenance provenance);
    [[nodiscard]] Provenance provenance() const { return m_provenance; }
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void describe();

    Provenance m_provenance = Provenance::live;
};

} // namespace teleta::base
