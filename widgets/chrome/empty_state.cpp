// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/empty_state.h"

#include "widgets/base/compose.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QPainter>
#include <QPixmap>
#include <QPushButton>

namespace teleta::chrome {

namespace {

constexpr double kEmptyPicture_em = 4.0;
constexpr double kBriefGap = 1.0; ///< between the things below the buttons, where there is little room

} // namespace

EmptyState::EmptyState(base::Icon icon, QWidget* parent)
    : QWidget(parent)
    , m_icon(icon) {
    for (QLabel* label : {m_picture, m_headline, m_sentence})
        label->setAlignment(Qt::AlignCenter);
    m_sentence->setWordWrap(true);
    m_buttons->addStretch(1);
    m_buttons->addStretch(1);

    m_layout->addStretch(2);
    base::addWidgets(m_layout, {m_picture, m_headline, m_sentence});
    m_layout->addSpacing(base::grid(this, 2));
    m_layout->addLayout(m_buttons);
    m_layout->addStretch(3);
    restyle();
    base::onChange(this, &EmptyState::restyle, {QEvent::PaletteChange, QEvent::FontChange});
}

void EmptyState::setTexts(const QString& headline, const QString& sentence) {
    m_headline->setText(headline);
    m_sentence->setText(sentence);
    setAccessibleName(headline);
    setAccessibleDescription(sentence);
}

void EmptyState::setBrief(bool brief) {
    m_headline->setVisible(!brief);
    m_sentence->setVisible(!brief);
    if (m_more != nullptr)
        m_more->setSpacing(base::grid(this, brief ? kBriefGap : base::kSection));
}

int EmptyState::neededHeight(bool brief) const {
    const auto nextTo = [this](const QWidget* label, int height) {
        return label->isHidden() ? 0 : height + m_layout->spacing();
    };
    const int height = m_layout->sizeHint().height() - nextTo(m_picture, m_picture->sizeHint().height());
    if (m_headline->isHidden() == brief)
        return height;
    int words =
        m_headline->sizeHint().height() + m_sentence->heightForWidth(width()) + 2 * m_layout->spacing();
    for (int i = 0, shown = 0; m_more != nullptr && i < m_more->count(); ++i)
        if (!m_more->itemAt(i)->widget()->isHidden() && ++shown > 1)
            words += base::grid(this, base::kSection) - base::grid(this, kBriefGap);
    return brief ? height - words : height + words;
}

QPushButton* EmptyState::addAction(const QString& text, const QString& toolTip) {
    auto* button = new QPushButton(text, this);
    button->setToolTip(toolTip);
    button->setAutoDefault(true);
    button->setDefault(m_buttons->count() == 2); // the two stretches
    m_buttons->insertWidget(m_buttons->count() - 1, button);
    return button;
}

void EmptyState::setAction(const char* name, const QString& text, const QString& toolTip) {
    auto* button = findChild<QPushButton*>(QLatin1String(name));
    Q_ASSERT(button != nullptr);
    button->setText(text);
    button->setToolTip(toolTip);
    button->setMinimumWidth(0);
    button->setMinimumWidth(button->sizeHint().width() + base::grid(this, base::kGroup));
}

void EmptyState::setMore(QWidget* more) {
    if (m_more == nullptr) {
        m_more = new QVBoxLayout;
        m_more->setSpacing(base::grid(this, base::kSection));
        m_layout->insertSpacing(m_layout->count() - 1, base::grid(this, base::kGroup));
        // No stretch factor: Qt would give it its minimum size only.
        m_layout->insertLayout(m_layout->count() - 1, m_more);
    }
    m_more->addWidget(more);
}

void EmptyState::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const int picture = m_picture->isHidden() ? base::em(this, kEmptyPicture_em) + m_layout->spacing() : 0;
    m_picture->setVisible(m_layout->sizeHint().height() + picture <= height());
}

void EmptyState::restyle() {
    m_headline->setFont(base::bold(base::sized(font(), base::kLargeText)));
    const int side = base::em(this, kEmptyPicture_em);
    QPixmap picture(QSize(side, side) * devicePixelRatio());
    picture.setDevicePixelRatio(devicePixelRatio());
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    base::paintIcon(painter, QRectF(0, 0, side, side), m_icon, palette().color(QPalette::PlaceholderText));
    painter.end();
    m_picture->setPixmap(picture);
}

} // namespace teleta::chrome
