// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/start/demo_card.h"

#include "widgets/base/control_painter.h"
#include "widgets/base/mnemonics.h"
#include "widgets/base/theme.h"

#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <QStyleOption>
#include <QTextLayout>

namespace teleta::chrome {

namespace {

constexpr double kCard_em = 20.0;
constexpr double kSmallCard_em = 11.0;
constexpr QSizeF kSmallPicture_em(2.8, 1.85);
constexpr int kTitleLines = 2;
constexpr int kLines = 3; ///< of the title and of what is said about it, on a large card

/// Draws text from the top of a rect; the last of the lines ends in an ellipsis if there is more.
void drawLines(QPainter& painter, const QRectF& rect, const QString& text, int lines) {
    const QFontMetricsF metrics(painter.font(), painter.device());
    QTextLayout layout(text, painter.font());
    layout.beginLayout();
    double y = rect.top();
    for (int i = 0; i < lines; ++i) {
        QTextLine line = layout.createLine();
        if (!line.isValid())
            break;
        line.setLineWidth(rect.width());
        const int start = line.textStart();
        const bool isLast = i + 1 == lines;
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
    , m_icon(icon) {
    setTexts(title, about);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void DemoCard::setTexts(const QString& title, const QString& about) {
    m_about = about;
    setText(base::withoutMnemonic(title));
    setAccessibleName(title);
    describe();
    update();
}

void DemoCard::describe() {
    setAccessibleDescription(m_step == Step::done ? tr("Done. %1").arg(m_about) : m_about);
    // A small card says nothing else, and may cut its title.
    setToolTip(m_size == Size::small ? accessibleName() + QLatin1Char('\n') + m_about : m_about);
}

void DemoCard::setSize(Size size) {
    if (size == m_size)
        return;
    m_size = size;
    describe();
    updateGeometry();
    update();
}

void DemoCard::setStep(Step step) {
    m_step = step;
    describe();
    update();
}

QSizeF DemoCard::picture_em() const {
    return m_size == Size::large ? kPicture_em : kSmallPicture_em;
}

void DemoCard::setPicture(const QImage& picture) {
    m_picture = picture;
    update();
}

int DemoCard::heightOf(const QWidget& widget, Size size) {
    const QSizeF& picture_em = size == Size::large ? kPicture_em : kSmallPicture_em;
    return base::em(&widget, picture_em.height()) + base::grid(&widget);
}

QSize DemoCard::sizeHint() const {
    return {base::em(this, m_size == Size::large ? kCard_em : kSmallCard_em), heightOf(*this, m_size)};
}

QSize DemoCard::minimumSizeHint() const {
    return {base::em(this, 2.0 * picture_em().width()), sizeHint().height()};
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
    const QRectF picture(card.left() + margin, card.top() + margin, base::em(this, picture_em().width()),
                         card.height() - 2.0 * margin);
    QPainterPath rounded;
    rounded.addRoundedRect(picture, 0.5 * radius, 0.5 * radius);
    painter.save();
    painter.setClipPath(rounded);
    painter.fillRect(picture, colours.hover);
    if (m_step != Step::none) {
        paintStep(painter, picture);
    } else if (hasPicture()) {
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
    const QFont shown = m_size == Size::small ? base::bold(small) : title;
    const QFontMetricsF titleMetrics(shown);
    const QFontMetricsF smallMetrics(small);
    const QRectF room(left, card.top(), card.right() - margin - left, card.height());
    painter.setFont(shown);
    painter.setPen(palette().color(QPalette::Text));
    const bool isLong = titleMetrics.horizontalAdvance(text()) > room.width();
    const int titleLines = isLong ? kTitleLines : 1;
    const int moreLines = m_size == Size::small ? 0 : kLines - titleLines;
    const double title_px = titleLines * titleMetrics.height();
    const double height = title_px + moreLines * smallMetrics.height();
    const QRectF lines(left, card.center().y() - 0.5 * height, room.width(), height);
    drawLines(painter, lines, text(), titleLines);
    painter.setFont(small);
    painter.setPen(palette().color(QPalette::PlaceholderText));
    drawLines(painter, lines.adjusted(0.0, title_px, 0.0, 0.0), m_about, moreLines);
}

/// What the step is about, and whether it was done.
void DemoCard::paintStep(QPainter& painter, const QRectF& place) const {
    const double side = 0.62 * place.height();
    QRectF icon(0.0, 0.0, side, side);
    icon.moveCenter({place.center().x() - 0.35 * side, place.center().y()});
    base::paintIcon(painter, icon, m_icon, palette().color(QPalette::PlaceholderText));
    const double radius = 0.24 * side;
    const QPointF centre(icon.right() + 2.0 * radius, icon.center().y());
    const bool isDone = m_step == Step::done;
    const QColor colour =
        isDone ? base::statusColours(palette()).live : palette().color(QPalette::PlaceholderText);
    painter.setPen(QPen(colour, 0.16 * radius * 2.0));
    painter.setBrush(isDone ? QBrush(colour) : QBrush(Qt::NoBrush));
    painter.drawEllipse(centre, radius, radius);
    if (!isDone)
        return;
    QPen tick(palette().color(QPalette::Base), 0.34 * radius, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    painter.setPen(tick);
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(QPolygonF{centre + QPointF(-0.45, 0.05) * radius,
                                   centre + QPointF(-0.1, 0.4) * radius,
                                   centre + QPointF(0.5, -0.35) * radius});
}

} // namespace teleta::chrome
