// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/recording/work_progress.h"

#include <QCoreApplication>
#include <QProgressDialog>

#include <algorithm>
#include <utility>

namespace teleta::console {

namespace {

struct ProgressText {
    Q_DECLARE_TR_FUNCTIONS(WorkProgress)
};

constexpr int kPermille = 1000;

} // namespace

QProgressDialog* progressWindow(const QString& text, std::shared_ptr<WorkProgress> progress,
                                QWidget* window) {
    auto* dialog = new QProgressDialog(text, ProgressText::tr("Cancel"), 0, kPermille, window);
    dialog->setWindowModality(Qt::NonModal);
    dialog->setAutoClose(false);
    dialog->setAutoReset(false);
    QObject::connect(dialog, &QProgressDialog::canceled, dialog,
                     [progress = std::move(progress)] { progress->cancelled = true; });
    dialog->setValue(0);
    return dialog;
}

void showProgress(QProgressDialog& dialog, const WorkProgress& progress) {
    if (!progress.cancelled)
        dialog.setValue(std::clamp(static_cast<int>(progress.share * kPermille), 0, kPermille - 1));
}

} // namespace teleta::console
