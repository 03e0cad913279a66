// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/message_bar.h"

#include "widgets/base/icons.h"
#include "widgets/base/theme.h"
#include "widgets/chrome/free_corner.h"
#include "widgets/chrome/message_log.h"

#include <QAccessible>
#include <QApplication>
#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QToolButton>

#include <algorithm>

namespace teleta::chrome {

namespace {

/// Wide enough for a sentence, but clear of the controls on the other side of a view.
constexpr double kWidest_em = 44.0;
/// Steps in which the time that notices are seen is counted.
constexpr std::chrono::milliseconds kAgeStep{100};

using Severity = Message::Severity;

QColor severityColour(Severity severity, const QPalette& palette) {
    const base::StatusColours& colours = base::statusColours(palette);
    return severity == Severity::error     ? colours.lost
           : severity == Severity::warning ? colours.stale
                                           : colours.neutral;
}

base::Icon severityIcon(Severity severity) {
    return severity == Severity::error     ? base::Icon::error
           : severity == Severity::warning ? base::Icon::warning
                                           : base::Icon::info;
}

/// A row with a tinted background and a bar in the severity's colour.
class Row : public QFrame {
public:
    Row(Message::Severity severity, QWidget* parent)
        : QFrame(parent)
        , m_severity(severity) {}

protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        QPainter painter(this);
        const QColor colour = severityColour(m_severity, palette());
        painter.fillRect(rect(), base::mixed(palette().color(QPalette::Window), colour, 0.14));
        painter.fillRect(QRect(0, 0, base::grid(this, 0.5), height()), colour);
        painter.fillRect(QRect(0, height() - 1, width(), 1),
                         base::mixed(palette().color(QPalette::Window), colour, 0.4));
    }

private:
    Message::Severity m_severity;
};

/// The symbol before the text, painted so that it follows the palette.
class Sign : public QWidget {
public:
    Sign(Message::Severity severity, QWidget* parent)
        : QWidget(parent)
        , m_severity(severity) {
        const int side = base::em(this, 1.25);
        setFixedSize(side, side);
    }

protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        base::paintIcon(painter, rect(), severityIcon(m_severity), severityColour(m_severity, palette()));
    }

private:
    Message::Severity m_severity;
};

} // namespace

MessageBar::MessageBar(QWidget* parent)
    : QWidget(parent) {
    m_tabStop->setFixedSize(0, 0);
    m_tabStop->setFocusPolicy(Qt::ClickFocus); // without a focus policy Qt does not place others after it
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(1);
    setAutoFillBackground(true);
    if (parent != nullptr)
        parent->installEventFilter(this);
    connect(&m_age, &QTimer::timeout, this, &MessageBar::age);
    rebuild();
}

