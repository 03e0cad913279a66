// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/controls/picture_card.h"

#include "widgets/base/compose.h"
#include "widgets/base/control_painter.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QStyleOption>
#include <QVBoxLayout>

#include <utility>

namespace teleta::base {

PictureCard::PictureCard(QWidget* parent)
    : QWidget(parent)
    , m_picture(new QWidget(this))
    , m_title(new QLabel(this))
    , m_about(new QLabel(this))
    , m_buttons(new QHBoxLayout) {
    m_title->setFont(bold(sized(font(), kTitleText)));
    m_title->setWordWrap(true);
    m_about->setWordWrap(true);
    m_about->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_buttons->addStretch(1);
    m_buttons->setSpacing(grid(this));
    auto* layout = new QVBoxLayout(this);
    const int margin = grid(this, kApart);
    layout->setContentsMargins(margin, margin, margin, margin);
    layout->setSpacing(grid(this, kTight));
    addWidgets(layout, {m_picture, m_title, m_about});
    layout->setStretchFactor(m_about, 1);
    layout->addSpacing(grid(this, kTight));
    layout->addLayout(m_buttons);
    const auto restyle = [this] { setTextColour(m_about, palette().color(QPalette::PlaceholderText)); };
    restyle();
    onChange(this, restyle, {QEvent::PaletteChange});
}

void PictureCard::setPicture(Paint paint) {
    m_paint = std::move(paint);
    update();
}

void PictureCard::setTexts(const QString& title, const QString& about) {
    m_title->setText(title);
    m_about->setText(about);
    setAccessibleName(title);
    for (auto* button : findChildren<QPushButton*>())
        button->setAccessibleDescription(about);
}

QPushButton* PictureCard::addButton(const char* name) {
    auto* button = named<QPushButton>(name, this);
    button->setAutoDefault(true);
    m_buttons->insertWidget(m_buttons->count() - 1, button);
    return button;
}

void PictureCard::setPictureHeight(int height) {
    m_picture->setFixedHeight(height);
}

int PictureCard::leastWidth() const {
    return layout()->minimumSize().width();
}

int PictureCard::textHeight(int width) const {
    const int height = layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width)
                                                     : layout()->totalSizeHint().height();
    return height - m_picture->minimumHeight();
}

void PictureCard::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    QStyleOption option;
    option.initFrom(this);
    ControlPainter flat(painter, option);
    flat.box(QRectF(rect()), palette().color(QPalette::Base), flat.colours().faint, kCardRadius);
    QPainterPath rounded;
    rounded.addRoundedRect(QRectF(m_picture->geometry()), flat.px(kControlRadius), flat.px(kControlRadius));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipPath(rounded);
    painter.fillPath(rounded, palette().color(QPalette::Window));
    if (m_paint)
        m_paint(painter, QRectF(m_picture->geometry()), palette());
}

} // namespace teleta::base
