// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/forms/protocol_reading.h"

#include "app/console/study/forms/protocol_summary.h"
#include "widgets/base/compose.h"
#include "widgets/base/theme.h"

#include <QDialogButtonBox>
#include <QEvent>
#include <QPushButton>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace teleta::console {

ProtocolReading::ProtocolReading(const study::Protocol& protocol, QWidget* parent)
    : QDialog(parent)
    , m_protocol(protocol)
    , m_text(base::named<QTextBrowser>("protocolText", this)) {
    setWindowTitle(tr("Protocol"));
    m_text->setHtml(protocolSummary(m_protocol));
    m_text->setFrameShape(QFrame::NoFrame);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto* make = buttons->addButton(tr("Ma&ke a study\u2026"), QDialogButtonBox::ActionRole);
    make->setObjectName(QStringLiteral("makeStudy"));
    make->setDefault(true);
    auto* change = buttons->addButton(tr("Chan&ge a copy\u2026"), QDialogButtonBox::ActionRole);
    change->setObjectName(QStringLiteral("changeProtocol"));
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(make, &QPushButton::clicked, this, [this] {
        emit studyRequested(m_protocol);
        accept();
    });
    connect(change, &QPushButton::clicked, this, [this] {
        emit changeRequested(m_protocol);
        accept();
    });
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_text, 1);
    layout->addWidget(buttons);
    make->setFocus();
    resize(base::em(this, 46), base::em(this, 40));
}

void ProtocolReading::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) // colours are in the text
        m_text->setHtml(protocolSummary(m_protocol));
    QDialog::changeEvent(event);
}

} // namespace teleta::console
