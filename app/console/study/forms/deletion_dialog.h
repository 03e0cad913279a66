// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QString>

class QLineEdit;
class QPushButton;

namespace teleta::console {

/// Asks whether to delete a participant, who has to be named once more, and for the reason that is recorded.
/// Thread: GUI; it does not block.
class DeletionDialog : public QDialog {
    Q_OBJECT

public:
    explicit DeletionDialog(const QString& participant, QWidget* parent = nullptr);

    /// May be empty.
    [[nodiscard]] QString reason() const;

private:
    QLineEdit* m_name;
    QLineEdit* m_reason;
    QPushButton* m_delete;
};

} // namespace teleta::console
