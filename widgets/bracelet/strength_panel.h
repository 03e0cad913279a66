// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/tactors.h"

#include <QWidget>

#include <array>
#include <cstddef>

class QLabel;
class QSlider;
class QToolButton;

namespace teleta::bracelet {

/// How strong the motors may be at most, in whole percents: one slider for all of them, and one for each that
/// can be shown. Thread: GUI.
class StrengthPanel : public QWidget {
    Q_OBJECT
public:
    explicit StrengthPanel(QWidget* parent = nullptr);

    /// Clamped to 0 .. 1; NaN is 0. Emits nothing.
    void setStrongest(const core::Intensities& strongest);
    [[nodiscard]] const core::Intensities& strongest() const { return m_strongest; }
    /// Of all motors; and of one.
    [[nodiscard]] QSlider* allSlider() const { return m_all.slider; }
    [[nodiscard]] QSlider* slider(std::size_t motor) const { return m_each[motor].slider; }
    /// Shows the sliders of the single motors.
    [[nodiscard]] QToolButton* eachButton() const { return m_eachButton; }

signals:
    /// By a person, while a slider moves.
    void strongestChanged(const teleta::core::Intensities& strongest);

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Row {
        QLabel* label = nullptr;
        QSlider* slider = nullptr;
        QLabel* value = nullptr;
    };

    [[nodiscard]] Row makeRow(QWidget* parent);
    void showValues();
    void retranslate();

    core::Intensities m_strongest{1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
    Row m_all;
    QToolButton* m_eachButton;
    QWidget* m_eachPart;
    std::array<Row, core::kTactors> m_each;
};

} // namespace teleta::bracelet
