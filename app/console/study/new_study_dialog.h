// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/study_store.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace teleta::console {

class ServerFields;

/// Asks for what a new study is: its folder, whether a server keeps it, what it is for, the seed of its
/// orders. Thread: GUI; it does not block.
class NewStudyDialog : public QDialog {
    Q_OBJECT

public:
    NewStudyDialog(study::Protocol protocol, const QString& folder, QWidget* parent = nullptr);

    void setMode(study::Mode mode);
    [[nodiscard]] QString folder() const;
    [[nodiscard]] study::StoreLocation location() const;
    [[nodiscard]] study::StudyHead head() const;

private:
    void chooseFolder();
    void check();

    study::Protocol m_protocol;
    QLineEdit* m_folder;
    QComboBox* m_store;
    ServerFields* m_server;
    QComboBox* m_mode;
    QLineEdit* m_seed;
    QSpinBox* m_participants;
    QLabel* m_participantsLabel;
    QLabel* m_problem;
    QPushButton* m_make;
};

} // namespace teleta::console
