// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <functional>

class QFileDialog;
class QWidget;

namespace teleta::base {

/// The settings of a file dialog.
struct FileQuestion {
    QString title;
    QStringList filters = {}; ///< in the format of QFileDialog: "Pairs (*.csv)"; empty: all files
    /// Start folder, or as much of it as is there. Empty: that of the last dialog, the documents at first.
    QString folder = {};
    QString suffix = {}; ///< default extension of a new file
    QString name = {};   ///< proposed name of a new file
};

/// Opens a dialog for an existing file and returns at once; chosen is called with the path if the user
/// accepts and the parent still exists. Thread: GUI.
QFileDialog* askToOpen(QWidget* parent, const FileQuestion& question,
                       std::function<void(const QString&)> chosen);
/// The same for an existing folder.
QFileDialog* askForFolder(QWidget* parent, const FileQuestion& question,
                          std::function<void(const QString&)> chosen);
/// The same for several files at once.
QFileDialog* askToOpenSeveral(QWidget* parent, const FileQuestion& question,
                              std::function<void(const QStringList&)> chosen);
/// The same for a new file, or one that the user agrees to replace. With several filters the extension
/// follows the chosen one.
QFileDialog* askToSave(QWidget* parent, const FileQuestion& question,
                       std::function<void(const QString&)> chosen);

} // namespace teleta::base
