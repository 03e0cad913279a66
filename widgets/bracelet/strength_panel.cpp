// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/bracelet/strength_panel.h"

#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace teleta::bracelet {

namespace {

constexpr int kFull_percent = 100;

int percentOf(double share) {
    return static_cast<int>(std::lround(kFull_percent * share));
}

void setQuietly(QSlider* slider, int value) {
    const QSignalBlocker quiet(slider);
    slider->setValue(value);
}

} // namespace

StrengthPanel::StrengthPanel(QWidget* parent)
    : QWidget(parent)
    , m_all(makeRow(this))
    , m_top(new QGridLayout) {
    m_all.slider->setObjectName(QStringLiteral("all"));
    m_eachButton->setCheckable(true);
    m_eachButton->setArrowType(Qt::RightArrow);
    m_eachButton->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_eachButton->setAutoRaise(true);
    m_top->addWidget(m_all.label, 0, 0);
    m_top->addWidget(m_all.slider, 0, 1);
    m_top->addWidget(m_all.value, 0, 2);
    m_top->addWidget(m_eachButton, 0, 3);
    m_top->setColumnStretch(1, 1);
    // Two columns, to keep the panel flat.
    auto* grid = new QGridLayout(m_eachPart);
    grid->setContentsMargins(0, 0, 0, 0);
    constexpr int kRows = static_cast<int>(core::kTactors) / 2;
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        m_each[i] = makeRow(m_eachPart);
        m_each[i].slider->setObjectName(QStringLiteral("motor%1").arg(i + 1));
        const int row = static_cast<int>(i) % kRows;
        const int column = 3 * (static_cast<int>(i) / kRows);
        grid->addWidget(m_each[i].label, row, column);
        grid->addWidget(m_each[i].slider, row, column + 1);
        grid->addWidget(m_each[i].value, row, column + 2);
        grid->setColumnStretch(column + 1, 1);
        connect(m_each[i].slider, &QSlider::valueChanged, this, [this, i](int percent) {
            m_strongest[i] = static_cast<double>(percent) / kFull_percent;
            showValues();
            emit strongestChanged(m_strongest);
        });
    }
    m_eachPart->hide();
    auto* layout = new QVBoxLayout(this);
    const int margin = base::grid(this, 0.5);
    layout->setContentsMargins(2 * margin, margin, 2 * margin, margin);
    layout->setSpacing(margin);
    layout->addLayout(m_top);
    layout->addWidget(m_eachPart);
    connect(m_all.slider, &QSlider::valueChanged, this, [this](int percent) {
        m_strongest.fill(static_cast<double>(percent) / kFull_percent);
        showValues();
        emit strongestChanged(m_strongest);
    });
    connect(m_eachButton, &QToolButton::toggled, this, [this](bool shown) {
        m_eachButton->setArrowType(shown ? Qt::DownArrow : Qt::RightArrow);
        m_eachPart->setVisible(shown);
    });
    base::keepTranslated(this, &StrengthPanel::retranslate);
}

QSize StrengthPanel::minimumSizeHint() const {
    int width = std::max(leastRow(), m_eachButton->sizeHint().width());
    if (m_eachPart->isVisibleTo(this))
        width = std::max(width, m_eachPart->minimumSizeHint().width());
    const QMargins margins = layout()->contentsMargins();
    return {width + margins.left() + margins.right(), QWidget::minimumSizeHint().height()};
}

int StrengthPanel::leastRow() const {
    return m_all.label->sizeHint().width() + m_all.slider->minimumWidth() +
           std::max(m_all.value->minimumWidth(), m_all.value->sizeHint().width()) +
           2 * m_top->horizontalSpacing();
}

void StrengthPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

void StrengthPanel::arrange() {
    const int needed = leastRow() + m_top->horizontalSpacing() + m_eachButton->sizeHint().width();
    const bool isNarrow = layout()->contentsRect().width() < needed;
    if (isNarrow == m_isNarrow)
        return;
    m_isNarrow = isNarrow;
    m_top->removeWidget(m_eachButton);
    if (m_isNarrow)
        m_top->addWidget(m_eachButton, 1, 0, 1, 3, Qt::AlignLeft);
    else
        m_top->addWidget(m_eachButton, 0, 3);
}

StrengthPanel::Row StrengthPanel::makeRow(QWidget* parent) {
    Row row{new QLabel(parent), new QSlider(Qt::Horizontal, parent), new QLabel(parent)};
    row.slider->setRange(0, kFull_percent);
    row.slider->setPageStep(kFull_percent / 10);
    row.slider->setMinimumWidth(base::em(this, 4));
    row.value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row.value->setMinimumWidth(base::em(this, 3));
    row.label->setBuddy(row.slider);
    return row;
}

void StrengthPanel::setStrongest(const core::Intensities& strongest) {
    for (std::size_t i = 0; i < core::kTactors; ++i)
        m_strongest[i] = strongest[i] > 0.0 ? std::min(strongest[i], 1.0) : 0.0;
    showValues();
}

void StrengthPanel::showValues() {
    const QLocale locale;
    const auto show = [&locale](const Row& row, const QString& text, double share) {
        setQuietly(row.slider, percentOf(share));
        row.value->setText(text.arg(locale.toString(percentOf(share))));
    };
    for (std::size_t i = 0; i < core::kTactors; ++i)
        show(m_each[i], tr("%1 %"), m_strongest[i]);
    const auto [lowest, highest] = std::ranges::minmax(m_strongest);
    show(m_all, percentOf(lowest) == percentOf(highest) ? tr("%1 %") : tr("to %1 %"), highest);
}

void StrengthPanel::retranslate() {
    m_all.label->setText(tr("Stron&gest"));
    m_all.slider->setAccessibleName(tr("Strongest, all motors"));
    m_eachButton->setText(tr("Each motor"));
    const QString help =
        tr("The most that the motors may vibrate, whatever is played. Saved for this bracelet.");
    m_all.slider->setToolTip(help);
    m_eachButton->setToolTip(tr("A limit for each motor"));
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        m_each[i].label->setText(tr("Motor &%1").arg(i + 1));
        m_each[i].slider->setAccessibleName(tr("Strongest, motor %1").arg(i + 1));
        m_each[i].slider->setToolTip(help);
    }
    showValues();
}

} // namespace teleta::bracelet
