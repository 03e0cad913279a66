// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>
#include <QPixmap>
#include <QWidget>

namespace teleta::base {

/// A slow part of a widget, painted once for each place, scale, palette and font. Thread: GUI.
class KeptPicture {
public:
    /// Calls paint(QPainter&, const QRectF&) unless the kept picture is that of this rect. Call forget() when
    /// anything else changes.
    template <typename Paint>
    void draw(QPainter& painter, const QRectF& rect, const QWidget& widget, const Paint& paint) {
        const QRect whole = rect.toAlignedRect();
        if (whole.isEmpty())
            return;
        const qreal scale = widget.devicePixelRatioF();
        const qint64 palette = widget.palette().cacheKey();
        if (m_picture.isNull() || m_rect != rect || m_palette != palette || m_font != widget.font() ||
            m_picture.devicePixelRatio() != scale) {
            m_picture = QPixmap((QSizeF(whole.size()) * scale).toSize());
            m_picture.setDevicePixelRatio(scale);
            m_picture.fill(Qt::transparent);
            m_rect = rect;
            m_palette = palette;
            m_font = widget.font();
            QPainter inner(&m_picture);
            inner.setFont(m_font);
            paint(inner, rect.translated(-whole.topLeft()));
        }
        painter.drawPixmap(whole.topLeft(), m_picture);
    }
    void forget() { m_picture = QPixmap(); }

private:
    QPixmap m_picture;
    QRectF m_rect;
    qint64 m_palette = 0;
    QFont m_font;
};

} // namespace teleta::base
