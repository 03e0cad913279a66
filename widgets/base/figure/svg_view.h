// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/figure/svg_canvas.h"
#include "widgets/base/figure/figure_view.h"

#include <QString>

#include <memory>
#include <optional>

class QSvgRenderer;

namespace teleta::base {

/// A picture that a result is drawn as, in the colours of the palette; on paper and in files it is the one
/// that an analysis writes. It can be copied and saved. Thread: GUI.
class SvgView : public FigureView {
    Q_OBJECT

public:
    explicit SvgView(QWidget* parent = nullptr);
    ~SvgView() override;

    struct Picture {
        QString file;  ///< its name, without an extension
        QString words; ///< what it shows, for readers who do not see it
        figure::SvgCanvas canvas;
        QString csv; ///< the data behind it
    };

    /// Empty: nothing is shown.
    void setPicture(std::optional<Picture> picture);
    [[nodiscard]] const std::optional<Picture>& picture() const { return m_picture; }
    [[nodiscard]] Figure figure() override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    std::optional<Picture> m_picture;
    std::unique_ptr<QSvgRenderer> m_renderer; ///< in the colours of the palette; null: to be made
};

} // namespace teleta::base
