// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/stop_banner.h"

#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QPainter>

namespace teleta::chrome {

StopBanner::StopBanner(QWidget* parent)
    : QWidget(parent) {
    m_what->setObjectName(QStringLiteral("stopCause"));
    m_next->setObjectName(QStringLiteral("stopNext"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(base::grid(this, 2), base::grid(this, 0.75), base::grid(this, 2),
                            base::grid(this, 0.75));
    row->setSpacing(base::grid(this, 3));
    for (QLabel* label : {m_what, m_next}) {
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
        row->addWidget(label, label == m_what ? 2 : 3);
    }
    restyle();
    base::keepTranslated(this, &StopBanner::describe);
    base::onChange(this, &StopBanner::restyle, {QEvent::PaletteChange, QEvent::FontChange});
    hide();
}

void StopBanner::engage(StopCause cause, const QDateTime& since) {
    m_cause = cause;
    m_since = since;
    describe();
    show();
    QAccessibleEvent alert(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

void StopBanner::release() {
    hide();
}

QString StopBanner::sentence(StopCause cause) {
    switch (cause) {
    case StopCause::button:
        return tr("The STOP button was pressed.");
    case StopCause::keys:
        return tr("Ctrl+. was pressed.");
    case StopCause::escape:
        return tr("Esc was pressed twice.");
    case StopCause::program:
        break;
    }
    return tr("The program engaged STOP.");
}

void StopBanner::describe() {
    m_what->setText(tr("STOPPED since %1. %2", "time, cause")
                        .arg(m_since.toString(QStringLiteral("HH:mm:ss")), sentence(m_cause)));
    m_next->setText(
        tr("Motors are off and arms are held. To continue, hold the STOPPED button for one second."));
    setAccessibleName(m_what->text());
    setAccessibleDescription(m_next->text());
}

void StopBanner::restyle() {
    for (QLabel* label : {m_what, m_next})
        base::setTextColour(label, Qt::white);
    m_what->setFont(base::bold(font()));
}

void StopBanner::paintEvent(QPaintEvent* /*event*/) {
    QPainter(this).fillRect(rect(), base::statusColours(palette()).stop);
}

} // namespace teleta::chrome
