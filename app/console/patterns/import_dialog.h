// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/files/pattern_import.h"

#include <QDialog>
#include <QString>

#include <vector>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;

namespace teleta::console {

/// Lists what a pattern lacks of its file before it is opened, and asks for what the file leaves open: the
/// arm, and the tactors of a single signal. Thread: GUI.
class ImportDialog : public QDialog {
    Q_OBJECT

public:
    ImportDialog(const QString& fileName, const pattern::PatternImport& import, QWidget* parent = nullptr);

    [[nodiscard]] pattern::ImportOptions options() const;
    /// The options differ from those with which the file was read.
    [[nodiscard]] bool isChanged() const;

private:
    void addChoices(const pattern::PatternImport& import);

    pattern::Arm m_readArm;
    std::vector<std::size_t> m_readTactors;
    QComboBox* m_arm = nullptr;        ///< if the file has both arms
    std::vector<QCheckBox*> m_tactors; ///< if the file has one signal
    QDialogButtonBox* m_buttons;
};

} // namespace teleta::console
