// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/on_change.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace teleta::base {

namespace {

class ChangeListener : public QObject {
public:
    ChangeListener(QWidget* widget, std::function<void()> update, std::initializer_list<QEvent::Type> kinds)
        : QObject(widget)
        , m_update(std::move(update))
        , m_kinds(kinds) {
        widget->installEventFilter(this);
    }

    bool eventFilter(QObject* /*watched*/, QEvent* event) override {
        if (std::ranges::find(m_kinds, event->type()) != m_kinds.end())
            m_update();
        return false;
    }

private:
    std::function<void()> m_update;
    std::vector<QEvent::Type> m_kinds;
};

} // namespace

void onChange(QWidget* widget, std::function<void()> update, std::initializer_list<QEvent::Type> kinds) {
    new ChangeListener(widget, std::move(update), kinds);
}

} // namespace teleta::base
