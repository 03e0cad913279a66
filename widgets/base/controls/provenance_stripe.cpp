// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/controls/provenance_stripe.h"

#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>

namespace teleta::base {

ProvenanceStripe::ProvenanceStripe(QWidget* view)
    : QWidget(view) {
    setObjectName(QStringLiteral("provenance"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_OpaquePaintEvent);
    hide();
    view->installEventFilter(this);
    keepTranslated(this, &ProvenanceStripe::describe);
}

void ProvenanceStripe::setProvenance(Provenance provenance) {
    if (provenance == m_provenance)
        return;
    m_provenance = provenance;
    describe();
    place();
    setVisible(provenance != Provenance::live);
    raise();
    update();
}

void ProvenanceStripe::describe() {
    setAccessibleName(provenanceText(m_provenance));
}

void ProvenanceStripe::place() {
    setGeometry(0, 0, parentWidget()->width(), std::max(2, grid(this, kStripe)));
}

bool ProvenanceStripe::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parent() && event->type() == QEvent::Resize)
        place();
    return QWidget::eventFilter(watched, event);
}

void ProvenanceStripe::paintEvent(QPaintEvent* /*event*/) {
    QPainter(this).fillRect(rect(), provenanceColour(m_provenance, palette()));
}

void showProvenance(QWidget* view, Provenance provenance) {
    auto* stripe = view->findChild<ProvenanceStripe*>(QString(), Qt::FindDirectChildrenOnly);
    if (stripe == nullptr && provenance != Provenance::live)
        stripe = new ProvenanceStripe(view);
    if (stripe != nullptr)
        stripe->setProvenance(provenance);
}

ProvenanceBadge::ProvenanceBadge(QWidget* parent)
    : QWidget(parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    hide();
    keepTranslated(this, &ProvenanceBadge::describe);
    onChange(this, [this] { updateGeometry(); }, {QEvent::FontChange});
}

void ProvenanceBadge::setProvenance(Provenance provenance) {
    if (provenance == m_provenance)
        return;
    m_provenance = provenance;
    describe();
    setVisible(provenance != Provenance::live);
    update();
}

void ProvenanceBadge::describe() {
    setAccessibleName(provenanceText(m_provenance));
    updateGeometry();
    update();
}

QSize ProvenanceBadge::sizeHint() const {
    return badgeSize(font(), provenanceText(m_provenance)).toSize() + QSize(1, 1);
}

void ProvenanceBadge::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    paintBadge(painter, QRectF(rect()), provenanceText(m_provenance),
               provenanceColour(m_provenance, palette()));
}

} // namespace teleta::base
