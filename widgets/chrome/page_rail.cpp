// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/page_rail.h"

#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QPainter>
#include <QShortcut>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace teleta::chrome {

namespace {

constexpr double kWidth_em = 5.0;
constexpr double kIcon_em = 1.75;
constexpr double kIconOnly_em = 3.0;

/// A rail button: a bar in the accent colour marks the current page, so that colour is not the only sign.
class RailButton : public QToolButton {
public:
    using QToolButton::QToolButton;

protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        QPainter painter(this);
        const QColor window = palette().color(QPalette::Window);
        const QColor text = palette().color(QPalette::WindowText);
        const QColor accent = palette().color(QPalette::Highlight);
        if (isChecked() || isDown())
            painter.fillRect(rect(), base::mixed(window, accent, 0.18));
        else if (underMouse())
            painter.fillRect(rect(), base::mixed(window, text, 0.08));
        if (isChecked())
            painter.fillRect(QRect(0, 0, base::grid(this, 0.5), height()), accent);

        const int side = base::em(this, kIcon_em);
        const QFontMetrics metrics(font());
        const int gap = base::grid(this, 0.5);
        const bool named = !this->text().isEmpty();
        const int top = (height() - side - (named ? gap + metrics.height() : 0)) / 2;
        icon().paint(&painter, QRect((width() - side) / 2, top, side, side));
        painter.setPen(text);
        painter.drawText(QRect(0, top + side + gap, width(), metrics.height()), Qt::AlignCenter,
                         this->text());
        if (hasFocus()) {
            painter.setPen(QPen(accent, 1, Qt::DotLine));
            painter.drawRect(rect().adjusted(2, 2, -3, -3));
        }
    }
};

} // namespace

PageRail::PageRail(QWidget* parent)
    : QWidget(parent) {
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(0);
    m_layout->addStretch(1);
    m_group->setExclusive(true);
    setAccessibleName(tr("Pages"));
    restyle();
    base::onChange(this, &PageRail::restyle, {QEvent::PaletteChange, QEvent::FontChange});
}

void PageRail::addPage(const QString& name, base::Icon icon, const QString& title, const QString& toolTip) {
    auto* button = new RailButton(this);
    button->setCheckable(true);
    button->setFocusPolicy(Qt::TabFocus);
    m_layout->insertWidget(static_cast<int>(m_pages.size()), button);
    m_group->addButton(button);
    m_pages.push_back({name, icon, title, toolTip, button});
    connect(button, &QToolButton::clicked, this, [this, name] { emit pageRequested(name); });
    const auto number = static_cast<int>(m_pages.size());
    if (number <= 9) {
        auto* shortcut = new QShortcut(QKeySequence(QStringLiteral("Ctrl+%1").arg(number)), this);
        connect(shortcut, &QShortcut::activated, button, &QToolButton::click);
    }
    setTitle(name, title, toolTip);
    if (number == 1)
        button->setChecked(true);
}

void PageRail::setTitle(const QString& name, const QString& title, const QString& toolTip) {
    const auto found =
        std::find_if(m_pages.begin(), m_pages.end(), [&](const Page& page) { return page.name == name; });
    if (found == m_pages.end())
        return;
    found->title = title;
    found->about = toolTip;
    found->button->setAccessibleName(title);
    restyle();
}

void PageRail::setCurrentPage(const QString& name) {
    for (const Page& page : m_pages) {
        if (page.name == name)
            page.button->setChecked(true);
    }
}

void PageRail::setIconsOnly(bool iconsOnly) {
    if (std::exchange(m_iconsOnly, iconsOnly) != iconsOnly)
        restyle();
}

QString PageRail::currentPage() const {
    for (const Page& page : m_pages) {
        if (page.button->isChecked())
            return page.name;
    }
    return {};
}

void PageRail::restyle() {
    // As wide as the longest title needs, in any language.
    int width = base::em(this, m_iconsOnly ? kIconOnly_em : kWidth_em);
    for (const Page& page : m_pages)
        if (!m_iconsOnly)
            width = std::max(width, QFontMetrics(page.button->font()).horizontalAdvance(page.title) +
                                        base::grid(this, 2));
    setFixedWidth(width);
    int number = 0;
    for (const Page& page : m_pages) {
        page.button->setIcon(base::themeIcon(page.icon));
        page.button->setText(m_iconsOnly ? QString() : page.title);
        const QString about =
            tr("%1 (Ctrl+%2)", "tool tip of a page and its shortcut").arg(page.about).arg(++number);
        page.button->setToolTip(m_iconsOnly ? page.title + QLatin1Char('\n') + about : about);
        page.button->setFixedSize(width, base::em(this, m_iconsOnly ? kIconOnly_em : 4.0));
    }
}

} // namespace teleta::chrome
