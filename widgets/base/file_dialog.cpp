// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/file_dialog.h"

#include <QFileDialog>

#include <utility>

namespace teleta::base {

namespace {

QFileDialog* makeDialog(QWidget* parent, const FileQuestion& question, QFileDialog::FileMode mode) {
    auto* dialog = new QFileDialog(parent, question.title, question.folder);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    if (mode == QFileDialog::Directory)
        dialog->setOption(QFileDialog::ShowDirsOnly);
    else if (!question.filters.isEmpty())
        dialog->setNameFilters(question.filters);
    dialog->setAcceptMode(mode == QFileDialog::AnyFile ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
    dialog->setFileMode(mode);
    return dialog;
}

QFileDialog* openDialog(QFileDialog* dialog, QWidget* parent, std::function<void(const QString&)> chosen) {
    QObject::connect(dialog, &QFileDialog::fileSelected, parent, std::move(chosen));
    dialog->open();
    return dialog;
}

} // namespace

QFileDialog* askToOpen(QWidget* parent, const FileQuestion& question,
                       std::function<void(const QString&)> chosen) {
    return openDialog(makeDialog(parent, question, QFileDialog::ExistingFile), parent, std::move(chosen));
}

QFileDialog* askForFolder(QWidget* parent, const FileQuestion& question,
                          std::function<void(const QString&)> chosen) {
    return openDialog(makeDialog(parent, question, QFileDialog::Directory), parent, std::move(chosen));
}

QFileDialog* askToOpenSeveral(QWidget* parent, const FileQuestion& question,
                              std::function<void(const QStringList&)> chosen) {
    QFileDialog* dialog = makeDialog(parent, question, QFileDialog::ExistingFiles);
    QObject::connect(dialog, &QFileDialog::filesSelected, parent, std::move(chosen));
    dialog->open();
    return dialog;
}

QFileDialog* askToSave(QWidget* parent, const FileQuestion& question,
                       std::function<void(const QString&)> chosen) {
    QFileDialog* dialog = makeDialog(parent, question, QFileDialog::AnyFile);
    dialog->setDefaultSuffix(question.suffix);
    if (question.filters.size() > 1)
        QObject::connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
            dialog->setDefaultSuffix(filter.section(QLatin1String("*."), 1).chopped(1)); // "SVG (*.svg)"
        });
    if (!question.name.isEmpty())
        dialog->selectFile(question.name);
    return openDialog(dialog, parent, std::move(chosen));
}

} // namespace teleta::base
