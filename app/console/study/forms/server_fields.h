// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

#include <string>

class QLineEdit;

namespace teleta::console {

/// Address of a study on a PostgreSQL server, and the password, which is never saved. Thread: GUI.
class ServerFields : public QWidget {
    Q_OBJECT

public:
    explicit ServerFields(QWidget* parent = nullptr);

    void setAddress(const QString& address);
    /// As StoreLocation::server, including the typed password.
    [[nodiscard]] std::string url() const;
    /// What is wrong with the address; empty: nothing.
    [[nodiscard]] QString problem() const;
    /// A folder name for exports, from study, host and database, unique across servers.
    [[nodiscard]] QString folderName() const;

signals:
    void changed();

private:
    QLineEdit* m_address;
    QLineEdit* m_password;
};

} // namespace teleta::console
