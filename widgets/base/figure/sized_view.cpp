// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/figure/sized_view.h"

#include "widgets/base/theme.h"

namespace teleta::base {

SizedView::SizedView(QWidget* parent, QSizeF usual_em, QSizeF smallest_em)
    : QWidget(parent)
    , m_usual_em(usual_em)
    , m_smallest_em(smallest_em) {
}

QSize SizedView::sizeHint() const {
    return m_usual_em.isEmpty() ? QWidget::sizeHint()
                                : QSize(em(this, m_usual_em.width()), em(this, m_usual_em.height()));
}

QSize SizedView::minimumSizeHint() const {
    return m_smallest_em.isEmpty() ? QWidget::minimumSizeHint()
                                   : QSize(em(this, m_smallest_em.width()), em(this, m_smallest_em.height()));
}

} // namespace teleta::base