void MessageBar::post(const Message& message) {
    MessageLog::instance().append(message);
    const auto same = std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry& entry) {
        return entry.message.text == message.text && entry.message.details == message.details;
    });
    if (same != m_entries.end()) {
        ++same->repeats;
        same->seen = {};
        same->message.actions = message.actions;
        std::rotate(same, same + 1, m_entries.end());
    } else {
        if (m_entries.size() == kKept)
            m_entries.erase(m_entries.begin());
        m_entries.push_back({message, QDateTime::currentDateTime(), 1, false, {}});
    }
    rebuild();
    // Screen readers announce new notices.
    QAccessibleEvent alert(m_layout->itemAt(0)->widget(), QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

void MessageBar::clear() {
    m_entries.clear();
    rebuild();
}

void MessageBar::age() {
    const QWidget* focus = QApplication::focusWidget();
    if (!isVisible() || underMouse() || (focus != nullptr && isAncestorOf(focus)))
        return;
    const std::size_t shown = std::min<std::size_t>(m_entries.size(), kShown);
    for (std::size_t back = 0; back < shown; ++back)
        m_entries[m_entries.size() - 1 - back].seen += kAgeStep;
    const auto leaves = [this](const Entry& entry) {
        return entry.message.severity == Severity::information && !entry.open && entry.seen >= m_showing;
    };
    if (std::erase_if(m_entries, leaves) > 0)
        rebuild();
}

void MessageBar::settle() {
    QWidget* view = parentWidget();
    if (view == nullptr)
        return;
    if (view->layout() != nullptr)
        view->layout()->removeWidget(this);
    QRect seen = view->rect();
    if (QWidget* room = view->isWindow() ? nullptr : view->parentWidget()) {
        seen &= room->rect().translated(-view->pos());
        room->installEventFilter(this); // a scrolling view does not resize when more of it becomes visible
    }
    const int width = std::min(seen.width(), base::em(this, kWidest_em));
    const auto heightFor = [this](int wide) {
        return m_layout->hasHeightForWidth() ? m_layout->heightForWidth(wide) : m_layout->sizeHint().height();
    };
    FreeCorner corner = freeCorner(*view, seen, QSize(width, heightFor(width)), *this);
    if (corner.covers && m_reserved == 0) {
        if (const auto place = freePicture(*view, seen, width, heightFor, *this))
            corner = {.place = *place, .covers = false};
    }
    if (m_reserved > 0 || corner.covers) {
        const int lowest = view->layout() != nullptr ? view->layout()->minimumSize().height() : seen.height();
        const int strip = heightFor(seen.width());
        const bool hasRoom = lowest - m_reserved + strip <= seen.height();
        reserve(hasRoom ? strip : 0);
        if (hasRoom)
            corner.place = QRect(seen.left(), seen.bottom() + 1 - strip, seen.width(), strip);
    }
    setGeometry(corner.place);
    raise();
}

void MessageBar::reserve(int height) {
    if (height == m_reserved)
        return;
    QLayout* layout = parentWidget()->layout();
    QMargins margins = layout->contentsMargins();
    margins.setBottom(margins.bottom() - m_reserved + height);
    m_reserved = height;
    layout->setContentsMargins(margins);
}

bool MessageBar::event(QEvent* event) {
    if (event->type() == QEvent::LayoutRequest && isVisible()) {
        settle();
    } else if (event->type() == QEvent::LanguageChange) {
        // They are in the language in which they were said; the log keeps them.
        clear();
    }
    return QWidget::event(event);
}

bool MessageBar::eventFilter(QObject* watched, QEvent* event) {
    const bool isMoved = event->type() == QEvent::Resize || event->type() == QEvent::Move;
    if (isMoved && !isHidden())
        settle();
    return QWidget::eventFilter(watched, event);
}

void MessageBar::rebuild() {
    setAccessibleName(tr("Messages"));
    // The buttons were recreated: the one pressed by a key gets the focus back.
    QString button;
    QString message;
    int place = 0;
    QWidget* focus = QApplication::focusWidget();
    for (int index = 0; focus != nullptr && index < m_layout->count(); ++index) {
        const QWidget* row = m_layout->itemAt(index)->widget();
        if (row->isAncestorOf(focus)) {
            button = focus->objectName();
            message = row->accessibleName();
            place = index;
        }
    }
    while (QLayoutItem* item = m_layout->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater();
        delete item;
    }
    const std::size_t shown = std::min<std::size_t>(m_entries.size(), kShown);
    for (std::size_t back = 0; back < shown; ++back)
        m_layout->addWidget(makeRow(m_entries.size() - 1 - back));
    for (int index = 0; index < m_layout->count(); ++index)
        m_layout->itemAt(index)->widget()->show();
    if (m_entries.size() > shown) {
        auto* more =
            new QLabel(tr("%n older message(s)", nullptr, static_cast<int>(m_entries.size() - shown)), this);
        more->setFont(base::sized(font(), base::kSmallText));
        more->setContentsMargins(base::grid(this, 2), 0, 0, 0);
        m_layout->addWidget(more);
        more->show();
    }
    if (!m_entries.empty())
        settle();
    else if (m_reserved > 0)
        reserve(0);
    setVisible(!m_entries.empty());
    if (shown == 0) {
        m_age.stop();
        return;
    }
    const bool anyLeaves =
        std::any_of(m_entries.end() - static_cast<std::ptrdiff_t>(shown), m_entries.end(),
                    [](const Entry& entry) { return entry.message.severity == Severity::information; });
    if (!anyLeaves)
        m_age.stop();
    else if (!m_age.isActive())
        m_age.start(kAgeStep);
    QWidget* before = m_tabStop;
    QWidget* next = m_layout->itemAt(std::min(place, static_cast<int>(shown) - 1))->widget();
    for (std::size_t index = 0; index < shown; ++index) {
        QWidget* row = m_layout->itemAt(static_cast<int>(index))->widget();
        if (row->accessibleName() == message)
            next = row;
        for (auto* each : row->findChildren<QToolButton*>()) {
            setTabOrder(before, each);
            before = each;
        }
    }
    if (auto* same = button.isEmpty() ? nullptr : next->findChild<QToolButton*>(button))
        same->setFocus(Qt::OtherFocusReason);
}

QWidget* MessageBar::makeRow(std::size_t index) {
    const Entry& entry = m_entries[index];
    auto* row = new Row(entry.message.severity, this);
    row->setObjectName(QStringLiteral("message"));
    auto* line = new QHBoxLayout;
    line->setSpacing(base::grid(this));
    line->addWidget(new Sign(entry.message.severity, row), 0, Qt::AlignTop);

    auto* text = new QLabel(entry.message.text, row);
    text->setTextFormat(Qt::PlainText);
    text->setWordWrap(true);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    text->setFont(base::bold(text->font()));
    line->addWidget(text, 1);

    const QString since = QLocale().toString(entry.since.time(), QLocale::ShortFormat);
    auto* when = new QLabel(
        entry.repeats > 1 ? tr("since %1, %n times", nullptr, entry.repeats).arg(since) : since, row);
    when->setFont(base::sized(font(), base::kSmallText));
    line->addWidget(when, 0, Qt::AlignTop);

    const auto rememberAndRebuild = [this](auto change) {
        return [this, change] {
            change();
            rebuild();
        };
    };
    if (!entry.message.details.isEmpty()) {
        auto* details = new QToolButton(row);
        details->setObjectName(QStringLiteral("details"));
        details->setText(entry.open ? tr("Hide details") : tr("Details"));
        details->setAccessibleDescription(entry.message.text);
        details->setAutoRaise(true);
        connect(details, &QToolButton::clicked, this,
                rememberAndRebuild([this, index] { m_entries[index].open = !m_entries[index].open; }));
        line->addWidget(details, 0, Qt::AlignTop);
    }
    auto* dismiss = new QToolButton(row);
    dismiss->setObjectName(QStringLiteral("dismiss"));
    dismiss->setIcon(base::themeIcon(base::Icon::close));
    dismiss->setAutoRaise(true);
    dismiss->setToolTip(tr("Dismiss"));
    dismiss->setAccessibleName(tr("Dismiss"));
    dismiss->setAccessibleDescription(entry.message.text);
    connect(dismiss, &QToolButton::clicked, this, rememberAndRebuild([this, index] {
                m_entries.erase(m_entries.begin() + static_cast<std::ptrdiff_t>(index));
            }));
    line->addWidget(dismiss, 0, Qt::AlignTop);

    auto* column = new QVBoxLayout(row);
    column->setContentsMargins(base::grid(this, 2), base::grid(this, 0.5), base::grid(this),
                               base::grid(this, 0.5));
    column->setSpacing(base::grid(this, 0.5));
    column->addLayout(line);
    const auto addLine = [&](const QString& content) {
        if (content.isEmpty())
            return;
        auto* label = new QLabel(content, row);
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        label->setContentsMargins(base::em(this, 1.25) + base::grid(this), 0, 0, 0);
        column->addWidget(label);
    };
    addLine(entry.message.advice);
    if (entry.open)
        addLine(entry.message.details);
    if (!entry.message.actions.empty()) {
        auto* actions = new QHBoxLayout;
        actions->setContentsMargins(base::em(this, 1.25) + base::grid(this), 0, 0, 0);
        for (const Message::Action& action : entry.message.actions) {
            auto* button = new QToolButton(row);
            button->setObjectName(QStringLiteral("action"));
            button->setText(action.text);
            button->setAccessibleDescription(entry.message.text);
            connect(button, &QToolButton::clicked, this, [this, index, run = action.run] {
                m_entries.erase(m_entries.begin() + static_cast<std::ptrdiff_t>(index));
                rebuild();
                run();
            });
            actions->addWidget(button);
        }
        actions->addStretch(1);
        column->addLayout(actions);
    }
    row->setAccessibleName(entry.message.text);
    row->setAccessibleDescription(entry.message.advice);
    return row;
}

} // namespace teleta::chrome
