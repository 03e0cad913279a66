// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace teleta::base {

/// A line of plain text that never asks for more room: text that does not fit is elided, and the tool tip
/// shows all of it. Thread: GUI.
class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    using QLabel::QLabel;

    [[nodiscard]] bool isCut() const;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
};

} // namespace teleta::base
