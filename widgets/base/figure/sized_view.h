// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSizeF>
#include <QWidget>

namespace teleta::base {

/// A self-painted view whose usual and smallest size follow its font. Thread: GUI.
class SizedView : public QWidget {
    Q_OBJECT
public:
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    /// Sizes in em; where one is empty, QWidget decides.
    SizedView(QWidget* parent, QSizeF usual_em, QSizeF smallest_em);

private:
    QSizeF m_usual_em;
    QSizeF m_smallest_em;
};

} // namespace teleta::base
