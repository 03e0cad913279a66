// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

#include <string>

class QLabel;
class QLineEdit;

namespace teleta::console {

/// Where on a PostgreSQL server a study is: its address, and the password, which is kept nowhere. Thread:
/// GUI.
class ServerFields : public QWidget {
    Q_OBJECT

public:
    explicit ServerFields(QWidget* parent = nullptr);

    void setAddress(const QString& address);
    /// As StoreLocation::server has it, with the password that was typed.
    [[nodiscard]] std::string url() const;
    /// What is wrong with the address; empty: it can be tried.
    [[nodiscard]] QString problem() const;
    /// A name for the folder of its exports: of study, host and database, so that studies of several servers
    /// do not meet in one.
    [[nodiscard]] QString folderName() const;

signals:
    void changed();

private:
    QLineEdit* m_address;
    QLineEdit* m_password;
};

} // namespace teleta::console
