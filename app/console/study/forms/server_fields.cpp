// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/forms/server_fields.h"

#include "widgets/base/compose.h"
#include "widgets/base/theme.h"

#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QStringList>
#include <QUrl>
#include <QUrlQuery>

namespace teleta::console {

ServerFields::ServerFields(QWidget* parent)
    : QWidget(parent)
    , m_address(base::named<QLineEdit>("serverAddress", this))
    , m_password(base::named<QLineEdit>("serverPassword", this)) {
    m_address->setPlaceholderText(QStringLiteral("postgresql://user@host/database?study=name"));
    m_address->setMinimumWidth(base::em(this, 26));
    m_password->setEchoMode(QLineEdit::Password);
    m_password->setPlaceholderText(tr("otherwise PGPASSWORD or ~/.pgpass"));
    m_password->setToolTip(tr("Used for this connection only, never saved"));
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->addRow(tr("&Server"), m_address);
    form->addRow(tr("Pass&word"), m_password);
    connect(m_address, &QLineEdit::textChanged, this, &ServerFields::changed);
    connect(m_password, &QLineEdit::textChanged, this, &ServerFields::changed);
}

void ServerFields::setAddress(const QString& address) {
    m_address->setText(address);
}

std::string ServerFields::url() const {
    QUrl url(m_address->text().trimmed(), QUrl::StrictMode);
    if (!m_password->text().isEmpty())
        url.setPassword(m_password->text(), QUrl::DecodedMode);
    return url.toString(QUrl::FullyEncoded).toStdString();
}

QString ServerFields::problem() const {
    const QUrl url(m_address->text().trimmed(), QUrl::StrictMode);
    const bool isPostgres =
        url.scheme() == QLatin1String("postgresql") || url.scheme() == QLatin1String("postgres");
    if (!url.isValid() || !isPostgres || url.path().size() < 2)
        return tr("The address of a server looks like %1.")
            .arg(QStringLiteral("postgresql://user@host/database?study=name"));
    return {};
}

QString ServerFields::folderName() const {
    const QUrl url(m_address->text().trimmed());
    const QUrlQuery query(url);
    const auto either = [&](const QString& key, const QString& otherwise) {
        const QString value = query.queryItemValue(key, QUrl::FullyDecoded);
        return value.isEmpty() ? otherwise : value;
    };
    QStringList parts{
        either(QStringLiteral("study"), QStringLiteral("study")), either(QStringLiteral("host"), url.host()),
        either(QStringLiteral("port"), url.port() < 0 ? QString() : QString::number(url.port())),
        url.path().mid(1)};
    parts.removeAll(QString());
    QString name = parts.join(QLatin1Char('-'));
    static const QRegularExpression kUnfit(QStringLiteral("[^A-Za-z0-9._-]|^[.]"));
    return name.replace(kUnfit, QStringLiteral("_"));
}

} // namespace teleta::console
