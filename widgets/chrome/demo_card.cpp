// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/demo_card.h"

#include "widgets/base/control_painter.h"
#include "widgets/base/mnemonics.h"
#include "widgets/base/theme.h"

#include <QPainter>
#include <QPainterPath>
#include <QStyleOption>
#include <QTextLayout>

namespace teleta::chrome {

namespace {

constexpr double kCard_em = 20.0;
constexpr int kLines = 2; ///< of what is said about it

/// Draws text in a few lines from the top of a rect; the last one ends in an ellipsis if there is more.
void drawLines(QPainter& painter, const QRectF& rect, const QString& text) {
    const QFontMetricsF metrics(painter.font(), painter.device());
    QTextLayout layout(text, painter.font());
    layout.beginLayout();
    double y = rect.top();
    for (int i = 0; i < kLines; ++i) {
        QTextLine line = layout.createLine();
        if (!line.isValid())
            break;
        line.setLineWidth(rect.width());
        const int start = line.textStart();
        const bool isLast = i + 1 == kLines;
        const QString shown = isLast ? metrics.elidedText(text.mid(start), Qt::ElideRight, rect.width())
                                     : text.mid(start, line.textLength());
        painter.drawText(QRectF(rect.left(), y, rect.width(), metrics.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, shown);
        y += metrics.height();
    }
    layout.endLayout();
}

} // namespace

DemoCard::DemoCard(base::Icon icon, const QString& title, const QString& about, QWidget* parent)
    : QAbstractButton(parent)
    , m_icon(icon)
    , m_about(about) {
    setText(base::withoutMnemonic(title));
    setAccessibleName(title);
    setAccessibleDescription(about);
    setToolTip(about);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void DemoCard::setPicture(const QImage& picture) {
    m_picture = picture;
    update();
}

QSize DemoCard::sizeHint() const {
    const int margin = base::grid(this);
    return {base::em(this, kCard_em), base::em(this, kPicture_em.height()) + margin};
}

QSize DemoCard::minimumSizeHint() const {
    return {base::em(this, 2.0 * kPicture_em.width()), sizeHint().height()};
}

void DemoCard::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    QStyleOption option;
    option.initFrom(this);
    option.state.setFlag(QStyle::State_Sunken, isDown());
    base::ControlPainter flat(painter, option);
    const base::ControlColours& colours = flat.colours();
    const QRectF card(rect());
    flat.box(card, flat.pressed() ? colours.pressed : palette().color(QPalette::Base),
             flat.under() ? colours.edge : colours.faint, base::kCardRadius);
    if (flat.focused())
        flat.box(card, {}, colours.ring, base::kCardRadius, base::ControlPainter::kRing_px);

    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const double radius = flat.px(base::kCardRadius);
    const double margin = flat.px(base::kTight);
    const QRectF picture(card.left() + margin, card.top() + margin, base::em(this, kPicture_em.width()),
                         card.height() - 2.0 * margin);
    QPainterPath rounded;
    rounded.addRoundedRect(picture, 0.5 * radius, 0.5 * radius);
    painter.save();
    painter.setClipPath(rounded);
    painter.fillRect(picture, colours.hover);
    if (hasPicture()) {
        const QSizeF size = QSizeF(m_picture.size()).scaled(picture.size(), Qt::KeepAspectRatioByExpanding);
        QRectF place(QPointF(), size);
        place.moveCenter(picture.center());
        painter.drawImage(place, m_picture);
    } else {
        const double side = 0.5 * picture.height();
        QRectF place(0, 0, side, side);
        place.moveCenter(picture.center());
        base::paintIcon(painter, place, m_icon, palette().color(QPalette::PlaceholderText));
    }
    painter.restore();

    const double left = picture.right() + base::grid(this);
    const QFont title = base::bold(font());
    const QFont small = base::sized(font(), base::kSmallText);
    const QFontMetricsF titleMetrics(title);
    const QFontMetricsF smallMetrics(small);
    const double height = titleMetrics.height() + kLines * smallMetrics.height();
    const QRectF text(left, card.center().y() - 0.5 * height, card.right() - margin - left, height);
    painter.setFont(title);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(text, Qt::AlignLeft | Qt::AlignTop,
                     titleMetrics.elidedText(this->text(), Qt::ElideRight, text.width()));
    painter.setFont(small);
    painter.setPen(palette().color(QPalette::PlaceholderText));
    drawLines(painter, text.adjusted(0.0, titleMetrics.height(), 0.0, 0.0), m_about);
}

} // namespace teleta::chrome
