// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/recording_indicator.h"

#include "widgets/base/icons.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QHBoxLayout>
#include <QLocale>
#include <QPainter>
#include <QPixmap>

#include <algorithm>
#include <cmath>

namespace teleta::chrome {

namespace {

using State = RecordingReading::State;

QString minutes(double duration_s) {
    const auto seconds = static_cast<long long>(std::floor(std::max(duration_s, 0.0)));
    return QStringLiteral("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QLatin1Char('0'));
}

/// Filled while recording, otherwise a ring.
QIcon dot(const QWidget& widget, bool filled) {
    const int side = base::em(&widget, 1);
    const qreal scale = widget.devicePixelRatioF();
    QPixmap picture(QSize(side, side) * scale);
    picture.setDevicePixelRatio(scale);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor red = base::statusColours(widget.palette()).stop;
    painter.setPen(QPen(red, 0.12 * side));
    painter.setBrush(filled ? QBrush(red) : QBrush(Qt::NoBrush));
    painter.drawEllipse(QRectF(0.15 * side, 0.15 * side, 0.7 * side, 0.7 * side));
    return picture;
}

} // namespace

RecordingIndicator::RecordingIndicator(QWidget* parent)
    : QWidget(parent) {
    for (QToolButton* button : {m_record, m_mark}) {
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
    }
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, base::grid(this), 0);
    row->setSpacing(base::grid(this, 0.5));
    row->addWidget(m_record);
    row->addWidget(m_mark);
    connect(m_record, &QToolButton::clicked, this, &RecordingIndicator::toggleRequested);
    connect(m_mark, &QToolButton::clicked, this, &RecordingIndicator::markRequested);
    restyle();
    base::keepTranslated(this, &RecordingIndicator::describe);
    base::onChange(this, &RecordingIndicator::restyle, {QEvent::PaletteChange, QEvent::FontChange});
}

void RecordingIndicator::setReading(const RecordingReading& reading) {
    const RecordingReading before = m_reading;
    m_reading = reading;
    const QString now = text();
    if (m_record->text() != now)
        m_record->setText(now);
    if (before.state == reading.state && before.problem == reading.problem)
        return;
    restyle();
    describe();
}

QString RecordingIndicator::text() const {
    switch (m_reading.state) {
    case State::starting:
        return tr("Starting\u2026");
    case State::stopping:
        return tr("Finishing\u2026");
    case State::recording:
        return tr("Recording %1 \u00b7 %2 \u00b7 %n lost", "time, size of the file, frames",
                  static_cast<int>(m_reading.lost))
            .arg(minutes(m_reading.duration_s),
                 QLocale().formattedDataSize(static_cast<qint64>(m_reading.bytes), 1,
                                             QLocale::DataSizeSIFormat));
    case State::idle:
        break;
    }
    return m_reading.problem.isEmpty() ? tr("Record") : tr("Recording failed");
}

void RecordingIndicator::restyle() {
    const bool recording = m_reading.state == State::recording;
    m_record->setIcon(dot(*this, recording));
    QFont font = this->font();
    font.setBold(recording || !m_reading.problem.isEmpty());
    m_record->setFont(font);
    m_mark->setIcon(base::themeIcon(base::Icon::mark));
}

void RecordingIndicator::describe() {
    const bool recording = m_reading.state == State::recording;
    m_record->setText(text());
    m_record->setEnabled(recording || m_reading.state == State::idle);
    const QString record = tr("Record all sources and the bracelet into a file (Ctrl+R)");
    m_record->setToolTip(recording                     ? tr("End the recording (Ctrl+R)")
                         : m_reading.problem.isEmpty() ? record
                                                       : m_reading.problem + QLatin1Char('\n') + record);
    m_record->setAccessibleName(recording                     ? tr("End the recording")
                                : m_reading.problem.isEmpty() ? tr("Record")
                                                              : tr("Recording failed. Record"));
    m_mark->setText(tr("Mark"));
    m_mark->setToolTip(tr("Mark this moment (M)"));
    m_mark->setAccessibleName(tr("Mark this moment"));
    m_mark->setVisible(recording);
}

} // namespace teleta::chrome
