// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/store/study_store.h"

#include <QDialog>

#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace teleta::console {

class ServerFields;

/// Asks for what a new study is: its protocol, its folder, whether a server keeps it, what it is for, the
/// seed of its orders. Thread: GUI; it does not block.
class NewStudyDialog : public QDialog {
    Q_OBJECT

public:
    /// protocol: what is chosen at first; from: as in offer().
    NewStudyDialog(study::Protocol protocol, const QString& folder, QWidget* parent = nullptr,
                   const QString& from = {});

    /// Another protocol that may be chosen. from: where it is from, shown beside its name; may be empty.
    void offer(study::Protocol protocol, const QString& from);
    /// Reads a protocol file, with the pattern files that it names, and chooses it. Where that fails it is
    /// said, and everything stays as it is.
    void read(const QString& path);
    void setMode(study::Mode mode);
    [[nodiscard]] QString folder() const;
    [[nodiscard]] study::StoreLocation location() const;
    [[nodiscard]] study::StudyHead head() const;

private:
    [[nodiscard]] const study::Protocol& protocol() const;
    void askForProtocol();
    void chooseFolder();
    void check();

    std::vector<study::Protocol> m_protocols; ///< in the order of m_protocol
    QComboBox* m_protocol;
    QLabel* m_trials;
    QString m_refused; ///< why the file that was chosen last is none; empty: it is one
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
