// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/forms/deletion_dialog.h"

#include "widgets/base/compose.h"
#include "widgets/base/theme.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace teleta::console {

DeletionDialog::DeletionDialog(const QString& participant, QWidget* parent)
    : QDialog(parent)
    , m_name(base::named<QLineEdit>("name", this))
    , m_reason(base::named<QLineEdit>("reason", this)) {
    setWindowTitle(tr("Delete a participant"));
    setObjectName(QStringLiteral("deletion"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* text =
        new QLabel(tr("All sessions, answers, notes, recordings and exported files of %1 are deleted. "
                      "This cannot be undone. The study records that somebody was deleted, and when. "
                      "Results that were computed before, and copies elsewhere, stay as they are.",
                      "a participant")
                       .arg(participant),
                   this);
    text->setTextFormat(Qt::PlainText);
    text->setWordWrap(true);
    text->setMinimumWidth(base::em(this, 32));
    m_reason->setPlaceholderText(tr("For example: consent withdrawn"));
    m_reason->setToolTip(tr("It is recorded. Write nothing that tells who it was"));
    auto* form = new QFormLayout;
    form->addRow(tr("&Reason"), m_reason);
    form->addRow(tr("&Name of the participant, once more"), m_name);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_delete = buttons->addButton(tr("Delete"), QDialogButtonBox::AcceptRole);
    m_delete->setEnabled(false);
    buttons->button(QDialogButtonBox::Cancel)->setDefault(true);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(text);
    layout->addLayout(form);
    layout->addWidget(buttons);
    connect(m_name, &QLineEdit::textChanged, this, [this, participant](const QString& typed) {
        m_delete->setEnabled(typed.trimmed() == participant.trimmed());
    });
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

QString DeletionDialog::reason() const {
    return m_reason->text().trimmed();
}

} // namespace teleta::console
