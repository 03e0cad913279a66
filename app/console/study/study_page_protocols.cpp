// SPDX-License-Identifier: GPL-3.0-or-later
// Protocols to read and to change.
#include "app/console/study/forms/protocol_dialog.h"
#include "app/console/study/forms/protocol_reading.h"
#include "app/console/study/study_page.h"
#include "widgets/base/background.h"
#include "widgets/base/file_dialog.h"

#include <utility>

namespace teleta::console {

/// Replaces a form that is open.
void StudyPage::showProtocol(const study::Protocol& protocol) {
    for (auto* old : findChildren<ProtocolDialog*>()) {
        if (!old->isVisible()) // closed already
            continue;
        old->whenSettled([this, old, protocol] {
            old->done(QDialog::Rejected);
            showProtocol(protocol);
        });
        return;
    }
    auto* dialog = new ProtocolDialog(protocol, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &ProtocolDialog::openRequested, this, &StudyPage::askForProtocol);
    connect(dialog, &ProtocolDialog::paperRequested, this,
            [this] { withPaper([this](const study::Protocol& paper) { showProtocol(paper); }); });
    connect(dialog, &ProtocolDialog::studyRequested, this,
            [this](const study::Protocol& valid) { askForNewStudy(study::Mode::run, valid); });
    // The form stays open if the new study is cancelled.
    connect(&m_controller, &StudyController::opened, dialog,
            [this, dialog] { dialog->leaveTo(m_controller.overview()->head.protocol); });
    dialog->show();
}

void StudyPage::readProtocol(const study::Protocol& protocol) {
    auto* dialog = new ProtocolReading(protocol, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &ProtocolReading::studyRequested, this,
            [this](const study::Protocol& read) { askForNewStudy(study::Mode::run, read); });
    connect(dialog, &ProtocolReading::changeRequested, this, &StudyPage::showProtocol);
    dialog->show();
}

void StudyPage::withPaper(std::function<void(const study::Protocol&)> use) {
    base::runInBackground(
        this, [] { return study::paperProtocol(); },
        [this, use = std::move(use)](const core::Expected<study::Protocol>& paper) {
            if (paper)
                use(*paper);
            else
                report(tr("The paper's protocol could not be read."), paper.error());
        });
}

void StudyPage::askForProtocol() {
    base::askToOpen(this, {.title = tr("Open a protocol"), .filters = {tr("Protocols (*.toml)")}},
                    [this](const QString& path) { open(path); });
}

} // namespace teleta::console
