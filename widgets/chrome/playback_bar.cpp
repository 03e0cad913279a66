// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/playback_bar.h"

#include "widgets/base/compose.h"
#include "widgets/base/icons.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QAbstractItemView>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace teleta::chrome {

namespace {

constexpr int kSliderSteps = 10'000;
constexpr std::array kSpeeds{0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0};

QString clockText(double time_s) {
    const auto tenths = static_cast<long long>(std::floor(std::max(time_s, 0.0) * 10.0));
    return QStringLiteral("%1:%2.%3")
        .arg(tenths / 600)
        .arg(tenths / 10 % 60, 2, 10, QLatin1Char('0'))
        .arg(tenths % 10);
}

/// Time of the first frame on the clock of the marks, which counts from the start of the recording.
double beginOf(const std::vector<core::PlaybackMark>& marks) {
    return marks.empty() ? 0.0 : marks.front().sourceTime_s - marks.front().time_s;
}

} // namespace

PlaybackBar::PlaybackBar(QWidget* parent)
    : QWidget(parent) {
    m_loop->setCheckable(true);
    m_slider->setRange(0, kSliderSteps);
    m_slider->setFocusPolicy(Qt::TabFocus);
    for (const double speed : kSpeeds)
        m_speed->addItem(QStringLiteral("%1 \u00d7").arg(speed), speed);
    m_speed->setCurrentIndex(3);

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(base::grid(this), base::grid(this, 0.5), base::grid(this),
                               base::grid(this, 0.5));
    layout->setSpacing(base::grid(this, 0.5));
    base::addWidgets(layout, {m_toStart, m_back, m_play, m_forward});
    layout->addWidget(m_slider, 1);
    base::addWidgets(layout, {m_time, m_speed, m_loop});

    connect(m_toStart, &QToolButton::clicked, this, [this] { emit seekRequested(0.0); });
    connect(m_back, &QToolButton::clicked, this, [this] { emit stepRequested(-1); });
    connect(m_forward, &QToolButton::clicked, this, [this] { emit stepRequested(1); });
    connect(m_play, &QToolButton::clicked, this, &PlaybackBar::togglePlay);
    connect(m_loop, &QToolButton::clicked, this, &PlaybackBar::loopRequested);
    connect(m_slider, &QSlider::valueChanged, this,
            [this](int value) { emit seekRequested(sliderTime_s(value)); });
    connect(m_speed, &QComboBox::activated, this,
            [this] { emit speedRequested(m_speed->currentData().toDouble()); });
    base::keepTranslated(this, &PlaybackBar::retranslate);
    restyle();
    setPosition({});
    base::onChange(this, &PlaybackBar::restyle, {QEvent::PaletteChange, QEvent::FontChange});
}

void PlaybackBar::setPosition(const core::PlaybackPosition& position) {
    m_position = position;
    const double share =
        position.duration_s > 0.0 ? std::clamp(position.time_s / position.duration_s, 0.0, 1.0) : 0.0;
    m_slider->setDuration(position.duration_s);
    if (!m_slider->isSliderDown()) {
        const QSignalBlocker blocked(m_slider);
        m_slider->setValue(qRound(share * kSliderSteps));
    }
    const double begin_s = beginOf(m_marks);
    const QString total = clockText(begin_s + position.duration_s);
    const QString text = tr("%1 / %2", "time and duration")
                             .arg(clockText(begin_s + position.time_s),
                                  position.indexed ? total : total + QStringLiteral(" \u2026"));
    if (m_time->text() != text) {
        m_time->setText(text);
        m_time->setToolTip(tr("Frame %1 of %2").arg(position.frame + 1).arg(position.frames));
    }
    if (m_loop->isChecked() != position.loop)
        m_loop->setChecked(position.loop);
    const auto nearest = std::min_element(kSpeeds.begin(), kSpeeds.end(), [&](double a, double b) {
        return std::abs(std::log(a / position.speed)) < std::abs(std::log(b / position.speed));
    });
    const auto index = static_cast<int>(nearest - kSpeeds.begin());
    if (position.speed > 0.0 && std::isfinite(position.speed) && m_speed->currentIndex() != index &&
        !m_speed->view()->isVisible())
        m_speed->setCurrentIndex(index);
    if (position.paused != m_shownPaused) {
        m_shownPaused = position.paused;
        restyle();
        retranslate();
    }
}

void PlaybackBar::setMarks(std::vector<core::PlaybackMark> marks) {
    m_marks = std::move(marks);
    m_slider->setMarks(m_marks);
}

void PlaybackBar::goToMark(bool forward) {
    // The mark that was just jumped to counts as passed, whatever the rounding to frames.
    constexpr double kSame_s = 0.3;
    const double now_s = m_position.time_s;
    if (forward) {
        const auto next = std::ranges::find_if(
            m_marks, [&](const core::PlaybackMark& mark) { return mark.time_s > now_s + kSame_s; });
        if (next != m_marks.end())
            emit seekRequested(next->time_s);
        return;
    }
    const auto before = std::find_if(m_marks.rbegin(), m_marks.rend(), [&](const core::PlaybackMark& mark) {
        return mark.time_s < now_s - kSame_s;
    });
    if (before != m_marks.rend())
        emit seekRequested(before->time_s);
}

void PlaybackBar::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Space:
        togglePlay();
        return;
    case Qt::Key_Left:
        emit stepRequested(-1);
        return;
    case Qt::Key_Right:
        emit stepRequested(1);
        return;
    case Qt::Key_Home:
        emit seekRequested(0.0);
        return;
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
        goToMark(event->key() == Qt::Key_PageDown);
        return;
    case Qt::Key_End:
        emit seekRequested(m_position.duration_s);
        return;
    default:
        QWidget::keyPressEvent(event);
    }
}

QToolButton* PlaybackBar::makeButton(const char* name) {
    auto* button = base::named<QToolButton>(name, this);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

void PlaybackBar::restyle() {
    m_toStart->setIcon(base::themeIcon(base::Icon::toStart));
    m_back->setIcon(base::themeIcon(base::Icon::stepBack));
    m_play->setIcon(base::themeIcon(m_shownPaused ? base::Icon::play : base::Icon::pause));
    m_forward->setIcon(base::themeIcon(base::Icon::stepForward));
    m_loop->setIcon(base::themeIcon(base::Icon::loop));
    // Room for "000:00.0 / 000:00.0 ..." so that the slider keeps its size while time runs.
    m_time->setMinimumWidth(
        QFontMetrics(m_time->font()).horizontalAdvance(QStringLiteral("000:00.0 / 000:00.0 ")));
    m_time->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
}

void PlaybackBar::retranslate() {
    const auto name = [](QWidget* widget, const QString& text, const QString& key) {
        widget->setAccessibleName(text);
        widget->setToolTip(key.isEmpty() ? text : QStringLiteral("%1 (%2)").arg(text, key));
    };
    setAccessibleName(tr("Playback"));
    name(m_toStart, tr("To the start"), tr("Home"));
    name(m_back, tr("One frame back"), tr("Left"));
    name(m_play, m_shownPaused ? tr("Play") : tr("Pause"), tr("Space"));
    name(m_forward, tr("One frame forward"), tr("Right"));
    name(m_loop, tr("Repeat"), {});
    name(m_slider, tr("Time in the recording"), {});
    name(m_speed, tr("Speed"), {});
}

void PlaybackBar::togglePlay() {
    if (m_shownPaused)
        emit playRequested();
    else
        emit pauseRequested();
}

double PlaybackBar::sliderTime_s(int value) const {
    return m_position.duration_s * value / kSliderSteps;
}

} // namespace teleta::chrome
