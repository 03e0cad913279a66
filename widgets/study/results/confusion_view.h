// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/figure/figure_view.h"
#include "widgets/study/results/confusion_picture.h"

#include <QWidget>

namespace teleta::study {

/// A confusion matrix; Space or a double click switches between counts and percent. Thread: GUI.
class ConfusionView : public base::FigureView {
    Q_OBJECT

public:
    explicit ConfusionView(QWidget* parent = nullptr);

    /// The view ignores `percent` of the content.
    void setContent(ConfusionContent content);
    [[nodiscard]] const ConfusionContent& content() const { return m_content; }
    void setPercent(bool percent);
    [[nodiscard]] base::Figure figure() override;

signals:
    void percentChanged(bool percent);

protected:
    [[nodiscard]] QString toolTipAt(const QPointF& point) const override;
    void addOwnActions(QMenu& menu, const QPoint& position) override;
    void paintEvent(QPaintEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void describe();

    ConfusionContent m_content;
};

} // namespace teleta::study
