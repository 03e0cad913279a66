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

/// Asks for the properties of a new study: protocol, folder, storage, mode, seed. Thread: GUI; it does not
/// block.
class NewStudyDialog : public QDialog {
    Q_OBJECT

public:
    /// protocol: selected at first; from: as in offer().
    NewStudyDialog(study::Protocol protocol, const QString& folder, QWidget* parent = nullptr,
                   const QString& from = {});

    /// Adds a protocol to choose from. from: its origin, shown next to its name; may be empty.
    void offer(study::Protocol protocol, const QString& from);
    /// Reads a protocol file, with the pattern files that it names, and selects it. A failure is shown and
    /// changes nothing.
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
    QString m_refused; ///< why the last chosen file was rejected; empty: it was not
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
