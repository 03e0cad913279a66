// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/file_dialog.h"

#include "widgets/base/theme.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QScreen>
#include <QSplitter>
#include <QStandardPaths>
#include <QTreeView>

#include <array>
#include <utility>

namespace teleta::base {

namespace {

constexpr double kPlaces_em = 12.0;
constexpr std::array kColumns_em{24.0, 6.0, 9.0, 12.0}; ///< name, size, type, date
constexpr double kWidth_em = 69.0;
constexpr double kHeight_em = 34.0;

/// Room for the names of recordings, whose beginnings are alike, and for the list of places beside them.
void giveRoom(QFileDialog& dialog) {
    const QSize screen = dialog.screen()->availableSize();
    dialog.resize(QSize(em(&dialog, kWidth_em), em(&dialog, kHeight_em)).boundedTo(0.9 * screen));
    if (auto* files = dialog.findChild<QTreeView*>(QStringLiteral("treeView")))
        for (std::size_t i = 0; i < kColumns_em.size(); ++i)
            files->header()->resizeSection(static_cast<int>(i), em(&dialog, kColumns_em[i]));
    if (auto* split = dialog.findChild<QSplitter*>(QStringLiteral("splitter")))
        split->setSizes({em(&dialog, kPlaces_em), em(&dialog, kWidth_em - kPlaces_em)});
}

/// Of the file or folder that was chosen last; the documents until then.
QString& lastFolder() {
    static QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return folder;
}

/// As much of the folder as is there: Qt takes what is not for the name of a file.
QString existing(const QString& folder) {
    QFileInfo there(folder.isEmpty() ? lastFolder() : folder);
    while (!there.exists() && !there.isRoot())
        there = QFileInfo(there.absolutePath());
    return there.absoluteFilePath();
}

QFileDialog* makeDialog(QWidget* parent, const FileQuestion& question, QFileDialog::FileMode mode) {
    auto* dialog = new QFileDialog(parent, question.title, existing(question.folder));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    if (mode == QFileDialog::Directory)
        dialog->setOption(QFileDialog::ShowDirsOnly);
    else if (!question.filters.isEmpty())
        dialog->setNameFilters(question.filters);
    dialog->setAcceptMode(mode == QFileDialog::AnyFile ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
    dialog->setFileMode(mode);
    giveRoom(*dialog);
    QObject::connect(dialog, &QDialog::accepted, dialog,
                     [dialog] { lastFolder() = dialog->directory().absolutePath(); });
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
