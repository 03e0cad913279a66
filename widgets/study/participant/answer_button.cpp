// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/participant/answer_button.h"

#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace teleta::study {

namespace {

/// The font, reduced if the text is too wide.
QFont fitted(QFont font, const QString& text, double width) {
    const double needed = QFontMetricsF(font).horizontalAdvance(text);
    if (needed > width)
        font.setPixelSize(std::max(1, static_cast<int>(font.pixelSize() * width / needed)));
    return font;
}

} // namespace

AnswerButton::AnswerButton(AnswerChoice choice, std::size_t digit, QWidget* parent)
    : SizedView(parent, {14, 15}, {6, 6})
    , m_choice(std::move(choice))
    , m_digit(digit) {
    // The window handles presses, in one place and as they arrive.
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    base::keepTranslated(this, &AnswerButton::describe);
}

void AnswerButton::describe() {
    const QString answer = m_choice.isPattern
                               ? tr("Answer %1: %2", "letter, name").arg(m_choice.letter, m_choice.name)
                               : tr("Answer: %1", "yes, no, a number ..").arg(m_choice.name);
    setAccessibleName(
        m_look == Look::right
            ? (m_choice.isPattern ? tr("%1. This was felt.") : tr("%1. This was right.")).arg(answer)
        : m_look == Look::wrong ? tr("%1. This was answered.").arg(answer)
                                : answer);
}

void AnswerButton::setDiagramShown(bool shown) {
    if (std::exchange(m_diagramShown, shown) != shown)
        update();
}

void AnswerButton::setOpen(bool open) {
    if (std::exchange(m_open, open) != open)
        update();
}

void AnswerButton::setLook(Look look) {
    if (std::exchange(m_look, look) == look)
        return;
    describe();
    update();
}

void AnswerButton::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPalette& colours = palette();
    const base::StatusColours& status = base::statusColours(colours);
    const QColor ground = colours.color(QPalette::Base);
    const QColor text = colours.color(QPalette::Text);
    QColor edge = base::mixed(ground, text, m_open ? 0.55 : 0.22);
    QColor fill = m_open ? ground : base::mixed(ground, colours.color(QPalette::Window), 0.7);
    QString mark;
    double width = m_open ? 2.0 : 1.0;
    if (m_look != Look::plain) {
        edge = m_look == Look::right   ? status.live
               : m_look == Look::wrong ? status.lost
                                       : colours.color(QPalette::Highlight);
        fill = base::mixed(ground, edge, m_look == Look::lit ? 0.4 : 0.14);
        width = 4.0;
        mark = m_look == Look::lit     ? QString()
               : m_look == Look::right ? (m_choice.isPattern ? tr("\u2713 felt") : tr("\u2713 right"))
               : m_look == Look::wrong ? tr("\u2717 your answer")
                                       : tr("your answer");
    }
    const double em = base::em(this, 1.0);
    const QRectF box = QRectF(rect()).adjusted(3, 3, -3, -3);
    painter.setPen(QPen(edge, width));
    painter.setBrush(fill);
    painter.drawRoundedRect(box, 0.5 * em, 0.5 * em);

    const QRectF inside = box.adjusted(0.7 * em, 0.6 * em, -0.7 * em, -0.6 * em);
    const double unit = std::clamp(0.13 * std::min(inside.width(), inside.height()), em, 2.6 * em);
    const double faint = m_open || m_look != Look::plain ? 1.0 : 0.55;
    QFont font = base::bold(this->font());
    font.setPixelSize(static_cast<int>((m_diagramShown ? 1.3 : 2.2) * unit));
    painter.setFont(font);
    painter.setPen(base::mixed(ground, text, faint));
    const double head = (m_diagramShown ? 1.7 : 2.8) * unit;
    const QRectF letter(inside.left(), m_diagramShown ? inside.top() : inside.center().y() - head,
                        inside.width(), head);
    painter.drawText(letter, m_diagramShown ? Qt::AlignLeft | Qt::AlignVCenter : Qt::AlignCenter,
                     m_choice.isPattern ? m_choice.letter : m_choice.name);
    font.setBold(false);
    font.setPixelSize(static_cast<int>(0.8 * unit));
    painter.setFont(font);
    const QRectF name(inside.left(), m_diagramShown ? inside.bottom() - 1.2 * unit : letter.bottom(),
                      inside.width(), 1.2 * unit);
    const QString below = m_choice.isPattern ? m_choice.name : QString();
    const QString words =
        mark.isEmpty() || below.isEmpty() ? below + mark : below + QStringLiteral(" \u2014 ") + mark;
    painter.setFont(fitted(font, words, name.width()));
    painter.drawText(name, Qt::AlignCenter, words);
    painter.setFont(font);

    // The key cap.
    const QRectF key(inside.right() - 1.5 * unit, inside.top(), 1.5 * unit, 1.5 * unit);
    painter.setPen(QPen(base::mixed(ground, text, 0.4 * faint), 1.0));
    painter.setBrush(base::mixed(ground, text, 0.05));
    painter.drawRoundedRect(key, 0.25 * unit, 0.25 * unit);
    painter.setPen(base::mixed(ground, text, 0.8 * faint));
    painter.drawText(key, Qt::AlignCenter, m_choice.key.isEmpty() ? QString::number(m_digit) : m_choice.key);

    if (m_diagramShown) {
        painter.setOpacity(faint);
        m_diagram.draw(painter,
                       QRectF(inside.left(), inside.top() + 0.6 * head, inside.width(),
                              name.top() - inside.top() - 0.6 * head),
                       *this, [&](QPainter& to, const QRectF& rect) {
                           paintDiagram(to, rect, m_choice.diagram, colours);
                       });
    }
}

} // namespace teleta::study
