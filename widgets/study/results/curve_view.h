// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/figure/figure_view.h"
#include "widgets/study/results/curve_picture.h"

namespace teleta::study {

/// Curves as a widget that can be copied and saved. Thread: GUI.
class CurveView : public base::FigureView {
    Q_OBJECT

public:
    explicit CurveView(QWidget* parent = nullptr);

    void setContent(CurveContent content);
    [[nodiscard]] const CurveContent& content() const { return m_content; }
    [[nodiscard]] base::Figure figure() override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    CurveContent m_content;
};

} // namespace teleta::study
