// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/tactors.h"
#include "widgets/base/compose.h"

#include <QToolButton>
#include <QWidget>

#include <array>

class QGridLayout;
class QLabel;
class QSlider;

namespace teleta::bracelet {

/// Limits of the motors' intensities in whole percent: one slider for all or, unfolded by a button, one per
/// motor. Thread: GUI.
class StrengthPanel : public QWidget {
    Q_OBJECT
public:
    explicit StrengthPanel(QWidget* parent = nullptr);

    /// Clamped to 0 .. 1; NaN is 0. Emits nothing.
    void setStrongest(const core::Intensities& strongest);
    [[nodiscard]] const core::Intensities& strongest() const { return m_strongest; }

    /// Of the narrow panel, with the button in a row of its own.
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /// The user has moved a slider.
    void strongestChanged(const teleta::core::Intensities& strongest);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Row {
        QLabel* label = nullptr;
        QSlider* slider = nullptr;
        QLabel* value = nullptr;
    };

    [[nodiscard]] Row makeRow(QWidget* parent);
    /// Puts the button beside the slider, or below it where there is too little room.
    void arrange();
    /// Width of name, slider and value.
    [[nodiscard]] int leastRow() const;
    void showValues();
    void retranslate();

    core::Intensities m_strongest{1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
    Row m_all;
    QGridLayout* m_top;
    bool m_isNarrow = false;
    QToolButton* m_eachButton = base::named<QToolButton>("each", this);
    QWidget* m_eachPart = new QWidget(this);
    std::array<Row, core::kTactors> m_each;
};

} // namespace teleta::bracelet
