// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/site_keys/site_keys.h"

#include "backend/core/failure.h"
#include "backend/site_keys/certificate.h"
#include "backend/site_keys/signed_document.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLocale>

#include <algorithm>
#include <filesystem>
#include <openssl/crypto.h>
#include <openssl/x509v3.h>
#include <system_error>
#include <utility>

namespace teleta::site_keys {

namespace {

struct KeyText {
    Q_DECLARE_TR_FUNCTIONS(SiteKeys)
};

constexpr std::int64_t kDay_s = 86'400;
constexpr std::int64_t kWarning_s = 14 * kDay_s;

/// One set of keys while it is checked.
class KeyCheck {
public:
    /// onlyMember: the one whose program asks; empty: all.
    KeyCheck(QString folder, std::int64_t now_unixS, QString onlyMember = {})
        : m_folder(std::move(folder))
        , m_onlyMember(std::move(onlyMember))
        , m_now_unixS(now_unixS) {}

    KeyReport run() {
        m_identity = authority(QStringLiteral("identity_ca"));
        m_permissions = authority(QStringLiteral("permissions_ca"));
        if (m_identity && m_permissions &&
            EVP_PKEY_eq(X509_get0_pubkey(m_identity.get()), X509_get0_pubkey(m_permissions.get())) == 1)
            refuse(QStringLiteral("permissions_ca.pem"),
                   KeyText::tr("Both authorities share one key. Anyone with a certificate could sign their "
                               "own permissions."));
        governance();
        if (!m_onlyMember.isEmpty())
            member(m_onlyMember);
        else
            for (const QString& name :
                 QDir(m_folder).entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name))
                member(name);
        compareSites();
        if (m_report.members.empty())
            refuse(QString(), KeyText::tr("There is no folder for a site, a console or a viewer."));
        return std::move(m_report);
    }

private:
    [[nodiscard]] std::string pathOf(const QString& file) const {
        return QFile::encodeName(QDir(m_folder).filePath(file)).toStdString();
    }
    void refuse(const QString& file, const QString& message) {
        m_report.findings.push_back({true, file.toStdString(), message.toStdString()});
    }
    void warn(const QString& file, const QString& message) {
        m_report.findings.push_back({false, file.toStdString(), message.toStdString()});
    }

    Held<X509> certificate(const QString& file) {
        Held<X509> found = readCertificate(pathOf(file));
        if (!found) {
            refuse(file, QFile::exists(QDir(m_folder).filePath(file))
                             ? KeyText::tr("This is not a certificate.")
                             : KeyText::tr("The file is missing."));
            return found;
        }
        const auto begin = beginOf(*found);
        const auto end = endOf(*found);
        if (!begin || !end || m_now_unixS < *begin)
            refuse(file, KeyText::tr("The certificate is not valid yet."));
        else
            ends(file, *end, KeyText::tr("The certificate has expired."),
                 [](const QString& day) { return KeyText::tr("The certificate ends on %1.").arg(day); });
        return found;
    }

    template <class Soon>
    void ends(const QString& file, std::int64_t end_unixS, const QString& over, Soon soon) {
        if (m_now_unixS >= end_unixS)
            refuse(file, over);
        else if (end_unixS - m_now_unixS < kWarning_s)
            warn(file, soon(QLocale().toString(QDateTime::fromSecsSinceEpoch(end_unixS, Qt::UTC).date(),
                                               QLocale::ShortFormat)));
    }

    /// Its certificate, and its private key where that lies in the folder.
    Held<X509> authority(const QString& name) {
        const QString file = name + QStringLiteral(".pem");
        Held<X509> found = certificate(file);
        if (found) {
            constexpr std::uint32_t needed = KU_KEY_CERT_SIGN | KU_DIGITAL_SIGNATURE;
            const std::uint32_t flags = X509_get_extension_flags(found.get());
            if ((flags & EXFLAG_CA) == 0)
                refuse(file, KeyText::tr("This is not a certificate authority (basicConstraints CA:TRUE)."));
            else if ((flags & EXFLAG_KUSAGE) == 0 || (X509_get_key_usage(found.get()) & needed) != needed)
                refuse(file, KeyText::tr("Its key usage lacks digitalSignature or keyCertSign."));
            else if (!verifies(*found, *found))
                refuse(file, KeyText::tr("It is not self-signed."));
        }
        const QString key = name + QStringLiteral("_key.pem");
        if (QFile::exists(QDir(m_folder).filePath(key)))
            privateKey(key, found.get());
        return found;
    }

    void privateKey(const QString& file, X509* certificate) {
        const QFileDevice::Permissions others = QFileDevice::ReadGroup | QFileDevice::WriteGroup |
                                                QFileDevice::ReadOther | QFileDevice::WriteOther;
        if (QFile::permissions(QDir(m_folder).filePath(file)) & others)
            refuse(file, KeyText::tr("Others can read or write this private key (chmod 600)."));
        const Held<EVP_PKEY> key = readKey(pathOf(file));
        if (!key)
            refuse(file, KeyText::tr("This is not a private key without a password."));
        else if (certificate != nullptr && EVP_PKEY_eq(X509_get0_pubkey(certificate), key.get()) != 1)
            refuse(file, KeyText::tr("The key does not belong to the certificate."));
    }

