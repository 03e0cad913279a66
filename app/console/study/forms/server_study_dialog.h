// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/store/study_connection.h"

#include <QDialog>

class QLabel;
class QLineEdit;
class QPushButton;

namespace teleta::console {

class ServerFields;

/// Asks for a study on a server, and for the local folder of its exports. Thread: GUI; it does not block.
class ServerStudyDialog : public QDialog {
    Q_OBJECT

public:
    /// folder: parent of the studies' folders.
    explicit ServerStudyDialog(const QString& folder, QWidget* parent = nullptr);

    [[nodiscard]] study::StoreLocation location() const;
    [[nodiscard]] ServerFields& server() { return *m_server; }

private:
    void check();

    QString m_parent;
    ServerFields* m_server;
    QLineEdit* m_folder;
    QLabel* m_problem;
    QPushButton* m_open;
    bool m_ownFolder = false; ///< typed, no longer derived from the address
};

} // namespace teleta::console
