// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/forms/server_study_dialog.h"

#include "app/console/study/forms/server_fields.h"
#include "widgets/base/compose.h"
#include "widgets/base/theme.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace teleta::console {

ServerStudyDialog::ServerStudyDialog(const QString& folder, QWidget* parent)
    : QDialog(parent)
    , m_parent(folder)
    , m_server(new ServerFields(this))
    , m_folder(base::named<QLineEdit>("folder", this))
    , m_problem(new QLabel(this)) {
    setWindowTitle(tr("Open a study on a server"));
    setObjectName(QStringLiteral("serverStudy"));
    m_folder->setToolTip(tr("For exports, and for trials while the server is unreachable"));
    m_problem->setWordWrap(true);
    m_problem->setMinimumWidth(base::em(this, 32));
    auto* form = new QFormLayout;
    form->addRow(tr("&Folder on this computer"), m_folder);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_open = buttons->addButton(tr("Open the study"), QDialogButtonBox::AcceptRole);
    m_open->setDefault(true);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_server);
    layout->addLayout(form);
    layout->addWidget(m_problem);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_server, &ServerFields::changed, this, &ServerStudyDialog::check);
    connect(m_folder, &QLineEdit::textEdited, this, [this] { m_ownFolder = true; });
    connect(m_folder, &QLineEdit::textChanged, this, &ServerStudyDialog::check);
    check();
}

study::StoreLocation ServerStudyDialog::location() const {
    return {QDir::cleanPath(m_folder->text().trimmed()).toStdString(), m_server->url()};
}

void ServerStudyDialog::check() {
    if (!m_ownFolder)
        m_folder->setText(QDir(m_parent).filePath(m_server->folderName()));
    QString problem = m_server->problem();
    if (problem.isEmpty() && !QDir::isAbsolutePath(m_folder->text().trimmed()))
        problem = tr("Choose a folder by its full path.");
    m_problem->setText(problem);
    m_open->setEnabled(problem.isEmpty());
}

} // namespace teleta::console