    /// The text that the authority of permissions signed.
    std::optional<std::string> document(const QString& file) {
        if (!QFile::exists(QDir(m_folder).filePath(file))) {
            refuse(file, KeyText::tr("The file is missing."));
            return std::nullopt;
        }
        if (!m_permissions)
            return std::nullopt;
        std::optional<std::string> text = signedText(pathOf(file), *m_permissions);
        if (!text)
            refuse(file, KeyText::tr("It is not signed by permissions_ca.pem itself."));
        return text;
    }

    void governance() {
        const QString file = QStringLiteral("governance.p7s");
        if (const std::optional<std::string> text = document(file))
            for (const std::string& problem : checkGovernance(*text))
                refuse(file, QString::fromStdString(problem));
    }

    void member(const QString& name) {
        const QString file = name + QStringLiteral("/cert.pem");
        KeyMember one;
        one.name = name.toStdString();
        const Held<X509> found = certificate(file);
        if (found) {
            one.subject = subjectOf(*found);
            one.ends_unixS = endOf(*found).value_or(0);
            if (!QString::fromStdString(one.subject)
                     .split(QLatin1Char(','))
                     .contains(QStringLiteral("CN=") + name))
                refuse(file, KeyText::tr("Its subject is %1, the folder is called %2.")
                                 .arg(QString::fromStdString(one.subject), name));
            if (m_identity && !verifies(*found, *m_identity))
                refuse(file, KeyText::tr("It is not signed by identity_ca.pem."));
            if (m_permissions && verifies(*found, *m_permissions))
                refuse(file,
                       KeyText::tr(
                           "It verifies against permissions_ca.pem, so its holder could sign their own "
                           "permissions. That authority must sign nothing but governance and permissions."));
        }
        const QString key = name + QStringLiteral("/key.pem");
        if (QFile::exists(QDir(m_folder).filePath(key)))
            privateKey(key, found.get());
        else if (!m_onlyMember.isEmpty())
            refuse(key, KeyText::tr("The file is missing."));
        else
            warn(key,
                 KeyText::tr("The key is not here. That is fine if it is kept only on its own computer."));
        const QString permissions = name + QStringLiteral("/permissions.p7s");
        if (const std::optional<std::string> text = document(permissions); text && found) {
            const PermissionsCheck check = checkPermissions(*text, one.name, one.subject, m_now_unixS);
            for (const std::string& problem : check.problems)
                refuse(permissions, QString::fromStdString(problem));
            one.role = check.role;
            if (!check.site.empty())
                m_sites.emplace_back(permissions, check.site);
            if (check.ends_unixS != 0) {
                one.ends_unixS = std::min(one.ends_unixS, check.ends_unixS);
                ends(permissions, check.ends_unixS, {},
                     [](const QString& day) { return KeyText::tr("The permissions end on %1.").arg(day); });
            }
        }
        m_report.members.push_back(std::move(one));
    }

    /// All permissions are for one site; the site's own ones say which.
    void compareSites() {
        for (const auto& [file, site] : m_sites)
            if (m_report.site.empty() || file.startsWith(QLatin1String(kSiteMember) + QLatin1Char('/')))
                m_report.site = site;
        for (const auto& [file, site] : m_sites)
            if (site != m_report.site)
                refuse(file,
                       KeyText::tr("Its topics belong to the site %1, those of other permissions to %2.")
                           .arg(QString::fromStdString(site), QString::fromStdString(m_report.site)));
    }

    QString m_folder;
    QString m_onlyMember;
    std::vector<std::pair<QString, std::string>> m_sites; ///< permissions, and whose topics they name
    std::int64_t m_now_unixS;
    KeyReport m_report;
    Held<X509> m_identity;
    Held<X509> m_permissions;
};

core::Expected<QDir> readableFolder(const std::string& folder) {
    const QString path = QString::fromStdString(folder);
    const QDir found(path);
    // One above it may be closed to this user.
    std::error_code hidden;
    if (!std::filesystem::exists(folder, hidden) && !hidden)
        return core::failed(core::ErrorKind::notFound, KeyText::tr("There is no folder %1.").arg(path));
    if (hidden || !found.isReadable())
        return core::failed(core::ErrorKind::ioFailed,
                            KeyText::tr("The folder %1 cannot be read.").arg(path));
    return found;
}

} // namespace

bool KeyReport::usable() const {
    return std::none_of(findings.begin(), findings.end(), [](const KeyFinding& one) { return one.refused; });
}

core::Expected<KeyReport> checkKeys(const std::string& folder, std::int64_t now_unixS) {
    TELETA_TRY(const QDir keys, readableFolder(folder));
    return KeyCheck(keys.path(), now_unixS).run();
}

core::Expected<KeyReport> checkMember(const std::string& folder, std::int64_t now_unixS) {
    // Who takes part in a secured domain has threads that decrypt until the very end of the program: the
    // library must not clear itself away in exit(). It decides so when it is used first.
    (void)OPENSSL_init_crypto(OPENSSL_INIT_NO_ATEXIT, nullptr);
    TELETA_TRY(const QDir member, readableFolder(folder));
    // Not only "keys/console1", but also "keys/console1/" and ".".
    const QDir named(QDir::cleanPath(member.absolutePath()));
    return KeyCheck(QFileInfo(named.path()).path(), now_unixS, named.dirName()).run();
}

} // namespace teleta::site_keys
