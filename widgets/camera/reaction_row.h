// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/camera_snapshot.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QLabel;

namespace teleta::camera {

/// What the arm that carries a camera does about contacts, and whether it may. Hidden without such an arm.
/// Thread: GUI.
class ReactionRow : public QWidget {
    Q_OBJECT
public:
    explicit ReactionRow(QWidget* parent = nullptr);

    /// Empty: no arm reacts.
    void set(const std::optional<pipeline::CarrierReport>& arm, bool mayReact);

signals:
    /// A person ticked or unticked the box.
    void mayReactChanged(bool mayReact);

private:
    void retranslate();
    void showTexts();

    QCheckBox* m_mayReact;
    QLabel* m_line;
    std::optional<pipeline::CarrierReport> m_arm;
};

} // namespace teleta::camera
